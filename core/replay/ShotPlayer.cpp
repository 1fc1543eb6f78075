#include "core/replay/ShotPlayer.h"

#include "core/settings/Parameters.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

namespace {

// What is shown of the resolved picture is no part of the history.
bool changesOutputOnly(const Settings& settings, const Settings& old) {
  Settings same = settings;
  same.output = old.output;
  return !(settings == old) && same == old;
}

} // namespace

ShotPlayer::ShotPlayer(const glm::ivec2& picturePx) {
  state_.width = picturePx.x;
  state_.height = picturePx.y;
}

ShotState ShotPlayer::onlyLane(int lane) const {
  ShotState only = state_;
  only.lanes = {settings(lane)};
  return only;
}

void ShotPlayer::watch(const std::vector<IntermediateId>& ids) {
  std::vector<IntermediateId> ofResolve, ofReference;
  for (const IntermediateId id : ids) {
    std::vector<IntermediateId>& once = isOfReference(id) ? ofReference : ofResolve;
    if (std::ranges::find(once, id) == once.end()) once.push_back(id);
  }
  maker_.watched = std::move(ofResolve);
  watchedOfReference_ = std::move(ofReference);
}

std::vector<IntermediateId> ShotPlayer::watched() const {
  std::vector<IntermediateId> all = maker_.watched;
  all.insert(all.end(), watchedOfReference_.begin(), watchedOfReference_.end());
  return all;
}

bool ShotPlayer::isExact() const {
  return std::ranges::all_of(shown_.lanes, &ShownLane::exact);
}

const FrameInputs& ShotPlayer::inputs(int lane) {
  return maker_.inputs(state_, shown_, static_cast<std::size_t>(lane));
}

ResolvedFrame ShotPlayer::resolved(int lane) {
  const ShownLane& shown = this->lane(lane);
  return {inputs(lane), shown.previous, shown.current, settings(lane)};
}

const ExposedRows& ShotPlayer::exposed(IntermediateId id, int lane) {
  return maker_.exposed(state_, shown_, id, lane);
}

void ShotPlayer::show(ShownFrame&& next) {
  std::swap(shown_, next);
  maker_.recycle(std::move(next));
}

// The histories of the frame on show are checkpoints, whatever else was given up meanwhile.
void ShotPlayer::keepShown() {
  for (std::size_t index = 0; index < shown_.lanes.size(); ++index) {
    const ShownLane& lane = shown_.lanes[index];
    if (!lane.exact) continue;
    checkpoints_[index].keep(shown_.frame, lane.current);
    if (lane.previous) checkpoints_[index].keep(shown_.frame - 1, lane.previous);
  }
}

void ShotPlayer::trimCheckpoints() {
  for (std::size_t lane = 0; lane < checkpoints_.size(); ++lane)
    checkpoints_[lane].trim(checkpointShare(state_, lane, budget_), shown_.frame, state_.shot());
}

void ShotPlayer::goTo(int frame, const Progress& progress) {
  try {
    show(maker_.replay(state_, checkpoints_, frame, budget_, progress));
  } catch (...) {
    keepShown();
    throw;
  }
}

void ShotPlayer::advance() {
  const std::size_t lanes = state_.lanes.size();
  FrameStep step{
      .frame = shown_.frame + 1, .previous = {}, .active = std::vector<bool>(lanes, true), .inputs = {}};
  for (const ShownLane& lane : shown_.lanes) step.previous.push_back(lane.current);
  ShownFrame next = maker_.take();
  maker_.make(state_, step, next);
  for (std::size_t lane = 0; lane < lanes; ++lane)
    next.lanes[lane].exact = shown_.lanes[lane].exact || startsHistory(state_, step.frame);
  show(std::move(next));
  keepShown();
  trimCheckpoints();
}

void ShotPlayer::setBudget(std::size_t bytes) {
  budget_ = bytes;
  if (isOpen()) trimCheckpoints();
}

void ShotPlayer::keepComparisonFrames(const std::vector<int>& frames, const Progress& progress) {
  std::erase_if(comparisonFrames_, [&](const ShownFrame& kept) {
    return std::ranges::find(frames, kept.frame) == frames.end();
  });
  for (const int frame : frames) {
    assert(frame >= 0 && frame < state_.scene->shot.frames);
    if (find(frame)) continue;
    try {
      comparisonFrames_.push_back(maker_.replay(state_, checkpoints_, frame, budget_, progress));
    } catch (...) {
      keepShown();
      throw;
    }
    keepShown();
  }
}

