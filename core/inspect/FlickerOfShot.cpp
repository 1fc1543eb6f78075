#include "core/inspect/FlickerOfShot.h"

#include "core/base/Say.h"
#include "core/gl/PassTimer.h"
#include "core/inspect/MemoryNeed.h"
#include "core/measure/Profiler.h"
#include "core/measure/References.h"
#include "core/replay/ShotPlayer.h"
#include "core/taa/twin/stages/SampleStages.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace taa {

namespace {

Image enlarged(const Image& image, const glm::ivec2& sizePx) {
  Image large(sizePx.x, sizePx.y, image.channels);
  for (int y = 0; y < sizePx.y; ++y)
    for (int x = 0; x < sizePx.x; ++x)
      std::copy_n(image.at(x * image.width / sizePx.x, y * image.height / sizePx.y), image.channels,
                  large.at(x, y));
  return large;
}

// A capture may be smaller than its picture.
void enlarge(SeenSurfaces& seen, const glm::ivec2& sizePx) {
  const glm::vec2 ratio = glm::vec2(sizePx) / glm::vec2(seen.motionPx.width, seen.motionPx.height);
  for (Image* image : {&seen.objectId, &seen.depthView, &seen.motionPx, &seen.previousDepthView})
    *image = enlarged(*image, sizePx);
  for (std::size_t at = 0; at < seen.motionPx.pixels.size(); at += 2)
    for (int axis = 0; axis < 2; ++axis)
      if (float& value = seen.motionPx.pixels[at + static_cast<std::size_t>(axis)];
          value != kNoPreviousPosition)
        value *= ratio[axis];
}

// What is drawn for the reference, but through the centers of the pixels. A capture shows the samples it was
// taken with instead.
SeenSurfaces drawSurfaces(FrameSource& frames, const FrameRequest& ofLane, int frame, FrameInputs& drawn) {
  FrameRequest request = referenceRequest(ofLane);
  request.jitterPx = glm::vec2(0.0f);
  frames.draw(request, frame, drawn);
  SeenSurfaces seen{drawn.objectId.download(), drawn.depth.download(), drawn.motion.download(),
                    drawn.previousDepth.download()};
  for (float& depth : seen.depthView.pixels) depth = twin::viewDepth(depth, drawn.block.depthTerms);
  const glm::ivec2 sizePx(drawn.outputWidth(), drawn.outputHeight());
  if (sizePx != glm::ivec2(drawn.width(), drawn.height())) enlarge(seen, sizePx);
  return seen;
}

// The way from the frame before. What was drawn of that one last is used again.
Image drawSteps(FrameSource& frames, const FrameRequest& ofLane, int frame, FlickerWindow& window) {
  FrameInputs drawn;
  if (!window.seen || window.seen->first != frame - 1)
    window.seen.emplace(frame - 1, drawSurfaces(frames, ofLane, frame - 1, drawn));
  SeenSurfaces now = drawSurfaces(frames, ofLane, frame, drawn);
  Image steps = surfaceSteps(now, window.seen->second);
  window.seen.emplace(frame, std::move(now));
  return steps;
}

} // namespace

FlickerOfShot::FlickerOfShot(ShotPlayer& player, References& references, const gl::Driver& driver)
    : player_(player), references_(references), driver_(driver) {}

FlickerKey FlickerOfShot::keyOf(int lane) const {
  return {player_.state().request(static_cast<std::size_t>(lane)), player_.settings(lane)};
}

// The first frame that flicker of `last` is taken over.
int FlickerOfShot::firstFrame(int last) const {
  int first = last;
  while (last - first + 1 < frames_ && !startsHistory(player_.state(), first)) --first;
  return first;
}

// What a lane shows in any frame, as a screen is sent it.
Image FlickerOfShot::shownColorsOf(int frame, TraceCursor& cursor, const Progress& progress, int lane) {
  const gl::PassGroup group(pass_group::kExposure);
  FrameMaker& maker = player_.maker();
  ShownFrame made = player_.makeInBackground(frame, cursor, progress, lane);
  const Image output =
      maker.expose(player_.onlyLane(lane), made, {IntermediateId::output}, 0).image(IntermediateId::output);
  maker.recycle(std::move(made));
  return shownColors(output);
}

