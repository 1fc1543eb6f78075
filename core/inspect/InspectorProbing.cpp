// The façade's pins, what they follow and where that is; and what the CPU twin says about a pixel.
#include "core/inspect/InspectorParts.h"

#include "core/probe/ProbePin.h"
#include "core/probe/TwinInputs.h"
#include "core/taa/twin/stages/SampleStages.h"

#include <algorithm>
#include <vector>

namespace taa {

namespace {

/// The drawn texel that a pixel of the picture shows.
SeenSurface surfaceAt(const FrameInputs& inputs, const glm::ivec2& pixel) {
  const glm::ivec2 texel = pixel * glm::ivec2(inputs.width(), inputs.height()) /
                           glm::ivec2(inputs.outputWidth(), inputs.outputHeight());
  const gl::Rect one{texel.x, texel.y, 1, 1};
  return {static_cast<int>(inputs.objectId.download(one).texel(0, 0).x),
          inputs.depth.download(one).texel(0, 0).x};
}

} // namespace

twin::Details Inspector::details(int x, int y, int lane) {
  const gl::PassGroup group(pass_group::kProbe);
  twin::Details details;
  twin::Inputs twin = twinInputs(inputs(lane), parts_->lane(lane).previous.get(), TwinReading::Parts);
  if (const History* resolved = parts_->lane(lane).current.get())
    twin.resolved = twinTexels(resolved->color, TwinReading::Parts);
  twin::resolvePixel(twin, settings(lane), {x, y}, details);
  return details;
}

std::vector<WhatIfRow> Inspector::whatIf(int x, int y, int lane) {
  const gl::PassGroup group(pass_group::kProbe);
  return taa::whatIf(twinInputs(inputs(lane), parts_->lane(lane).previous.get(), TwinReading::Parts),
                     settings(lane), {x, y});
}

ProbePin Inspector::anchored(const ProbePin& pin) {
  if (pin.follow == Follow::Screen || pin.anchor) return pin;
  const gl::PassGroup group(pass_group::kProbe);
  const Subject& subject = parts_->subject;
  const FrameRequest request = subject.request(0);
  const int setIn = std::clamp(pin.frame, 0, frameCount() - 1);
  FrameInputs other; // what a pin follows shows only in its own frame
  const FrameInputs* drawn = &other;
  if (setIn == frame())
    drawn = &inputs();
  else
    subject.renderer->draw(request, setIn, other);
  ProbePin found = pin;
  found.anchor = anchorAt(scene(), viewAt(scene(), request, setIn), {width(), height()}, pin.pixel,
                          surfaceAt(*drawn, pin.pixel));
  return found;
}

PinSpot Inspector::spot(const ProbePin& pin) {
  if (pin.follow == Follow::Screen) return spotOf(scene(), {}, {width(), height()}, pin);
  const View view = viewAt(scene(), parts_->subject.request(0), frame());
  PinSpot spot = spotOf(scene(), view, {width(), height()}, pin);
  if (!pin.anchor || spot.state != PinState::Seen) return spot;
  const gl::PassGroup group(pass_group::kProbe);
  const SeenSurface drawn = surfaceAt(inputs(), spot.pixel);
  const float depth = twin::viewDepth(drawn.depth, view.block.depthTerms);
  if (isHidden(spot, *pin.anchor, drawn, depth)) spot.state = PinState::Hidden;
  return spot;
}

} // namespace taa
