// A picture in memory: 32-bit floats, interleaved channels, row 0 at the top (manual, conventions).
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace taa {

struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;          ///< 1 to 4
  std::vector<float> pixels; ///< width · height · channels values

  Image() = default;
  Image(int width_, int height_, int channels_)
      : width(width_), height(height_), channels(channels_),
        pixels(static_cast<std::size_t>(width_) * height_ * channels_, 0.0f) {}

  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    return (static_cast<std::size_t>(y) * width + x) * channels;
  }
  float* at(int x, int y) { return pixels.data() + index(x, y); }
  const float* at(int x, int y) const { return pixels.data() + index(x, y); }

  /// The pixel with missing channels 0.
  glm::vec4 texel(int x, int y) const {
    glm::vec4 value(0.0f);
    for (int channel = 0; channel < channels; ++channel) value[channel] = at(x, y)[channel];
    return value;
  }
  /// The pixel; of a place beyond the border the nearest at it.
  const float* nearest(int x, int y) const {
    return at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
  }
  bool empty() const { return pixels.empty(); }
};

/// Bilinear between the centers of pixels at a place, px. `texel(x, y)` is asked for pixels beyond the
/// border, too.
template <typename Texel>
auto bilinear(const glm::vec2& positionPx, const Texel& texel) {
  const glm::vec2 place = positionPx - 0.5f, corner = glm::floor(place), part = place - corner;
  const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
  const auto above = (1.0f - part.x) * texel(x, y) + part.x * texel(x + 1, y);
  const auto below = (1.0f - part.x) * texel(x, y + 1) + part.x * texel(x + 1, y + 1);
  return (1.0f - part.y) * above + part.y * below;
}

} // namespace taa
