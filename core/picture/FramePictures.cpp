#include "core/picture/FramePictures.h"

#include "core/base/Light.h"
#include "core/base/Median.h"
#include "core/picture/ColorMap.h"
#include "core/render/FrameInputs.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa {

namespace {

/// Of values that are shown as the end of a range: the others are thought to be outliers.
constexpr double kShareWithin = 0.98;
/// Values that a range is made from, at most: enough for a share of them.
constexpr int kMaxSamples = 20000;
/// A difference of this, of the 0 to 1 of the screen, is the end of its color map.
constexpr float kFullDifference = 0.5f;

/// What all but a few of the finite values of `of(texel)` are below; 0 where there are none.
template <typename Of>
float highValue(const Image& image, double share, Of of) {
  std::vector<float> values;
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const std::size_t step = std::max<std::size_t>(1, pixels / kMaxSamples);
  for (std::size_t i = 0; i < pixels; i += step) {
    const auto x = static_cast<int>(i % static_cast<std::size_t>(image.width));
    const auto y = static_cast<int>(i / static_cast<std::size_t>(image.width));
    if (const float value = of(image.texel(x, y)); std::isfinite(value) && value > 0.0f)
      values.push_back(value);
  }
  if (values.empty()) return 0.0f;
  return valueOfRank(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

int shrinkingOf(const Image& image, int maxSide) {
  return std::max(1, (std::max(image.width, image.height) + maxSide - 1) / maxSide);
}

/// Means of squares of pixels, by alpha where there are four channels.
Image averaged(const Image& image, int side) {
  if (side == 1 || image.empty()) return image;
  Image small((image.width + side - 1) / side, (image.height + side - 1) / side, 4);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      glm::vec4 sum(0.0f);
      int count = 0;
      for (int row = y * side; row < std::min((y + 1) * side, image.height); ++row)
        for (int column = x * side; column < std::min((x + 1) * side, image.width); ++column, ++count) {
          const glm::vec4 texel = image.texel(column, row);
          if (texel.w > 0.0f) sum += glm::vec4(glm::vec3(texel) * texel.w, texel.w);
        }
      const glm::vec3 color = sum.w > 0.0f ? glm::vec3(sum) / sum.w : glm::vec3(0.0f);
      float* const out = small.at(x, y);
      for (int channel = 0; channel < 3; ++channel) out[channel] = color[channel];
      out[3] = sum.w / static_cast<float>(count);
    }
  return small;
}

/// One of each square of pixels, where a mean would be of no meaning.
Image picked(const Image& image, int side) {
  if (side == 1 || image.empty()) return image;
  Image small((image.width + side - 1) / side, (image.height + side - 1) / side, image.channels);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      std::copy_n(image.at(std::min(x * side + side / 2, image.width - 1),
                           std::min(y * side + side / 2, image.height - 1)),
                  image.channels, small.at(x, y));
  return small;
}

using Rgba = std::array<std::uint8_t, 4>;

constexpr Rgba kNothing{0, 0, 0, 0}, kNanPixel{255, 0, 0, 255}; ///< red, as everywhere

/// `color`: of the screen, linear.
Rgba rgbaOf(const glm::vec3& color, float alpha = 1.0f) {
  if (std::isnan(color.x + color.y + color.z)) return kNanPixel;
  return {srgbByte(color.x), srgbByte(color.y), srgbByte(color.z),
          static_cast<std::uint8_t>(std::lround(std::clamp(alpha, 0.0f, 1.0f) * 255.0f))};
}
Rgba rgbaOf(const std::array<float, 3>& color) {
  return rgbaOf(glm::vec3(color[0], color[1], color[2]));
}

/// `pixel(x, y)` of each pixel; none where the image is empty.
template <typename Pixel>
Picture drawn(const Image& image, Pixel pixel) {
  Picture picture{image.width, image.height, {}};
  picture.rgba.reserve(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Rgba rgba = pixel(x, y);
      picture.rgba.insert(picture.rgba.end(), rgba.begin(), rgba.end());
    }
  return picture;
}

Picture colorPicture(const Image& color, float exposure) {
  return drawn(color, [&](int x, int y) {
    const glm::vec4 texel = color.texel(x, y);
    return rgbaOf(glm::vec3(texel) * exposure, texel.w);
  });
}

bool hasPrevious(glm::vec2 motionPx) {
  return motionPx.x != kNoPreviousPosition && motionPx.y != kNoPreviousPosition;
}

float lengthOf(const glm::vec4& motion) {
  const glm::vec2 px(motion);
  return hasPrevious(px) ? glm::length(px) : 0.0f;
}

// Direction as hue, length as saturation, as views show it; nothing where there is no previous position.
Picture motionPicture(const Image& motion) {
  const float range = std::max(highValue(motion, kShareWithin, lengthOf), 1e-3f);
  return drawn(motion, [&](int x, int y) {
    const glm::vec2 px(motion.texel(x, y));
    if (!hasPrevious(px)) return kNothing;
    if (std::isnan(px.x + px.y)) return kNanPixel;
    return rgbaOf(vectorColor(px, std::min(glm::length(px) / range, 1.0f)));
  });
}

// The logarithm of this program's depth, near bright; nothing where nothing was drawn.
Picture depthPicture(const Image& depth) {
  const auto valueOf = [](const glm::vec4& texel) { return texel.x; };
  const float low = highValue(depth, 1.0 - kShareWithin, valueOf);
  const float high = highValue(depth, kShareWithin, valueOf);
  const float range = high > low && low > 0.0f ? std::log2(high / low) : 1.0f;
  return drawn(depth, [&](int x, int y) {
    const float value = depth.at(x, y)[0];
    if (std::isnan(value)) return kNanPixel;
    if (!(value > 0.0f)) return kNothing;
    const float place = low > 0.0f ? std::log2(value / low) / range : 1.0f;
    return rgbaOf(mapColor(ColorMap::Viridis, std::clamp(place, 0.0f, 1.0f)));
  });
}

/// Of the luma that the screen shows, 0 to 1.
Picture differencePicture(const Image& color, const Image& warped, float exposure) {
  const auto shown = [&](const Image& image, int x, int y) {
    return srgbEncoded(std::clamp(luminance(glm::vec3(image.texel(x, y))) * exposure, 0.0f, 1.0f));
  };
  return drawn(color, [&](int x, int y) {
    if (warped.at(x, y)[3] <= 0.0f) return kNothing;
    const float difference = std::abs(shown(color, x, y) - shown(warped, x, y));
    if (std::isnan(difference)) return kNanPixel;
    return rgbaOf(mapColor(ColorMap::Inferno, std::min(difference / kFullDifference, 1.0f)));
  });
}

} // namespace

// What is seen at p was drawn at p without this frame's jitter, was there at p minus motion, and was drawn in
// the frame before with that one's jitter.
Image warpedPrevious(const capture::DecodedFrame& frame, const capture::DecodedFrame& previous) {
  const Image &color = frame.color, &from = previous.color, &motion = frame.motion;
  if (color.empty() || color.width != from.width || color.height != from.height) return {};
  const bool hasMotion = motion.width == color.width && motion.height == color.height;
  Image warped(color.width, color.height, 4);
  const glm::vec2 jitter = previous.jitterPx - frame.jitterPx;
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      const glm::vec2 moved = hasMotion ? glm::vec2(motion.texel(x, y)) : glm::vec2(0.0f);
      const glm::vec2 center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const glm::vec2 place = center - moved + jitter;
      const bool isInside = place.x >= 0.0f && place.y >= 0.0f && place.x <= static_cast<float>(from.width) &&
                            place.y <= static_cast<float>(from.height); // false for NaN
      if (!hasPrevious(moved) || !isInside) continue;
      const glm::vec3 value = bilinear(place, [&](int column, int row) {
        const float* texel = from.nearest(column, row);
        return glm::vec3(texel[0], texel[1], texel[2]);
      });
      for (int channel = 0; channel < 3; ++channel) warped.at(x, y)[channel] = value[channel];
      warped.at(x, y)[3] = 1.0f;
    }
  return warped;
}

FramePictures drawFrame(const capture::DecodedFrame& frame, const capture::DecodedFrame* previous,
                        int maxSide) {
  FramePictures pictures;
  pictures.frame = frame.index;
  const int side = shrinkingOf(frame.color, maxSide);
  const Image color = averaged(frame.color, side);
  const float white =
      highValue(color, kShareWithin, [](const glm::vec4& texel) { return luminance(glm::vec3(texel)); });
  const float exposure = white > 0.0f ? 1.0f / white : 1.0f;
  pictures.color = colorPicture(color, exposure);
  pictures.motion = motionPicture(picked(frame.motion, shrinkingOf(frame.motion, maxSide)));
  pictures.depth = depthPicture(picked(frame.depth, shrinkingOf(frame.depth, maxSide)));
  if (!previous) return pictures;
  const Image warped = averaged(warpedPrevious(frame, *previous), side);
  if (warped.empty()) return pictures;
  pictures.warped = colorPicture(warped, exposure);
  pictures.difference = differencePicture(color, warped, exposure);
  return pictures;
}

} // namespace taa
