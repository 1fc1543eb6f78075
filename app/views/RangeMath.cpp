#include "app/views/RangeMath.h"

#include "core/render/FrameInputs.h"

#include <algorithm>
#include <cmath>

namespace taa::app {

ViewStyle differenceStyle(const Intermediate& row) {
  ViewStyle style = defaultStyle(row);
  const float span = row.high - row.low;
  style.high = span > 0.0f ? span / 4.0f : 1.0f;
  style.low = -style.high;
  style.map = ColorMap::Diverging;
  return style;
}

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
  const int stride = values.channels;
  for (std::size_t i = 0; i < values.pixels.size(); ++i) {
    const int channel = static_cast<int>(i % static_cast<std::size_t>(stride));
    const float value = values.pixels[i];
    if (channel >= row.channels || (row.channels > 1 && !isShown(style, channel))) continue;
    if (!std::isfinite(value) || (row.visual == Visual::Vector && value >= kNoPreviousPosition)) continue;
    take(value);
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

} // namespace taa::app
