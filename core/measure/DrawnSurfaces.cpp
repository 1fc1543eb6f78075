#include "core/measure/DrawnSurfaces.h"

#include "core/measure/References.h"
#include "core/render/FrameInputs.h"
#include "core/taa/twin/stages/SampleStages.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>

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

} // namespace taa
