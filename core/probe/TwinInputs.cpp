#include "core/probe/TwinInputs.h"

namespace taa {

twin::Texels twinTexels(const gl::Texture& texture, TwinReading reading) {
  if (!texture) return {};
  if (reading == TwinReading::Whole) return texture.download();
  return {texture.width(), texture.height(), gl::channels(texture.format()),
          [&texture](int x, int y, int width, int height) {
            return texture.download({x, y, width, height});
          }};
}

twin::Inputs twinInputs(const FrameInputs& inputs, const History* previous, TwinReading reading) {
  const auto read = [reading](const gl::Texture& texture) { return twinTexels(texture, reading); };
  twin::Inputs twin;
  twin.color = read(inputs.color);
  twin.depth = read(inputs.depth);
  twin.motion = read(inputs.motion);
  twin.normal = read(inputs.normal);
  twin.objectId = read(inputs.objectId);
  twin.previousDepth = read(inputs.previousDepth);
  twin.mask = read(inputs.mask);
  twin.overlay = read(inputs.overlay);
  twin.fog = read(inputs.fog);
  if (previous) {
    twin.historyColor = read(previous->color);
    twin.historySurface = read(previous->surface);
    twin.historyObject = read(previous->object);
    twin.historyNormal = read(previous->normal);
    twin.historyMotion = read(previous->motion);
    twin.historyLock = read(previous->lock);
    twin.historyLumas = read(previous->lumas);
  }
  twin.outputPx = inputs.outputPx;
  twin.frame = inputs.info.frame;
  twin.stepSeconds = inputs.info.stepSeconds;
  twin.jitterPx = inputs.block.jitterPx;
  twin.depthTerms = inputs.block.depthTerms;
  return twin;
}

} // namespace taa
