// Hand-made inputs and history of the resolve.
#include "tests/support/frames/SyntheticFrame.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>

namespace taa::test {

namespace {

// Reversed depth with an infinite far plane, near plane at 0.1 m: depth = 0.1 / view depth.
constexpr float kNear = 0.1f;
const glm::vec4 kDepthTerms(0.0f, kNear, -1.0f, 0.0f);

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

float viewDepth(float depth) {
  return depth == 0.0f ? 0.0f : kNear / depth;
}

gl::Format colorFormat(Precision precision) {
  return precision == Precision::Half ? gl::Format::RGBA16F : gl::Format::RGBA32F;
}
gl::Format motionFormat(Precision precision) {
  return precision == Precision::Half ? gl::Format::RG16F : gl::Format::RG32F;
}

gl::Texture texture(const Image& image, gl::Format format) {
  gl::Texture made({image.width, image.height}, format, "synthetic");
  made.upload(image);
  return made;
}

// What a texture of the format holds of the image.
void quantize(Image& image, gl::Format format) {
  image = texture(image, format).download();
}

class Maker {
 public:
  Maker(const FrameShape& shape, std::uint32_t seed) : shape_(shape), random_(seed) {}

  float uniform(float lo, float hi) {
    return lo + (hi - lo) * static_cast<float>(random_() >> 8) / 16777216.0f;
  }
  bool chance(float probability) { return uniform(0.0f, 1.0f) < probability; }
  // Most near 1, some dark, few very bright, some black.
  float brightness() {
    if (chance(0.05f)) return 0.0f;
    return std::exp2(chance(0.1f) ? uniform(-14.0f, 15.0f) : uniform(-3.0f, 1.0f));
  }

  twin::Inputs images() {
    const int width = shape_.drawnWidth(), height = shape_.drawnHeight();
    twin::Inputs made;
    made.outputPx = {shape_.width, shape_.height};
    made.color = Image(width, height, 4);
    made.depth = Image(width, height, 1);
    made.motion = Image(width, height, 2);
    made.normal = Image(width, height, 4);
    made.objectId = Image(width, height, 1);
    made.previousDepth = Image(width, height, 1);
    made.depthTerms = kDepthTerms;
    return made;
  }

  void colors(Image& image) {
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const float level = brightness();
        for (int channel = 0; channel < 3; ++channel)
          image.at(x, y)[channel] = std::min(level * uniform(0.2f, 1.0f), 65504.0f);
        image.at(x, y)[3] = 1.0f;
      }
    quantize(image, colorFormat(shape_.inputs));
  }

  // Blocks of 4×4 pixels at one depth each, so that there are edges and ties.
  void surfaces(twin::Inputs& made) {
    const int width = shape_.drawnWidth(), height = shape_.drawnHeight();
    Image blocks((width + 3) / 4, (height + 3) / 4, 1);
    for (float& depth : blocks.pixels) depth = chance(0.2f) ? 0.0f : kNear / uniform(0.5f, 30.0f);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const float depth = *blocks.at(x / 4, y / 4) * (chance(0.3f) ? 1.001f : 1.0f);
        *made.depth.at(x, y) = depth;
        *made.objectId.at(x, y) = depth == 0.0f ? 0.0f : std::floor(uniform(1.0f, 200.0f));
        *made.previousDepth.at(x, y) = viewDepth(depth) * (chance(0.2f) ? uniform(0.8f, 1.2f) : 1.0f);
        for (int channel = 0; channel < 3; ++channel) made.normal.at(x, y)[channel] = uniform(-1.0f, 1.0f);
        made.normal.at(x, y)[3] = depth == 0.0f ? 0.0f : std::floor(uniform(1.0f, 4.0f));
        const float reach = chance(0.1f) ? 80.0f : chance(0.5f) ? 3.0f : 0.0f;
        for (int channel = 0; channel < 2; ++channel) made.motion.at(x, y)[channel] = uniform(-reach, reach);
      }
    quantize(made.normal, gl::Format::RGBA16F);
  }

  // Some pixels without a mask, some with the whole of it, and between.
  void layers(twin::Inputs& made) {
    made.mask = Image(shape_.drawnWidth(), shape_.drawnHeight(), 2);
    made.overlay = Image(shape_.drawnWidth(), shape_.drawnHeight(), 4);
    for (float& value : made.mask.pixels) value = chance(0.5f) ? 0.0f : std::min(uniform(0.0f, 1.2f), 1.0f);
    for (float& value : made.overlay.pixels) value = chance(0.5f) ? 0.0f : uniform(0.0f, 1.0f);
    quantize(made.mask, gl::Format::RG8);
    quantize(made.overlay, gl::Format::RGBA16F);
  }

