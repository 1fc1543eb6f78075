// Which range shows the values at hand, and which rows have one.
#pragma once

#include "core/base/Image.h"
#include "core/picture/RegionSpread.h"
#include "core/picture/Visualizer.h"

#include <optional>
#include <vector>

namespace taa::app {

struct ValueRange {
  float low = 0.0f, high = 1.0f;
  bool operator==(const ValueRange&) const = default;
};

/// Whether low and high mean something for this row (ids, masks, normals and positions have their own scale).
bool hasRange(const Intermediate& row);
/// Whether exposure means something: colors.
bool hasExposure(const Intermediate& row);
/// Whether a color map is used: one channel, or one channel of several shown alone.
bool usesColorMap(const Intermediate& row, const ViewStyle& style);
/// How many of red, green and blue are shown.
int shownChannels(const Intermediate& row, const ViewStyle& style);
/// Whether channel 0…2 is shown.
bool isShown(const ViewStyle& style, int channel);
void setShown(ViewStyle& style, int channel, bool shown);

/// The values of the shown channels; NaN, Inf and "no previous position" do not count.
std::vector<float> shownValues(const Image& values, const Intermediate& row, const ViewStyle& style);

/// From the first to the 99th percentile of the values, so that a few of them leave the others their
/// contrast; symmetric for signed rows. From the least to the greatest where those two are the same. Nothing
/// without a value.
std::optional<ValueRange> autoRange(std::vector<float> values, const Intermediate& row);

/// How visible values are spread.
struct Distribution {
  std::optional<ValueRange> values; ///< as autoRange() has it
  HistogramAxis axis;
  std::vector<int> counts;
};

/// Of all values, exactly. The axis has room for them and for `range` where that is given. Without bins
/// nothing is counted.
Distribution distributionOf(const Image& values, const Intermediate& row, const ViewStyle& style,
                            const std::optional<ValueRange>& range, int bins);

} // namespace taa::app