ShownFrame* ShotPlayer::find(const std::optional<int>& frame) {
  if (!frame || *frame == shown_.frame) return &shown_;
  const auto found = std::ranges::find(comparisonFrames_, *frame, &ShownFrame::frame);
  return found == comparisonFrames_.end() ? nullptr : &*found;
}

// Without anything exposed.
ShownFrame ShotPlayer::replayed(const ShotState& state, std::vector<Checkpoints>& kept, int frame,
                                std::size_t budget, const Progress& progress) {
  const auto watched = std::exchange(maker_.watched, {});
  try {
    ShownFrame made = maker_.replay(state, kept, frame, budget, progress);
    maker_.watched = watched;
    return made;
  } catch (...) {
    maker_.watched = watched;
    throw;
  }
}

// Checkpoints are only lent: the frames around the one on show stay kept, and of those on the way only the
// last, which the next frame goes on from.
ShownFrame ShotPlayer::makeInBackground(int frame, TraceCursor& cursor, const Progress& progress, int lane) {
  std::vector<Checkpoints> kept(1);
  kept[0] = checkpoints_[static_cast<std::size_t>(lane)];
  if (cursor.history) kept[0].keep(cursor.frame, cursor.history);
  ShownFrame made = replayed(onlyLane(lane), kept, frame, 0, progress);
  cursor = {frame, made.lanes[0].current};
  return made;
}

ShownFrame ShotPlayer::makeInBackground(int frame, Checkpoints& kept, const Progress& progress, int lane) {
  std::vector<Checkpoints> all{kept};
  all[0].keepAll(checkpoints_[static_cast<std::size_t>(lane)]);
  ShownFrame made = replayed(onlyLane(lane), all, frame, budget_ / 2, progress);
  kept = std::move(all[0]);
  return made;
}

ShownFrame ShotPlayer::makeInBackground(int frame, const std::vector<Settings>& lanes,
                                        std::vector<Checkpoints>& kept, const Progress& progress) {
  ShotState state = state_;
  state.lanes = lanes;
  return replayed(state, kept, frame, 0, progress);
}

void ShotPlayer::open(ShotState next) {
  startAnew(std::move(next), std::vector<Checkpoints>(state_.lanes.size()), 0);
}

void ShotPlayer::setLanes(const std::vector<Settings>& lanes) {
  ShotState next = state_;
  next.lanes = lanes;
  std::vector<Checkpoints> kept(lanes.size());
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    for (std::size_t old = 0; old < state_.lanes.size(); ++old)
      if (lanes[lane] == state_.lanes[old]) kept[lane] = checkpoints_[old];
  if (isOpen()) {
    startAnew(std::move(next), std::move(kept), shown_.frame);
    return;
  }
  state_ = std::move(next);
  checkpoints_ = std::move(kept);
}

void ShotPlayer::changeLanes(const std::vector<Settings>& lanes) {
  const std::size_t old = state_.lanes.size();
  const auto resize = [&](std::size_t count) {
    state_.lanes.resize(count, lanes.back());
    checkpoints_.resize(count);
    shown_.lanes.resize(count);
    comparisonFrames_.clear();
  };
  std::vector<bool> changed(lanes.size(), false);
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    changed[lane] = lane >= old || !(lanes[lane] == state_.lanes[lane]);
  resize(lanes.size());
  if (std::ranges::none_of(changed, [](bool is) { return is; })) return;
  try {
    ShotState next = state_;
    next.lanes = lanes;
    redraw(std::move(next), changed, true);
  } catch (...) {
    resize(std::min(old, lanes.size()));
    throw;
  }
}

// Another source or other lanes: all is made first, then put in place of what there was.
void ShotPlayer::startAnew(ShotState next, std::vector<Checkpoints> kept, int frame) {
  ShownFrame made = maker_.replay(next, kept, frame, budget_, {});
  state_ = std::move(next);
  checkpoints_ = std::move(kept);
  comparisonFrames_.clear();
  show(std::move(made));
  trimCheckpoints(); // shares change with the lanes
}

