// Pictures made by hand for what compares pictures.
#pragma once

#include "core/base/Image.h"

#include <glm/vec3.hpp>

#include <functional>
#include <numeric>

namespace taa::test {

inline Image pictureOf(int width, int height, const std::function<glm::vec3(int x, int y)>& color) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel) image.at(x, y)[channel] = color(x, y)[channel];
  return image;
}

inline Image flatPicture(int width, int height, const glm::vec3& color) {
  return pictureOf(width, height, [color](int, int) { return color; });
}

/// Black, and white from a column on.
inline Image stepPicture(int width, int height, int column) {
  return pictureOf(width, height, [column](int x, int) { return glm::vec3(x >= column ? 1.0f : 0.0f); });
}

/// A color of its own in nearly every pixel, 0 to 1 in each channel.
inline glm::vec3 patternColor(int x, int y) {
  return {float((7 * x + 3 * y) % 11) / 10.0f, float((5 * x + 2 * y) % 13) / 12.0f,
          float((3 * x + 11 * y) % 7) / 6.0f};
}

inline double meanOf(const Image& map) {
  return std::accumulate(map.pixels.begin(), map.pixels.end(), 0.0) / double(map.pixels.size());
}

} // namespace taa::test
