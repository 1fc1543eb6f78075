#include "core/measure/DrawnSurfaces.h"

#include "core/measure/References.h"
#include "core/probe/NearParts.h"
#include "core/render/FrameInputs.h"
#include "core/taa/twin/SampleStages.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
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
  for (Image* image : {&seen.objectId, &seen.depthView, &seen.motionPx, &seen.previousDepthView, &seen.mask})
    if (!image->empty()) *image = enlarged(*image, sizePx);
  for (std::size_t at = 0; at < seen.motionPx.pixels.size(); at += 2)
    for (int axis = 0; axis < 2; ++axis)
      if (float& value = seen.motionPx.pixels[at + static_cast<std::size_t>(axis)];
          value != kNoPreviousPosition)
        value *= ratio[axis];
}

/// Without what shows in color alone.
FrameRequest centersOf(const FrameRequest& ofLane) {
  FrameRequest request = referenceRequest(ofLane);
  request.inputs.shadows = Shadows::None;
  request.inputs.fogDensity = 0.0f;
  request.jitterPx = glm::vec2(0.0f);
  request.inputs.mask = MaskSource::Opacity;
  return request;
}

SeenSurfaces seenIn(const FrameInputs& drawn, const gl::Rect& part) {
  SeenSurfaces seen{drawn.objectId.download(part),
                    drawn.depth.download(part),
                    drawn.motion.download(part),
                    drawn.previousDepth.download(part),
                    {part.x, part.y},
                    drawn.mask ? drawn.mask.download(part) : Image()}; // a capture may have none
  for (float& depth : seen.depthView.pixels) depth = twin::viewDepth(depth, drawn.block.depthTerms);
  return seen;
}

SeenSurfaces drawSurfaces(FrameSource& frames, const FrameRequest& ofLane, int frame, FrameInputs& drawn) {
  frames.draw(centersOf(ofLane), frame, drawn);
  SeenSurfaces seen = seenIn(drawn, {0, 0, drawn.width(), drawn.height()});
  const glm::ivec2 sizePx(drawn.outputWidth(), drawn.outputHeight());
  if (sizePx != glm::ivec2(drawn.width(), drawn.height())) enlarge(seen, sizePx);
  return seen;
}

gl::Rect heldPlace(const SeenSurfaces& seen) {
  return {seen.corner.x, seen.corner.y, seen.objectId.width, seen.objectId.height};
}

} // namespace

SeenSurfaces drawSurfaces(FrameSource& frames, const FrameRequest& ofLane, int frame) {
  FrameInputs drawn;
  return drawSurfaces(frames, ofLane, frame, drawn);
}

Image drawSteps(FrameSource& frames, const FrameRequest& ofLane, int frame, DrawnSurfaces& last) {
  FrameInputs drawn;
  if (!last || last->first != frame - 1)
    last.emplace(frame - 1, drawSurfaces(frames, ofLane, frame - 1, drawn));
  SeenSurfaces now = drawSurfaces(frames, ofLane, frame, drawn);
  Image steps = surfaceSteps(now, last->second);
  last.emplace(frame, std::move(now));
  return steps;
}

Image firstSteps(const SeenSurfaces& seen, const gl::Rect& part) {
  Image steps(part.width, part.height, kStepChannels);
  for (int y = 0; y < steps.height; ++y)
    for (int x = 0; x < steps.width; ++x) {
      float* step = steps.at(x, y);
      step[0] = step[1] = std::numeric_limits<float>::quiet_NaN();
      step[2] = *seen.objectId.at(part.x + x - seen.corner.x, part.y + y - seen.corner.y);
      step[3] = maskFlags(seen, part.x + x, part.y + y);
    }
  return steps;
}

SurfaceParts::SurfaceParts(FrameSource& frames, const FrameRequest& ofLane)
    : frames_(frames), request_(centersOf(ofLane)) {}

const SeenSurfaces& SurfaceParts::seen(int frame, const gl::Rect& part, FrameInputs& drawn) {
  constexpr int kAround = 2; // px: what is looked at next is near
  const auto [first, end] = seen_.equal_range(frame);
  const auto known =
      std::find_if(first, end, [&](const auto& seen) { return gl::contains(heldPlace(seen.second), part); });
  if (known != end) return known->second;
  gl::Rect wanted = part;
  for (const gl::Rect& expected : expected_[frame])
    if (areNear(wanted, expected)) wanted = gl::rectAround(wanted, expected);
  const gl::Rect place = gl::grown(wanted, kAround, {request_.width, request_.height});
  request_.part = place;
  frames_.draw(request_, frame, drawn);
  return seen_.emplace(frame, seenIn(drawn, place))->second;
}

int SurfaceParts::object(int frame, const glm::ivec2& pixel, FrameInputs& drawn) {
  const SeenSurfaces& now = seen(frame, {pixel.x, pixel.y, 1, 1}, drawn);
  return static_cast<int>(*now.objectId.at(pixel.x - now.corner.x, pixel.y - now.corner.y));
}

Image SurfaceParts::steps(int frame, const gl::Rect& part, bool isStart, FrameInputs& drawn) {
  const glm::ivec2 sizePx(request_.width, request_.height);
  const SeenSurfaces& now = seen(frame, part, drawn);
  if (isStart) return firstSteps(now, part);
  const gl::Rect places = formerPlaces(now, part, sizePx);
  return surfaceSteps(now, places.width > 0 ? seen(frame - 1, places, drawn) : now, part, sizePx);
}

} // namespace taa
