// How much what is shown changes over the last frames: made when somebody asks, of exact frames.
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/inspect/InspectorParts.h"
#include "core/taa/twin/stages/SampleStages.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace taa {

namespace {

// What is drawn for the reference, but through the centers of the pixels.
SeenSurfaces drawSurfaces(SceneRenderer& renderer, const FrameRequest& ofLane, int frame,
                          FrameInputs& drawn) {
  FrameRequest request = referenceRequest(ofLane);
  request.jitterPx = glm::vec2(0.0f);
  renderer.draw(request, frame, drawn);
  SeenSurfaces seen{drawn.objectId.download(), drawn.depth.download(), drawn.motion.download(),
                    drawn.previousDepth.download()};
  for (float& depth : seen.depthView.pixels) depth = twin::viewDepth(depth, drawn.block.depthTerms);
  return seen;
}

// The way from the frame before. What was drawn of that one last is used again.
Image drawSteps(SceneRenderer& renderer, const FrameRequest& ofLane, int frame, FlickerWindow& window) {
  FrameInputs drawn;
  if (!window.seen || window.seen->first != frame - 1)
    window.seen.emplace(frame - 1, drawSurfaces(renderer, ofLane, frame - 1, drawn));
  SeenSurfaces now = drawSurfaces(renderer, ofLane, frame, drawn);
  Image steps = surfaceSteps(now, window.seen->second);
  window.seen.emplace(frame, std::move(now));
  return steps;
}

} // namespace

FlickerSubject InspectedShot::Parts::flickerSubject(int lane) const {
  return {subject.request(static_cast<std::size_t>(lane)), settings(lane)};
}

int InspectedShot::Parts::firstOfFlicker(int last) const {
  int first = last;
  while (last - first + 1 < flickerFrames && !startsHistory(subject, first)) --first;
  return first;
}

Image InspectedShot::Parts::shownBeside(int frame, TraceCursor& cursor, const Progress& progress, int lane) {
  const gl::PassGroup group(pass_group::kExposure);
  ShownFrame made = makeBeside(frame, cursor, progress, lane);
  const Image output =
      maker.expose(onlyLane(lane), made, {IntermediateId::output}, 0).image(IntermediateId::output);
  maker.recycle(std::move(made));
  return shownColors(output);
}

void InspectedShot::Parts::fillFlicker(FlickerWindow& window, References& drawn, const FlickerNeed& need,
                                       const Progress& progress) {
  const Subject only = onlyLane(need.lane);
  const int first = firstOfFlicker(need.last);
  keepOnly(window, first, need.last);
  for (int frame = first; frame <= need.last; ++frame) {
    const Progress told = [&, frame](std::string_view, int, int) {
      return !progress || progress(say<"Flicker">(), frame - first, need.last - first + 1);
    };
    report(told, "", 0, 0);
    FlickerFrame& entry = window.frames[frame];
    if (entry.shown.empty() && frame < need.last)
      entry.shown = shownBeside(frame, window.cursor, told, need.lane);
    const gl::PassGroup group(pass_group::kReference);
    if (need.samples > 0 && entry.referenceSamples != need.samples) {
      entry.reference = shownColors(referenceOf(only, frame, need.samples, drawn, told).mean());
      entry.referenceSamples = need.samples;
    }
    if (entry.steps.empty() && frame > first)
      entry.steps = drawSteps(*only.renderer, only.request(0), frame, window);
  }
}

FlickerRows* InspectedShot::Parts::flickerRows(IntermediateId id, int index) {
  FlickerRows& rows = flickers.at(static_cast<std::size_t>(index));
  const std::optional<int> samples = rows.samples(flickerSubject(index), shown.frame, flickerFrames);
  const bool isMade = samples && (*samples > 0 || !needsReference(id));
  return isMade ? &rows : nullptr;
}

void Inspector::refineFlicker(int samples, const Progress& progress, int lane) {
  Parts& parts = *parts_;
  if (const std::optional<int> known = flickerSamples(lane); known && (*known == samples || samples == 0))
    return;
  parts.checkReference(lane, flickerBytes({width(), height()}, parts.flickerFrames));
  const auto index = static_cast<std::size_t>(lane);
  FlickerRows& rows = parts.flickers.at(index);
  FlickerWindow& window = rows.windowOf(parts.flickerSubject(lane));
  parts.fillFlicker(window, parts.references, {lane, frame(), samples}, progress);
  FlickerFrame& last = window.frames.at(frame());
  if (last.shown.empty())
    last.shown = isExact(lane) ? shownColors(image(IntermediateId::output, lane))
                               : parts.shownBeside(frame(), window.cursor, progress, lane);
  rows.set(frame(), parts.flickerFrames, samples,
           flickerMaps(window, parts.firstOfFlicker(frame()), frame(), progress));
}

std::optional<int> Inspector::flickerSamples(int lane) const {
  return parts_->flickers.at(static_cast<std::size_t>(lane))
      .samples(parts_->flickerSubject(lane), frame(), parts_->flickerFrames);
}

void Inspector::setFlickerFrames(int frames) {
  assert(frames >= kLeastFlickerFrames && frames <= kMostFlickerFrames);
  parts_->flickerFrames = frames;
}

int Inspector::flickerFrames() const {
  return parts_->flickerFrames;
}

} // namespace taa
