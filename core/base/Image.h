// A picture in memory: 32-bit floats, interleaved channels, row 0 at the top (manual, conventions).
#pragma once

#include <glm/vec4.hpp>

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
  bool empty() const { return pixels.empty(); }
};

} // namespace taa
