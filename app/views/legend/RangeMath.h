// Which range shows the values at hand, and which rows have one.
#pragma once

#include "core/base/Image.h"
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

/// Least and greatest of the shown channels; symmetric for signed rows. NaN, Inf and "no previous position"
/// do not count. Nothing when no value is left.
std::optional<ValueRange> autoRange(const Image& values, const Intermediate& row, const ViewStyle& style);

/// How many values of the shown channels lie in each of `bins` equal parts of `scale`; those that autoRange()
/// leaves out do not count.
std::vector<int> histogram(const Image& values, const Intermediate& row, const ViewStyle& style,
                           ValueRange scale, int bins);

/// How visible values are spread.
struct Distribution {
  std::optional<ValueRange> values; ///< as autoRange() has it
  ValueRange scale;                 ///< from the begin of the first bin to the end of the last one
  std::vector<int> counts;
};

/// Of all values, exactly. The scale has room for them and for `range` where that is given. Without bins
/// nothing is counted.
Distribution distributionOf(const Image& values, const Intermediate& row, const ViewStyle& style,
                            const std::optional<ValueRange>& range, int bins);

} // namespace taa::app
