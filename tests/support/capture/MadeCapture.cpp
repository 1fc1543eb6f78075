#include "tests/support/capture/MadeCapture.h"

#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/format/Manifest.h"
#include "tests/support/capture/CapturedShot.h"

#include <cstddef>

namespace taa::test {

namespace {

capture::DecodedFrame blankFrame(const glm::ivec2& sizePx, int index) {
  capture::DecodedFrame frame;
  frame.index = index;
  frame.startsHistory = index == 0;
  frame.seconds = index / 60.0;
  frame.color = frame.reference = Image(sizePx.x, sizePx.y, 4);
  frame.motion = frame.mask = Image(sizePx.x, sizePx.y, 2);
  frame.depth = frame.previousDepth = Image(sizePx.x, sizePx.y, 1);
  return frame;
}

void setColor(Image& image, const glm::ivec2& at, const glm::vec3& color) {
  float* value = image.at(at.x, at.y);
  for (int channel = 0; channel < 3; ++channel) value[channel] = color[channel];
  value[3] = 1.0f;
}

capture::DecodedFrame decodedFrame(const MadeCapture& made, int index) {
  capture::DecodedFrame frame = blankFrame(made.sizePx, index);
  for (int y = 0; y < made.sizePx.y; ++y)
    for (int x = 0; x < made.sizePx.x; ++x) {
      const MadePixel pixel = made.pixel(index, {x, y});
      setColor(frame.reference, {x, y}, pixel.color);
      setColor(frame.color, {x, y}, pixel.sample.value_or(pixel.color));
      frame.motion.at(x, y)[0] = pixel.motionPx.x;
      frame.motion.at(x, y)[1] = pixel.motionPx.y;
      frame.mask.at(x, y)[1] = pixel.responsive;
      *frame.depth.at(x, y) = static_cast<float>(frame.nearPlane) / pixel.depth;
      *frame.previousDepth.at(x, y) = pixel.depth;
      frame.objectId.push_back(pixel.object);
    }
  return frame;
}

} // namespace

void writeCapture(const std::filesystem::path& folder, const MadeCapture& made) {
  capture::Manifest manifest;
  manifest.name = "made";
  manifest.sizePx = made.sizePx;
  manifest.objects = made.objects;
  manifest.frames.resize(static_cast<std::size_t>(made.frames));
  for (int index = 0; index < made.frames; ++index) {
    capture::CapturedFrame& stated = manifest.frames[static_cast<std::size_t>(index)];
    stated.number = index;
    stated.seconds = index / 60.0;
  }
  writeCapture(folder, manifest, [&](int index) { return decodedFrame(made, index); });
}

} // namespace taa::test
