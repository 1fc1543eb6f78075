#include "app/views/legend/RangeMath.h"

#include "core/base/Median.h"
#include "core/render/FrameInputs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace taa::app {

bool hasRange(const Intermediate& row) {
  switch (row.visual) {
  case Visual::Mask:
  case Visual::Index:
  case Visual::Normal:
  case Visual::Position:
    return false;
  default:
    return true;
  }
}

bool hasExposure(const Intermediate& row) {
  return row.visual == Visual::Color;
}

bool usesColorMap(const Intermediate& row, const ViewStyle& style) {
  if (row.visual == Visual::Signed) return true; // of several channels: a difference
  if (row.channels == 1) return row.visual == Visual::Scalar || row.visual == Visual::Depth;
  return shownChannels(row, style) == 1;
}

bool isShown(const ViewStyle& style, int channel) {
  return channel == 0 ? style.red : channel == 1 ? style.green : style.blue;
}

void setShown(ViewStyle& style, int channel, bool shown) {
  (channel == 0 ? style.red : channel == 1 ? style.green : style.blue) = shown;
}

int shownChannels(const Intermediate& row, const ViewStyle& style) {
  int count = 0;
  for (int channel = 0; channel < row.channels; ++channel) count += isShown(style, channel) ? 1 : 0;
  return count;
}

std::vector<float> shownValues(const Image& values, const Intermediate& row, const ViewStyle& style) {
  std::vector<std::size_t> shown;
  for (int channel = 0; channel < std::min(values.channels, row.channels); ++channel)
    if (row.channels == 1 || isShown(style, channel)) shown.push_back(static_cast<std::size_t>(channel));
  const float end = row.visual == Visual::Vector ? kNoPreviousPosition : INFINITY;
  const auto stride = static_cast<std::size_t>(values.channels);
  std::vector<float> found;
  found.reserve(stride > 0 ? values.pixels.size() / stride * shown.size() : 0);
  for (std::size_t pixel = 0; pixel < values.pixels.size(); pixel += stride)
    for (const std::size_t channel : shown) {
      const float value = values.pixels[pixel + channel];
      if (value > -INFINITY && value < end) found.push_back(value); // false of NaN
    }
  return found;
}

std::optional<ValueRange> autoRange(std::vector<float> values, const Intermediate& row) {
  if (values.empty()) return {};
  float low = percentile(values, 1), high = percentile(values, 99);
  if (low == high) {
    low = *std::ranges::min_element(values);
    high = *std::ranges::max_element(values);
  }
  if (row.visual == Visual::Vector || row.visual == Visual::Signed) {
    high = std::max(std::abs(low), std::abs(high));
    low = -high;
  }
  if (high == low) high = low + 1.0f; // one value only: shown as the low end
  return ValueRange{low, high};
}

Distribution distributionOf(const Image& values, const Intermediate& row, const ViewStyle& style,
                            const std::optional<ValueRange>& range, int bins) {
  const std::vector<float> shown = shownValues(values, row, style);
  Distribution found{.values = autoRange(shown, row), .axis = {}, .counts = {}};
  const std::optional<ValueRange> also = range ? range : found.values;
  std::optional<std::pair<float, float>> ends;
  if (also) ends = {also->low, also->high};
  found.axis = axisOf(shown, row, ends);
  if (bins > 0) found.counts = countedOn(found.axis, shown, bins);
  return found;
}

} // namespace taa::app
