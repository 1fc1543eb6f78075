// How values are spread: what a region of a picture is described by, what a range is fitted to, and the axis
// that a histogram of them has. No GL.
#pragma once

#include "core/base/Image.h"
#include "core/gl/Rect.h"
#include "core/taa/Intermediates.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

/// Shares of the values, in percent, that a spread has percentiles of.
inline constexpr std::array<int, 7> kPercentiles{1, 5, 25, 50, 75, 95, 99};

/// Of the values of one channel.
struct ChannelSpread {
  int count = 0;    ///< finite values: what follows means something where there is one
  int nan = 0;      ///< NaN where there ought to be a value
  int infinite = 0; ///< of either sign
  int absent = 0;   ///< no value by its nature: no previous position, nothing to compare with
  float min = 0.0f, max = 0.0f;
  double mean = 0.0, deviation = 0.0; ///< the deviation of the values themselves, divided by their count
  std::array<float, kPercentiles.size()> percentiles{};
  bool operator==(const ChannelSpread&) const = default;
};

/// From the left end to the right one; places are shares of it.
struct HistogramAxis {
  float low = 0.0f, high = 1.0f; ///< low < high, above 0 where it is logarithmic
  bool isLogarithmic = false;    ///< its left end stands for all that is not above `low`, 0 included
  bool operator==(const HistogramAxis&) const = default;
  double placeOf(double value) const;
  double valueAt(double place) const;
};

/// Has room for finite `values` and `also`, and 5 % beside them. It is logarithmic where the row is never
/// negative, nothing here is, and half of what is above 0 would lie in the first 32nd of an even axis; down
/// to the least value above 0, six decades at most. It begins at 0 rather than below where nothing is.
HistogramAxis axisOf(const std::vector<float>& values, const Intermediate& row,
                     const std::optional<std::pair<float, float>>& also);

/// How many values lie in each of `bins` equal parts of the axis; those beyond it do not count.
std::vector<int> countedOn(const HistogramAxis& axis, const std::vector<float>& values, int bins);

/// What a region of a row holds.
struct RegionSpread {
  gl::Rect region{};
  std::vector<ChannelSpread> channels;
  HistogramAxis axis;
  std::vector<int> counts; ///< of the finite values of all channels, kRegionBins; empty: there is none
  /// Of numbers that stand for something (ids, reasons, masks): how many pixels have each, the most frequent
  /// first; their means would say nothing.
  std::vector<std::pair<int, int>> categories;
  bool operator==(const RegionSpread&) const = default;
};
inline constexpr int kRegionBins = 64;

/// Whether the row's numbers stand for something.
bool isCategorical(const Intermediate& row);

/// `absence`: as ViewResult has it, empty where all values are there.
RegionSpread regionSpread(const Image& values, const Image& absence, const Intermediate& row,
                          const gl::Rect& region);

/// The part of `region` that lies in the picture; nothing where none does.
std::optional<gl::Rect> insidePicture(const gl::Rect& region, int width, int height);

} // namespace taa
