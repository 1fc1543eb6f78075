// Whether two images are equal, and where not.
#include "tests/support/CompareImages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace taa::test {

namespace {

bool agree(float actual, float expected, float tolerance) {
  if (std::isnan(actual) || std::isnan(expected)) return std::isnan(actual) && std::isnan(expected);
  if (std::bit_cast<std::uint32_t>(actual) == std::bit_cast<std::uint32_t>(expected)) return true;
  return std::abs(actual - expected) <= tolerance * std::max(1.0f, std::abs(expected)) && tolerance > 0.0f;
}

} // namespace

std::string difference(const Image& actual, const Image& expected, float tolerance, std::size_t allowed) {
  std::ostringstream text;
  text.precision(9);
  if (actual.width != expected.width || actual.height != expected.height ||
      actual.channels != expected.channels) {
    text << "sizes differ: " << actual.width << " x " << actual.height << " x " << actual.channels << " and "
         << expected.width << " x " << expected.height << " x " << expected.channels;
    return text.str();
  }
  std::size_t count = 0;
  for (int y = 0; y < actual.height; ++y)
    for (int x = 0; x < actual.width; ++x)
      for (int channel = 0; channel < actual.channels; ++channel) {
        const float a = actual.at(x, y)[channel], b = expected.at(x, y)[channel];
        if (agree(a, b, tolerance)) continue;
        if (count++ == 0)
          text << "at (" << x << ", " << y << ") channel " << channel << ": " << a << ", expected " << b;
      }
  if (count <= allowed) return {};
  text << "; " << count << " of " << actual.pixels.size() << " values differ";
  return text.str();
}

Image crop(const Image& image, int x, int y, int width, int height) {
  Image part(width, height, image.channels);
  for (int row = 0; row < height; ++row)
    std::copy_n(image.at(x, y + row), static_cast<std::size_t>(width) * image.channels, part.at(0, row));
  return part;
}

} // namespace taa::test
