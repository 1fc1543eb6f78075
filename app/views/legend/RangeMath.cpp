#include "app/views/legend/RangeMath.h"

#include "core/render/FrameInputs.h"

#include <algorithm>
#include <cmath>

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

namespace {

/// Calls `take` with each value of the shown channels that means something.
template <typename Take>
void forEachValue(const Image& values, const Intermediate& row, const ViewStyle& style, Take take) {
  std::vector<std::size_t> shown;
  for (int channel = 0; channel < std::min(values.channels, row.channels); ++channel)
    if (row.channels == 1 || isShown(style, channel)) shown.push_back(static_cast<std::size_t>(channel));
  const float end = row.visual == Visual::Vector ? kNoPreviousPosition : INFINITY;
  const auto stride = static_cast<std::size_t>(values.channels);
  for (std::size_t pixel = 0; pixel < values.pixels.size(); pixel += stride)
    for (const std::size_t channel : shown) {
      const float value = values.pixels[pixel + channel];
      if (value > -INFINITY && value < end) take(value); // false of NaN
    }
}

} // namespace

std::vector<int> histogram(const Image& values, const Intermediate& row, const ViewStyle& style,
                           ValueRange scale, int bins) {
  std::vector<int> counts(static_cast<std::size_t>(bins), 0);
  forEachValue(values, row, style, [&](float value) {
    const float place = (value - scale.low) / (scale.high - scale.low) * static_cast<float>(bins);
    if (place < 0.0f || place > static_cast<float>(bins)) return;
    ++counts[std::min(static_cast<std::size_t>(place), counts.size() - 1)];
  });
  return counts;
}

std::optional<ValueRange> autoRange(const Image& values, const Intermediate& row, const ViewStyle& style) {
  float low = INFINITY, high = -INFINITY;
  forEachValue(values, row, style, [&](float value) {
    low = std::min(low, value);
    high = std::max(high, value);
  });
  if (low > high) return {};
  if (row.visual == Visual::Vector || row.visual == Visual::Signed) {
    high = std::max(std::abs(low), std::abs(high));
    low = -high;
  }
  if (high == low) high = low + 1.0f; // one value only: shown as the low end
  return ValueRange{low, high};
}

// With a little room beside it to move the ends outwards.
Distribution distributionOf(const Image& values, const Intermediate& row, const ViewStyle& style,
                            const std::optional<ValueRange>& range, int bins) {
  Distribution found{.values = autoRange(values, row, style), .scale = {}, .counts = {}};
  const ValueRange inner = found.values.value_or(range.value_or(ValueRange{}));
  const ValueRange also = range.value_or(inner);
  const float low = std::min({inner.low, also.low, also.high});
  const float high = std::max({inner.high, also.low, also.high});
  const float room = 0.05f * std::max(high - low, 1e-6f);
  found.scale = {low - room, high + room};
  if (bins > 0) found.counts = histogram(values, row, style, found.scale, bins);
  return found;
}

} // namespace taa::app