  void history(twin::Inputs& made) {
    made.historyColor = Image(shape_.width, shape_.height, 4);
    for (int y = 0; y < shape_.height; ++y)
      for (int x = 0; x < shape_.width; ++x)
        std::copy_n(made.color.at(drawnColumn(x), drawnRow(y)), 4, made.historyColor.at(x, y));
    for (float& value : made.historyColor.pixels)
      value = std::min(value * (chance(0.5f) ? 1.0f : uniform(0.3f, 3.0f)), 60000.0f);
    quantize(made.historyColor, colorFormat(shape_.history));
    made.historySurface = Image(shape_.width, shape_.height, 2);
    for (int y = 0; y < shape_.height; ++y)
      for (int x = 0; x < shape_.width; ++x) {
        made.historySurface.at(x, y)[0] = uniform(1.0f, 19.0f);
        made.historySurface.at(x, y)[1] = viewDepth(*made.depth.at(drawnColumn(x), drawnRow(y))) *
                                          (chance(0.3f) ? uniform(0.9f, 1.1f) : 1.0f);
      }
  }

  // What the previous frame was of: in part the same as now.
  void past(twin::Inputs& made) {
    const int width = shape_.width, height = shape_.height;
    made.historyObject = Image(width, height, 2);
    made.historyNormal = Image(width, height, 4);
    made.historyMotion = Image(width, height, 2);
    made.historyLock = Image(width, height, 2);
    made.historyLumas = Image(width, height, 4);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const int column = drawnColumn(x), row = drawnRow(y);
        std::copy_n(made.normal.at(column, row), 4, made.historyNormal.at(x, y));
        std::copy_n(made.motion.at(column, row), 2, made.historyMotion.at(x, y));
        made.historyObject.at(x, y)[0] =
            chance(0.5f) ? *made.objectId.at(column, row) : std::floor(uniform(0.0f, 200.0f));
        made.historyObject.at(x, y)[1] =
            chance(0.5f) ? made.normal.at(column, row)[3] : std::floor(uniform(0.0f, 4.0f));
        if (chance(0.3f)) made.historyNormal.at(x, y)[random_() % 3] = uniform(-1.0f, 1.0f);
        if (chance(0.3f)) made.historyMotion.at(x, y)[random_() % 2] = uniform(-40.0f, 40.0f);
        if (chance(0.02f))
          made.historyMotion.at(x, y)[0] = made.historyMotion.at(x, y)[1] = kNoPreviousPosition;
        made.historyLock.at(x, y)[0] = chance(0.5f) ? 0.0f : uniform(0.0f, 2.0f);
        made.historyLock.at(x, y)[1] = chance(0.2f) ? 0.0f : uniform(0.0f, 3.0f);
        for (int channel = 0; channel < 4; ++channel)
          made.historyLumas.at(x, y)[channel] = std::floor(uniform(0.0f, 255.99f)) / 255.0f;
      }
    quantize(made.historyNormal, gl::Format::RGBA16F);
    quantize(made.historyLumas, gl::Format::RGBA8);
  }

  void makeWild(twin::Inputs& made) {
    static constexpr float kColors[] = {kNan, kInfinity, -kInfinity, -1.0f, -1e-3f, 65504.0f, 0.0f};
    static constexpr float kMotions[] = {kNan, kInfinity, -kInfinity, 3000.0f, -3000.0f, 65504.0f};
    for (int y = 0; y < shape_.drawnHeight(); ++y)
      for (int x = 0; x < shape_.drawnWidth(); ++x) {
        if (chance(0.04f)) made.color.at(x, y)[random_() % 3] = kColors[random_() % std::size(kColors)];
        if (chance(0.02f)) made.motion.at(x, y)[random_() % 2] = kMotions[random_() % std::size(kMotions)];
        if (chance(0.02f)) made.motion.at(x, y)[0] = made.motion.at(x, y)[1] = kNoPreviousPosition;
      }
  }

 private:
  int drawnColumn(int x) const { return x * shape_.drawnWidth() / shape_.width; }
  int drawnRow(int y) const { return y * shape_.drawnHeight() / shape_.height; }

  FrameShape shape_;
  std::mt19937 random_;
};

} // namespace

