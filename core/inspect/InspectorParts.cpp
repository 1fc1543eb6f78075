#include "core/inspect/InspectorParts.h"

#include "core/settings/Parameters.h"

#include <algorithm>
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

bool InspectedShot::Parts::isExact() const {
  return std::ranges::all_of(shown.lanes, &ShownLane::exact);
}

std::vector<IntermediateId> InspectedShot::Parts::watched() const {
  std::vector<IntermediateId> all = maker.watched;
  all.insert(all.end(), watchedOfReference.begin(), watchedOfReference.end());
  return all;
}

void InspectedShot::Parts::show(ShownFrame&& next) {
  std::swap(shown, next);
  maker.recycle(std::move(next));
}

// The histories of the frame on show are checkpoints, whatever else was given up meanwhile.
void InspectedShot::Parts::keepShown() {
  for (std::size_t index = 0; index < shown.lanes.size(); ++index) {
    const ShownLane& lane = shown.lanes[index];
    if (!lane.exact) continue;
    checkpoints[index].keep(shown.frame, lane.current);
    if (lane.previous) checkpoints[index].keep(shown.frame - 1, lane.previous);
  }
}

void InspectedShot::Parts::trimCheckpoints() {
  for (std::size_t lane = 0; lane < checkpoints.size(); ++lane)
    checkpoints[lane].trim(checkpointShare(subject, lane, budget), shown.frame, subject.shot());
}

void InspectedShot::Parts::goTo(int frame, const Progress& progress) {
  try {
    show(maker.replay(subject, checkpoints, frame, budget, progress));
  } catch (...) {
    keepShown();
    throw;
  }
}

void InspectedShot::Parts::startAnew(Subject next, std::vector<Checkpoints> kept, int frame) {
  ShownFrame made = maker.replay(next, kept, frame, budget, {});
  subject = std::move(next);
  checkpoints = std::move(kept);
  aside.clear();
  show(std::move(made));
  trimCheckpoints(); // shares change with the lanes
}

FrameStep InspectedShot::Parts::stepOfRedraw(const Subject& next, const std::vector<bool>& changed,
                                             bool keepsHistory) const {
  const bool isSameView = next.camera == subject.camera && next.width == subject.width &&
                          next.height == subject.height && next.motionModes == subject.motionModes &&
                          next.filter == subject.filter && next.objectClasses == subject.objectClasses &&
                          next.restarts == subject.restarts && next.track() == subject.track();
  FrameStep step{.frame = shown.frame, .previous = {}, .active = changed, .inputs = {}};
  for (std::size_t index = 0; index < changed.size(); ++index) {
    const ShownLane& lane = shown.lanes[index];
    const bool drawsSame = isSameView && sameInputs(next.lanes[index], subject.lanes[index]);
    step.previous.push_back(keepsHistory ? lane.previous : nullptr);
    step.inputs.push_back(drawsSame ? lane.inputs : nullptr);
    if (drawsSame && changesOutputOnly(next.lanes[index], subject.lanes[index])) step.active[index] = false;
  }
  return step;
}

void InspectedShot::Parts::redraw(Subject next, const std::vector<bool>& changed, bool keepsHistory) {
  if (!isOpen()) {
    subject = std::move(next);
    return;
  }
  ShownFrame made = maker.take();
  const FrameStep step = stepOfRedraw(next, changed, keepsHistory);
  maker.make(next, step, made);
  for (std::size_t index = 0; index < changed.size(); ++index) {
    ShownLane& lane = made.lanes[index];
    if (step.active[index]) {
      lane.exact = startsHistory(next, made.frame);
      checkpoints[index].clear();
      continue;
    }
    std::swap(lane, shown.lanes[index]);
    if (!changed[index]) continue;
    lane.isExposed = false;
    lane.asked.reset();
  }
  subject = std::move(next);
  aside.clear();
  show(std::move(made));
  keepShown();
  trimCheckpoints();
}

void InspectedShot::Parts::follow(Subject next, int from, bool keepsOld) {
  const auto drop = [&] {
    for (Checkpoints& kept : checkpoints) kept.dropFrom(from);
  };
  if (from > shown.frame) { // nothing of it is on show
    subject = std::move(next);
    return drop();
  }
  const bool isPastSame = from == shown.frame;
  ShownFrame made = maker.take();
  const std::vector<bool> all(next.lanes.size(), true);
  FrameStep step = stepOfRedraw(next, all, isPastSame || keepsOld);
  for (std::size_t lane = 0; lane < all.size(); ++lane) // it may have started a history until now
    if (isPastSame && !step.previous[lane]) step.previous[lane] = checkpoints[lane].at(from - 1);
  maker.make(next, step, made);
  for (std::size_t lane = 0; lane < all.size(); ++lane)
    made.lanes[lane].exact = startsHistory(next, made.frame) ||
                             (isPastSame && shown.lanes[lane].exact && step.previous[lane] != nullptr);
  drop();
  subject = std::move(next);
  show(std::move(made));
  keepShown();
}

// Some drivers compile a program only when something is drawn with it, for just these targets.
void InspectedShot::Parts::prepare(const Settings& settings, std::size_t lane) {
  const Settings& present = subject.lanes[lane];
  if (!sameInputs(settings, present)) return;
  Subject next = subject;
  next.lanes[lane] = settings;
  std::vector<bool> changed(next.lanes.size(), false);
  changed[lane] = true;
  FrameStep step = stepOfRedraw(next, changed, true);
  for (const bool exposes : {true, false}) { // as it is shown at once, and as it is replayed
    step.exposes = exposes;
    const auto rows = exposes ? maker.exposedRows(settings) : std::vector<IntermediateId>();
    if (maker.pass.isPrepared(settings, rows)) continue;
    ShownFrame made = maker.take();
    maker.make(next, step, made);
    maker.recycle(std::move(made));
  }
}

// New ones are made beside the old; the renderer, which keeps its own old ones on error, comes last.
void InspectedShot::Parts::reloadShaders() {
  TaaPass pass;
  for (const Settings& settings : subject.lanes) pass.prepare(settings, maker.exposedRows(settings));
  Visualizer fresh = visualizer.reloaded();
  if (isOpen()) subject.renderer->reloadShaders();
  maker.pass = std::move(pass);
  visualizer = std::move(fresh);
  for (ShownLane& lane : shown.lanes) lane.inputs->areDrawn = false; // with the old ones
  redraw(subject, std::vector<bool>(subject.lanes.size(), true), true);
  forgetReferences(); // drawn with the old ones
}

} // namespace taa
