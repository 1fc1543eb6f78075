#include "core/verdict/parts/WorstPixels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <tuple>

namespace taa {

namespace {

bool isLocalMaximum(const Badness& badness, int x, int y) {
  const float own = *badness.at(x, y);
  if (!(own > 0.0f)) return false;
  for (int row = std::max(0, y - 1); row <= std::min(badness.height - 1, y + 1); ++row)
    for (int column = std::max(0, x - 1); column <= std::min(badness.width - 1, x + 1); ++column)
      if (*badness.at(column, row) > own) return false;
  return true;
}

bool isWithin(const WorstPixel& a, const WorstPixel& b, int apartPx) {
  return std::abs(a.pixel.x - b.pixel.x) <= apartPx && std::abs(a.pixel.y - b.pixel.y) <= apartPx;
}

} // namespace

Badness amounts(const Image& row) {
  Badness badness(row.width, row.height, 1);
  for (std::size_t pixel = 0; pixel < badness.pixels.size(); ++pixel)
    for (int channel = 0; channel < row.channels; ++channel)
      if (const float amount = std::fabs(
              row.pixels[pixel * static_cast<std::size_t>(row.channels) + static_cast<std::size_t>(channel)]);
          amount > badness.pixels[pixel])
        badness.pixels[pixel] = amount;
  return badness;
}

Badness ofCategory(const Image& categories, int category, const Image& weight) {
  assert(categories.channels == 1 && weight.channels == 1 && categories.width == weight.width);
  Badness badness = amounts(weight);
  for (std::size_t pixel = 0; pixel < badness.pixels.size(); ++pixel)
    badness.pixels[pixel] = static_cast<int>(categories.pixels[pixel]) == category
                                ? std::max(badness.pixels[pixel], std::numeric_limits<float>::min())
                                : 0.0f;
  return badness;
}

std::vector<WorstPixel> worstPixels(const Badness& badness, int count, int apartPx) {
  std::vector<WorstPixel> maxima, worst;
  for (int y = 0; y < badness.height; ++y)
    for (int x = 0; x < badness.width; ++x)
      if (isLocalMaximum(badness, x, y)) maxima.push_back({{x, y}, *badness.at(x, y)});
  std::ranges::sort(maxima, {}, [](const WorstPixel& found) {
    return std::tuple(-found.badness, found.pixel.y, found.pixel.x);
  });
  for (const WorstPixel& found : maxima) {
    if (static_cast<int>(worst.size()) >= count) break;
    if (std::ranges::none_of(worst, [&](const WorstPixel& worse) { return isWithin(worse, found, apartPx); }))
      worst.push_back(found);
  }
  return worst;
}

} // namespace taa
