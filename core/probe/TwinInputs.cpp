#include "core/probe/TwinInputs.h"

#include <utility>

namespace taa {

namespace {

using Require = std::function<void(const gl::Rect&)>;

twin::Texels texelsInParts(const gl::Texture& texture, const Require& require) {
  if (!texture) return {};
  return {texture.width(), texture.height(), gl::channels(texture.format()),
          [&texture, require](int x, int y, int width, int height) {
            const gl::Rect part{x, y, width, height};
            if (require) require(part);
            return texture.download(part);
          }};
}

void readHistory(const History& previous, TwinReading reading, twin::Inputs& twin) {
  const auto read = [reading](const gl::Texture& texture) { return twinTexels(texture, reading); };
  twin.historyColor = read(previous.readColor());
  twin.historySurface = read(previous.surface);
  twin.historyObject = read(previous.object);
  twin.historyNormal = read(previous.normal);
  twin.historyMotion = read(previous.motion);
  twin.historyLock = read(previous.lock);
  twin.historyLumas = read(previous.lumas);
}

/// `read` makes texels of a texture.
template <typename Read>
twin::Inputs drawnInputs(const FrameInputs& inputs, const Read& read) {
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
  twin.outputPx = inputs.outputPx;
  twin.frame = inputs.info.frame;
  twin.stepSeconds = inputs.info.stepSeconds;
  twin.jitterPx = inputs.block.jitterPx;
  twin.lastJitterPx = glm::vec2(inputs.block.previousJitter);
  twin.depthTerms = inputs.block.depthTerms;
  return twin;
}

} // namespace

twin::Texels twinTexels(const gl::Texture& texture, TwinReading reading) {
  if (!texture) return {};
  if (reading == TwinReading::Whole) return texture.download();
  return texelsInParts(texture, {});
}

twin::Inputs twinInputs(const FrameInputs& inputs, const History* previous, TwinReading reading) {
  twin::Inputs twin =
      drawnInputs(inputs, [reading](const gl::Texture& texture) { return twinTexels(texture, reading); });
  if (previous) readHistory(*previous, reading, twin);
  return twin;
}

twin::Inputs twinInputs(const FrameInputs& inputs, const History* previous,
                        std::function<void(const gl::Rect& part)> require) {
  twin::Inputs twin =
      drawnInputs(inputs, [&require](const gl::Texture& texture) { return texelsInParts(texture, require); });
  if (previous) readHistory(*previous, TwinReading::Parts, twin);
  return twin;
}

} // namespace taa