// The frame on show is at hand where it is exact.
Image FlickerOfShot::shownNow(TraceCursor& cursor, const Progress& progress, int lane) {
  if (!player_.lane(lane).exact) return shownColorsOf(player_.shown().frame, cursor, progress, lane);
  const gl::PassGroup group(pass_group::kExposure);
  return shownColors(player_.exposed(IntermediateId::output, lane).image(IntermediateId::output));
}

void FlickerOfShot::fill(FlickerWindow& window, References& drawn, const FlickerNeed& need,
                         const Progress& progress) {
  const ShotState only = player_.onlyLane(need.lane);
  const int first = firstFrame(need.last);
  keepOnly(window, first, need.last);
  for (int frame = first; frame <= need.last; ++frame) {
    const Progress told = [&, frame](std::string_view, int, int) {
      return !progress || progress(say<"Flicker">(), frame - first, need.last - first + 1);
    };
    report(told, "", 0, 0);
    FlickerFrame& entry = window.frames[frame];
    if (entry.shown.empty() && frame < need.last)
      entry.shown = shownColorsOf(frame, window.cursor, told, need.lane);
    const gl::PassGroup group(pass_group::kReference);
    if (need.samples > 0 && entry.referenceSamples != need.samples) {
      const ReferenceKey wanted{referenceRequest(only.request(0)), frame};
      entry.reference =
          shownColors(drawn.foundOrDrawn(*only.frames, wanted, need.samples, references_, told).mean());
      entry.referenceSamples = need.samples;
    }
    if (entry.steps.empty() && frame > first)
      entry.steps = drawSteps(*only.frames, only.request(0), frame, window);
  }
}

FlickerMaps FlickerOfShot::mapsOf(const FlickerWindow& window, int last, const Progress& progress) const {
  return flickerMaps(window, firstFrame(last), last, progress);
}

FlickerRows* FlickerOfShot::rows(IntermediateId id, int lane) {
  const std::optional<int> known = samples(lane);
  const bool isMade = known && (*known > 0 || !needsReference(id));
  return isMade ? &rows_.at(static_cast<std::size_t>(lane)) : nullptr;
}

const FlickerMaps& FlickerOfShot::maps(int lane) const {
  return rows_.at(static_cast<std::size_t>(lane)).maps();
}

void FlickerOfShot::refine(int samples, const Progress& progress, int lane) {
  if (const std::optional<int> known = this->samples(lane); known && (*known == samples || samples == 0))
    return;
  const Settings& settings = player_.settings(lane);
  requireReference(driver_,
                   referenceBytes(settings, player_.picturePx(), player_.hasFog()) +
                       flickerBytes(player_.picturePx(), frames_),
                   player_.picturePx());
  const int frame = player_.shown().frame;
  FlickerRows& rows = rows_.at(static_cast<std::size_t>(lane));
  FlickerWindow& window = rows.windowOf(keyOf(lane));
  fill(window, references_, {lane, frame, samples}, progress);
  FlickerFrame& last = window.frames.at(frame);
  if (last.shown.empty()) last.shown = shownNow(window.cursor, progress, lane);
  rows.set(frame, frames_, samples, mapsOf(window, frame, progress));
}

std::optional<int> FlickerOfShot::samples(int lane) const {
  return rows_.at(static_cast<std::size_t>(lane)).samples(keyOf(lane), player_.shown().frame, frames_);
}

void FlickerOfShot::setFrames(int frames) {
  assert(frames >= kMinFlickerFrames && frames <= kMaxFlickerFrames);
  frames_ = frames;
}

void FlickerOfShot::forget() {
  for (FlickerRows& rows : rows_) rows.forget();
}

} // namespace taa
