#include "tests/support/frames/LineageShot.h"

#include <cstddef>
#include <utility>

namespace taa::test {

LineageShot::LineageShot(std::vector<twin::Inputs> frames, const Settings& settings, Resolve resolve)
    : frames_(std::move(frames)), settings_(settings), resolve_(std::move(resolve)) {
  LeftHistory left;
  for (std::size_t index = 0; index < frames_.size(); ++index) {
    frames_[index].frame = static_cast<int>(index);
    if (index > 0) {
      frames_[index].historyColor = std::move(left.color);
      frames_[index].historySurface = std::move(left.surface);
    }
    left = resolve_(frames_[index], settings_);
  }
  last_ = std::move(left.color);
}

PixelStep LineageShot::step(int frame, const glm::ivec2& pixel) {
  return pixelStep(frames_.at(static_cast<std::size_t>(frame)), settings_, pixel);
}

glm::vec3 LineageShot::resolved(const glm::ivec2& pixel) const {
  return glm::vec3(last_.texel(pixel.x, pixel.y));
}

LineageShot LineageShot::with(int frame, const Change& change) const {
  std::vector<twin::Inputs> changed = frames_;
  Image& color = changed.at(static_cast<std::size_t>(frame)).color;
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x)
      for (int channel = 0; channel < 3; ++channel) color.at(x, y)[channel] += change({x, y})[channel];
  return {std::move(changed), settings_, resolve_};
}

LeftHistory LineageShot::resolveByTwin(const twin::Inputs& frame, const Settings& settings) {
  twin::Inputs made = frame;
  advance(made, settings, 0, 0);
  return {std::move(made.historyColor), std::move(made.historySurface)};
}

glm::dvec3 predictedResponse(const Lineage& lineage, int frame, const LineageShot::Change& change) {
  glm::dvec3 sum(0.0);
  for (const FootprintSample& sample : lineage.samples)
    if (sample.frame == frame) sum += sample.weight * glm::dvec3(change(sample.texel));
  return sum;
}

twin::Inputs mottledFrame(int width, int height, int frame) {
  twin::Inputs inputs = constantInputs(width, height, glm::vec3(0.5f));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto level = [&](int channel) {
        return 0.4f + 0.2f * static_cast<float>((x * 37 + y * 59 + frame * 23 + channel * 11) % 64) / 63.0f;
      };
      setColor(inputs.color, x, y, {level(0), level(1), level(2)});
    }
  return inputs;
}

void setMotion(twin::Inputs& inputs, const glm::vec2& motionPx) {
  for (int y = 0; y < inputs.height(); ++y)
    for (int x = 0; x < inputs.width(); ++x)
      for (int axis = 0; axis < 2; ++axis) inputs.motion.at(x, y)[axis] = motionPx[axis];
}

} // namespace taa::test
