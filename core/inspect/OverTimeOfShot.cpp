#include "core/inspect/OverTimeOfShot.h"

#include "core/base/Say.h"
#include "core/gl/PassTimer.h"
#include "core/inspect/MemoryNeed.h"
#include "core/measure/Metrics.h"
#include "core/measure/Profiler.h"
#include "core/measure/References.h"
#include "core/measure/compare/GhostEnergy.h"
#include "core/replay/ShotPlayer.h"
#include "core/settings/Parameters.h"
#include "core/verdict/parts/PartsRows.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string_view>
#include <utility>

namespace taa {

namespace {

RowImages imagesOf(const ExposedRows& exposedRows, const std::vector<IntermediateId>& ids) {
  RowImages images;
  for (const IntermediateId id : ids) images.emplace(id, exposedRows.image(id));
  return images;
}

// Without a frame before there is no ghost.
Image ghostRow(const FrameWindow& window, int first, int last, const Image& historyPosition) {
  const FlickerFrame& now = window.frames.at(last).flicker;
  if (first == last) return {now.shown.width, now.shown.height, 1};
  return ghostMap({now.shown, now.reference, window.frames.at(last - 1).flicker.shown, historyPosition});
}

RowImages flickerRows(const FrameWindow& window, int first, int last, const RowImages& resolve,
                      const Progress& progress) {
  std::vector<const FlickerFrame*> newestFirst;
  for (int frame = last; frame >= first; --frame) newestFirst.push_back(&window.frames.at(frame).flicker);
  FlickerMaps maps = flickerMaps(newestFirst, progress);
  RowImages rows;
  if (!maps.flicker.empty()) {
    rows.emplace(IntermediateId::flicker, std::move(maps.flicker));
    rows.emplace(IntermediateId::ghost,
                 ghostRow(window, first, last, resolve.at(IntermediateId::historyPosition)));
  }
  rows.emplace(IntermediateId::deviationOverTime, std::move(maps.deviation));
  rows.emplace(IntermediateId::framesFollowed, std::move(maps.frames));
  return rows;
}

// All frames are made: this is the end of it.
Progress toldAtTheEnd(const Progress& progress, int frames) {
  return [&progress, frames](std::string_view what, int, int) {
    return !progress || progress(what, frames, frames);
  };
}

} // namespace

bool OverTimeNeed::has(OverTime kind) const {
  return std::ranges::find(kinds, kind) != kinds.end();
}

OverTimeOfShot::OverTimeOfShot(ShotPlayer& player, References& references, const gl::Driver& driver)
    : player_(player), references_(references), driver_(driver) {}

OverTimeKey OverTimeOfShot::keyOf(int lane) const {
  return {player_.state().request(static_cast<std::size_t>(lane)), player_.settings(lane)};
}

// Forgets what is of another key.
OverTimeOfShot::Measured& OverTimeOfShot::measuredOf(int lane) {
  Measured& measured = lanes_.at(static_cast<std::size_t>(lane));
  OverTimeKey key = keyOf(lane);
  if (!(measured.key == key)) {
    measured = {};
    measured.key = std::move(key);
  }
  return measured;
}

int OverTimeOfShot::firstFrame(int last) const {
  int first = last;
  while (last - first + 1 < frames_ && !startsHistory(player_.state(), first)) --first;
  return first;
}

// The last frame's are always made: what its verdicts take is not kept.
bool OverTimeOfShot::lacksErrors(const FrameWindow& window, const OverTimeNeed& need, int frame) const {
  if (!need.has(OverTime::Parts)) return false;
  const FrameOverTime& entry = window.frames.at(frame);
  const bool isRead = frame > firstFrame(need.last);
  return frame == need.last || entry.errorSamples != need.samples || (isRead && !entry.errors.hasHistory());
}

std::vector<IntermediateId> OverTimeOfShot::missingRows(const FrameWindow& window, const OverTimeNeed& need,
                                                        int frame) const {
  std::vector<IntermediateId> ids;
  if (lacksErrors(window, need, frame)) ids = rowsOfErrors(player_.settings(need.lane));
  if (need.has(OverTime::Flicker) && window.frames.at(frame).flicker.shown.empty())
    ids.push_back(IntermediateId::output);
  return ids;
}

std::vector<IntermediateId> OverTimeOfShot::rowsOfLast(const OverTimeNeed& need) const {
  std::vector<IntermediateId> ids;
  if (need.has(OverTime::Flicker)) ids = {IntermediateId::historyPosition, IntermediateId::output};
  if (!need.has(OverTime::Parts)) return ids;
  for (const std::vector<IntermediateId>& rows :
       {rowsOfErrors(player_.settings(need.lane)), rowsOfVerdicts()})
    ids.insert(ids.end(), rows.begin(), rows.end());
  return inTableOrder(std::move(ids));
}

// Of any frame, from a background replay.
RowImages OverTimeOfShot::resolveOf(int frame, const std::vector<IntermediateId>& ids, TraceCursor& cursor,
                                    const Progress& progress, int lane) {
  const gl::PassGroup group(pass_group::kExposure);
  FrameMaker& maker = player_.maker();
  ShownFrame made = player_.makeInBackground(frame, cursor, progress, lane);
  RowImages images = imagesOf(maker.expose(player_.onlyLane(lane), made, ids, 0), ids);
  maker.recycle(std::move(made));
  return images;
}

// The frame on show is at hand where it is exact.
RowImages OverTimeOfShot::resolveNow(const std::vector<IntermediateId>& ids, TraceCursor& cursor,
                                     const Progress& progress, int lane) {
  if (!player_.lane(lane).exact) return resolveOf(player_.shown().frame, ids, cursor, progress, lane);
  const gl::PassGroup group(pass_group::kExposure);
  return imagesOf(player_.maker().exposedAll(player_.state(), player_.shown(), ids, lane), ids);
}

// Lanes that differ in the resolve alone have the same surfaces and references.
const FlickerFrame* OverTimeOfShot::madeOfOtherLane(const FrameWindow& window, const FrameRequest& truth,
                                                    int frame) const {
  for (const Measured& measured : lanes_) {
    const auto found = measured.window.frames.find(frame);
    if (&measured.window != &window && found != measured.window.frames.end() &&
        referenceRequest(measured.key.request) == truth)
      return &found->second.flicker;
  }
  return nullptr;
}

void OverTimeOfShot::fillSteps(FrameWindow& window, const OverTimeNeed& need, int frame) {
  Image& steps = window.frames.at(frame).flicker.steps;
  if (!steps.empty()) return;
  const ShotState only = player_.onlyLane(need.lane);
  const FlickerFrame* known = madeOfOtherLane(window, referenceRequest(only.request(0)), frame);
  if (known && !known->steps.empty()) {
    steps = known->steps;
    return;
  }
  const gl::PassGroup group(pass_group::kReference);
  steps = drawSteps(*only.frames, only.request(0), frame, window.seen);
}

void OverTimeOfShot::fillReference(FrameWindow& window, References& drawn, const OverTimeNeed& need,
                                   int frame, const Progress& progress) {
  FlickerFrame& flicker = window.frames.at(frame).flicker;
  const bool isShown = need.has(OverTime::Flicker) && flicker.referenceSamples != need.samples;
  const bool isCompared =
      lacksErrors(window, need, frame) || (frame < need.last && lacksErrors(window, need, frame + 1));
  if (need.samples == 0 || (!isShown && (!isCompared || window.references.contains(frame)))) return;
  const gl::PassGroup group(pass_group::kReference);
  const ShotState only = player_.onlyLane(need.lane);
  const ReferenceKey wanted{referenceRequest(only.request(0)), frame};
  const FlickerFrame* known = madeOfOtherLane(window, wanted.request, frame);
  if (isShown && !isCompared && known && known->referenceSamples == need.samples) {
    flicker.reference = known->reference;
    flicker.referenceSamples = need.samples;
    return;
  }
  Image reference = drawn.foundOrDrawn(*only.frames, wanted, need.samples, references_, progress).mean();
  if (isShown) {
    flicker.reference = shownColors(reference);
    flicker.referenceSamples = need.samples;
  }
  if (isCompared) window.references.insert_or_assign(frame, std::move(reference));
}

void OverTimeOfShot::addResolve(FrameWindow& window, const OverTimeNeed& need, int frame,
                                const RowImages& resolve) const {
  FrameOverTime& entry = window.frames.at(frame);
  if (need.has(OverTime::Flicker) && entry.flicker.shown.empty())
    entry.flicker.shown = shownColors(resolve.at(IntermediateId::output));
  if (!lacksErrors(window, need, frame)) return;
  const Settings& settings = player_.settings(need.lane);
  const bool isRead = frame > firstFrame(need.last);
  PartsInputs now = partsInputs(resolve, settings);
  now.reference = window.references.at(frame);
  if (isRead) now.steps = entry.flicker.steps;
  entry.errors = frameErrors(now, isRead ? &window.references.at(frame - 1) : nullptr, settings.history);
  entry.errorSamples = need.samples;
}

void OverTimeOfShot::fill(FrameWindow& window, References& drawn, const OverTimeNeed& need,
                          const Progress& progress) {
  assert(need.samples > 0 || !need.has(OverTime::Parts));
  const int first = firstFrame(need.last);
  window.keepOnly(first, need.last);
  if (window.referenceSamples != need.samples) window.references.clear();
  window.referenceSamples = need.samples;
  for (int frame = first; frame <= need.last; ++frame) window.frames[frame];
  for (int frame = first; frame <= need.last; ++frame) {
    const Progress told = [&, frame](std::string_view, int, int) {
      return !progress || progress(say<"Frames before">(), frame - first, need.last - first + 1);
    };
    report(told, "", 0, 0);
    if (frame > first) fillSteps(window, need, frame);
    fillReference(window, drawn, need, frame, told);
    if (frame == need.last) break;
    const std::vector<IntermediateId> ids = missingRows(window, need, frame);
    if (!ids.empty()) addResolve(window, need, frame, resolveOf(frame, ids, window.cursor, told, need.lane));
    window.references.erase(frame - 1);
  }
}

RowImages OverTimeOfShot::partsOf(const FrameWindow& window, const OverTimeNeed& need,
                                  const RowImages& resolve, const Progress& progress) const {
  std::vector<const FrameErrors*> oldestFirst;
  const int first = firstFrame(need.last);
  for (int frame = first; frame <= need.last; ++frame) oldestFirst.push_back(&window.frames.at(frame).errors);
  const bool starts = startsHistory(player_.state(), first);
  const ErrorParts parts = errorParts({oldestFirst, starts}, player_.settings(need.lane).history, progress);
  static const Image kNoSteps;
  const Image& steps = need.last > first ? window.frames.at(need.last).flicker.steps : kNoSteps;
  return partsRows(parts, resolve, window.references.at(need.last), steps);
}

std::map<OverTime, RowImages> OverTimeOfShot::finish(FrameWindow& window, const OverTimeNeed& need,
                                                     const RowImages& resolve,
                                                     const Progress& progress) const {
  addResolve(window, need, need.last, resolve);
  const int first = firstFrame(need.last);
  const Progress told = toldAtTheEnd(progress, need.last - first + 1);
  std::map<OverTime, RowImages> rows;
  for (const OverTime kind : need.kinds)
    rows.emplace(kind, kind == OverTime::Flicker ? flickerRows(window, first, need.last, resolve, told)
                                                 : partsOf(window, need, resolve, told));
  return rows;
}

RowsOverTime* OverTimeOfShot::rows(IntermediateId id, int lane) {
  const std::optional<int> known = samples(overTime(id), lane);
  const bool isMade = known && (*known > 0 || !needsReference(id));
  return isMade ? &lanes_.at(static_cast<std::size_t>(lane)).rows.at(overTime(id)) : nullptr;
}

const RowImages& OverTimeOfShot::maps(OverTime kind, int lane) const {
  return lanes_.at(static_cast<std::size_t>(lane)).rows.at(kind).maps();
}

void OverTimeOfShot::refine(const std::vector<OverTime>& kinds, int samples, const Progress& progress,
                            int lane) {
  OverTimeNeed need{{}, lane, player_.shown().frame, samples};
  for (const OverTime kind : kinds) {
    const std::optional<int> known = this->samples(kind, lane);
    if (!known || (*known != samples && samples > 0)) need.kinds.push_back(kind);
  }
  if (need.kinds.empty()) return;
  requireReference(driver_,
                   referenceBytes(player_.settings(lane), player_.picturePx(), player_.scene()) +
                       windowBytes(player_.picturePx(), frames_, need.kinds),
                   player_.picturePx());
  Measured& measured = measuredOf(lane);
  FrameWindow& window = measured.window;
  fill(window, references_, need, progress);
  const RowImages resolve = resolveNow(rowsOfLast(need), window.cursor, progress, lane);
  for (auto& [kind, rows] : finish(window, need, resolve, progress))
    measured.rows[kind].set({measured.key, need.last, frames_}, samples, std::move(rows));
}

std::optional<int> OverTimeOfShot::samples(OverTime kind, int lane) const {
  const Measured& measured = lanes_.at(static_cast<std::size_t>(lane));
  const auto found = measured.rows.find(kind);
  if (found == measured.rows.end()) return {};
  return found->second.samples({keyOf(lane), player_.shown().frame, frames_});
}

void OverTimeOfShot::setFrames(int frames) {
  assert(frames >= kMinFlickerFrames && frames <= kMaxFlickerFrames);
  frames_ = frames;
}

void OverTimeOfShot::forget() {
  for (Measured& measured : lanes_) measured = {};
}

} // namespace taa
