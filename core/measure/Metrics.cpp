#include "core/measure/Metrics.h"

#include "core/base/Light.h"
#include "core/measure/ChangedShare.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace taa {

namespace {

template <typename Of>
double meanSquare(const Image& picture, const Image& reference, Of of) {
  double sum = 0.0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        const double difference = of(picture.at(x, y)[channel]) - of(reference.at(x, y)[channel]);
        sum += difference * difference;
      }
  return sum / (3.0 * picture.width * picture.height);
}

double mean(const Image& row) {
  return std::accumulate(row.pixels.begin(), row.pixels.end(), 0.0) / static_cast<double>(row.pixels.size());
}

} // namespace

Image shownColors(const Image& linear) {
  assert(linear.channels >= 3);
  Image colors(linear.width, linear.height, 3);
  for (int y = 0; y < linear.height; ++y)
    for (int x = 0; x < linear.width; ++x)
      std::transform(linear.at(x, y), linear.at(x, y) + 3, colors.at(x, y),
                     [](float value) { return static_cast<float>(shownLight(value)); });
  return colors;
}

PictureError pictureError(const Image& picture, const Image& reference) {
  assert(picture.width == reference.width && picture.height == reference.height);
  assert(picture.channels >= 3 && reference.channels >= 3 && !picture.empty());
  PictureError error;
  error.rmseLinear = std::sqrt(meanSquare(picture, reference, [](float value) { return double(value); }));
  const double square = meanSquare(picture, reference, shownLight);
  error.rmse = std::sqrt(square);
  error.psnr = square == 0.0 ? std::numeric_limits<double>::infinity() : -10.0 * std::log10(square);
  return error;
}

double metricOf(Metric metric, const Image& row) {
  assert(!metricInfo(metric).row.empty() && !metricInfo(metric).isOverTime);
  assert(row.channels == 1 && !row.empty());
  if (metric != Metric::Rejected && metric != Metric::Clipped) return mean(row);
  const std::array rows{ChangedRow{row, 0.0f}}; // 0: kept
  return 100.0 * shareOfChanged(rows);
}

} // namespace taa