FrameStep ShotPlayer::stepOfRedraw(const ShotState& next, const std::vector<bool>& changed,
                                   bool keepsHistory) const {
  const bool isSameView = next.camera == state_.camera && next.width == state_.width &&
                          next.height == state_.height && next.motionModes == state_.motionModes &&
                          next.filter == state_.filter && next.objectClasses == state_.objectClasses &&
                          next.restarts == state_.restarts && next.track() == state_.track();
  FrameStep step{.frame = shown_.frame, .previous = {}, .active = changed, .inputs = {}};
  for (std::size_t index = 0; index < changed.size(); ++index) {
    const ShownLane& lane = shown_.lanes[index];
    const bool drawsSame = isSameView && sameInputs(next.lanes[index], state_.lanes[index]);
    step.previous.push_back(keepsHistory ? lane.previous : nullptr);
    step.inputs.push_back(drawsSame ? lane.inputs : nullptr);
    if (drawsSame && changesOutputOnly(next.lanes[index], state_.lanes[index])) step.active[index] = false;
  }
  return step;
}

void ShotPlayer::redraw(ShotState next, const std::vector<bool>& changed, bool keepsHistory) {
  if (!isOpen()) {
    state_ = std::move(next);
    return;
  }
  ShownFrame made = maker_.take();
  const FrameStep step = stepOfRedraw(next, changed, keepsHistory);
  maker_.make(next, step, made);
  for (std::size_t index = 0; index < changed.size(); ++index) {
    ShownLane& lane = made.lanes[index];
    if (step.active[index]) {
      lane.exact = startsHistory(next, made.frame);
      checkpoints_[index].clear();
      continue;
    }
    std::swap(lane, shown_.lanes[index]);
    if (!changed[index]) continue;
    lane.isExposed = false;
    lane.asked.reset();
  }
  state_ = std::move(next);
  comparisonFrames_.clear();
  show(std::move(made));
  keepShown();
  trimCheckpoints();
}

void ShotPlayer::redrawAll(ShotState next, bool keepsHistory) {
  const std::vector<bool> all(next.lanes.size(), true);
  redraw(std::move(next), all, keepsHistory);
}

void ShotPlayer::follow(ShotState next, int from, bool keepsOld) {
  const auto drop = [&] {
    for (Checkpoints& kept : checkpoints_) kept.dropFrom(from);
    std::erase_if(comparisonFrames_, [from](const ShownFrame& kept) { return kept.frame >= from; });
  };
  if (from > shown_.frame) { // nothing of it is on show
    state_ = std::move(next);
    drop();
    return;
  }
  const bool isPastSame = from == shown_.frame;
  ShownFrame made = maker_.take();
  const std::vector<bool> all(next.lanes.size(), true);
  FrameStep step = stepOfRedraw(next, all, isPastSame || keepsOld);
  for (std::size_t lane = 0; lane < all.size(); ++lane) // it may have started a history until now
    if (isPastSame && !step.previous[lane]) step.previous[lane] = checkpoints_[lane].at(from - 1);
  maker_.make(next, step, made);
  for (std::size_t lane = 0; lane < all.size(); ++lane)
    made.lanes[lane].exact = startsHistory(next, made.frame) ||
                             (isPastSame && shown_.lanes[lane].exact && step.previous[lane] != nullptr);
  drop();
  state_ = std::move(next);
  show(std::move(made));
  keepShown();
}

// Some drivers compile a program only when something is drawn with it, for just these targets.
void ShotPlayer::prepare(const Settings& settings, int lane) {
  const auto index = static_cast<std::size_t>(lane);
  if (!sameInputs(settings, this->settings(lane))) return;
  ShotState next = state_;
  next.lanes[index] = settings;
  std::vector<bool> changed(next.lanes.size(), false);
  changed[index] = true;
  FrameStep step = stepOfRedraw(next, changed, true);
  for (const bool exposes : {true, false}) { // as it is shown at once, and as it is replayed
    step.exposes = exposes;
    const auto rows = exposes ? maker_.rowsToExpose(settings) : std::vector<IntermediateId>();
    if (maker_.pass.isPrepared(settings, rows)) continue;
    ShownFrame made = maker_.take();
    maker_.make(next, step, made);
    maker_.recycle(std::move(made));
  }
}

// A new pass is made beside the old; the source, which keeps its own old shaders on error, comes last.
void ShotPlayer::reloadShaders() {
  TaaPass pass;
  for (const Settings& settings : state_.lanes) pass.prepare(settings, maker_.rowsToExpose(settings));
  if (isOpen()) state_.frames->reloadShaders();
  maker_.pass = std::move(pass);
  maker_.keptInputs.clear();
  for (ShownLane& lane : shown_.lanes) lane.inputs->areDrawn = false; // with the old ones
  redrawAll(state_, true);
}

} // namespace taa