FrameShape shapeFor(const Settings& settings, FrameShape shape) {
  shape.history = settings.history.precision;
  shape.drawnPx = drawnSize({shape.width, shape.height}, settings.inputs.renderScale);
  return shape;
}

twin::Inputs flatFrame(const FrameShape& shape, float color) {
  twin::Inputs made = Maker(shape, 0).images();
  for (int y = 0; y < shape.drawnHeight(); ++y)
    for (int x = 0; x < shape.drawnWidth(); ++x) {
      for (int channel = 0; channel < 3; ++channel) made.color.at(x, y)[channel] = color;
      made.color.at(x, y)[3] = 1.0f;
      *made.depth.at(x, y) = kNear / 5.0f;
      *made.objectId.at(x, y) = 1.0f;
      *made.previousDepth.at(x, y) = 5.0f;
    }
  return made;
}

twin::Inputs randomFrame(const FrameShape& shape, std::uint32_t seed, bool wild) {
  Maker maker(shape, seed);
  twin::Inputs made = maker.images();
  maker.colors(made.color);
  maker.surfaces(made);
  maker.history(made);
  maker.past(made);
  maker.layers(made);
  if (wild) maker.makeWild(made);
  quantize(made.color, colorFormat(shape.inputs));
  quantize(made.motion, motionFormat(shape.inputs));
  made.frame = static_cast<int>(seed % 7);
  made.jitterPx = glm::vec2(maker.uniform(-0.5f, 0.5f), maker.uniform(-0.5f, 0.5f));
  made.lastJitterPx = glm::vec2(-made.jitterPx.y, 0.5f * made.jitterPx.x);
  return made;
}

twin::Inputs stillFrame(const FrameShape& shape, std::uint32_t seed) {
  twin::Inputs made = flatFrame(shape, 0.0f);
  Maker(shape, seed).colors(made.color);
  return made;
}

FrameInputs upload(const twin::Inputs& images, const FrameShape& shape) {
  FrameInputs made;
  made.outputPx = images.outputPx;
  made.info.frame = images.frame;
  made.info.stepSeconds = images.stepSeconds;
  made.info.jitterPx = images.jitterPx;
  made.block.depthTerms = images.depthTerms;
  made.block.previousJitter = glm::vec4(images.lastJitterPx, 0.0f, 0.0f);
  made.color = texture(images.color, colorFormat(shape.inputs));
  made.depth = texture(images.depth, gl::Format::Depth32F);
  made.motion = texture(images.motion, motionFormat(shape.inputs));
  made.normal = texture(images.normal, gl::Format::RGBA16F);
  made.objectId = texture(images.objectId, gl::Format::R32UI);
  made.previousDepth = texture(images.previousDepth, gl::Format::R32F);
  if (!images.mask.empty()) made.mask = texture(images.mask, gl::Format::RG8);
  if (!images.overlay.empty()) made.overlay = texture(images.overlay, gl::Format::RGBA16F);
  return made;
}

History uploadHistory(const twin::Inputs& images, const FrameShape& shape) {
  History made;
  if (images.historyColor.empty()) return made;
  made.color = texture(images.historyColor, colorFormat(shape.history));
  made.surface = texture(images.historySurface, gl::Format::RG32F);
  const auto layer = [](const Image& image, gl::Format format) {
    return image.empty() ? gl::Texture() : texture(image, format);
  };
  made.object = layer(images.historyObject, gl::Format::RG32F);
  made.normal = layer(images.historyNormal, gl::Format::RGBA16F);
  made.motion = layer(images.historyMotion, gl::Format::RG32F);
  made.lock = layer(images.historyLock, gl::Format::RG32F);
  made.lumas = layer(images.historyLumas, gl::Format::RGBA8);
  return made;
}

void downloadHistory(const History& history, twin::Inputs& images) {
  images.historyColor = history.color.download();
  images.historySurface = history.surface.download();
  const auto layer = [](const gl::Texture& texture) { return texture ? texture.download() : Image(); };
  images.historyObject = layer(history.object);
  images.historyNormal = layer(history.normal);
  images.historyMotion = layer(history.motion);
  images.historyLock = layer(history.lock);
  images.historyLumas = layer(history.lumas);
}

} // namespace taa::test
