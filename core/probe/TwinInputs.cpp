#include "core/probe/TwinInputs.h"

#include <utility>

namespace taa {

namespace {

using ReadDrawn = std::function<Image(const gl::Texture&, const gl::Rect&)>;

/// Small, because what is read is drawn.
constexpr int kDrawnTile = 2;

twin::Texels texelsInParts(const gl::Texture& texture, const ReadDrawn& read, int tile) {
  if (!texture) return {};
  return {texture.width(), texture.height(), gl::channels(texture.format()),
          [&texture, read](int x, int y, int width, int height) {
            return read(texture, {x, y, width, height});
          },
          tile};
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
  twin.forwardCount = read(inputs.forwardCount);
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
  const auto read = [](const gl::Texture& from, const gl::Rect& part) { return from.download(part); };
  return texelsInParts(texture, read, twin::Texels::kTile);
}

twin::Inputs twinInputs(const FrameInputs& inputs, const History* previous, TwinReading reading) {
  twin::Inputs twin =
      drawnInputs(inputs, [reading](const gl::Texture& texture) { return twinTexels(texture, reading); });
  if (previous) readHistory(*previous, reading, twin);
  return twin;
}

twin::Inputs twinInputs(const FrameInputs& inputs, const History* previous, const ReadDrawn& readDrawn) {
  twin::Inputs twin = drawnInputs(inputs, [&readDrawn](const gl::Texture& texture) {
    return texelsInParts(texture, readDrawn, kDrawnTile);
  });
  if (previous) readHistory(*previous, TwinReading::Parts, twin);
  return twin;
}

} // namespace taa
