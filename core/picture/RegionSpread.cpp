#include "core/picture/RegionSpread.h"

#include "core/base/Median.h"
#include "core/render/FrameInputs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>

namespace taa {

namespace {

constexpr double kAxisRoom = 0.05;    ///< beside the values, share of what they span
constexpr double kCrowded = 1.0 / 32; ///< of an even axis: half of the values in it are too many
constexpr double kAxisDecades = 6.0;

bool isNeverNegative(const Intermediate& row) {
  return row.low >= 0.0f && row.visual != Visual::Signed && row.visual != Visual::Vector &&
         row.visual != Visual::Normal;
}

struct ValueEnds {
  float min = INFINITY, max = -INFINITY;
  void add(float value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
};

/// The values above 0 where they crowd at the left of an axis up to `high`; else nothing.
std::vector<float> crowdedAtLeft(const std::vector<float>& values, float high) {
  std::vector<float> above;
  std::ranges::copy_if(values, std::back_inserter(above), [](float value) { return value > 0.0f; });
  if (above.empty()) return {};
  const float middle = percentile(above, 50);
  return static_cast<double>(middle) < kCrowded * static_cast<double>(high) ? above : std::vector<float>();
}

HistogramAxis logarithmicAxis(const std::vector<float>& above, float high) {
  const double top = static_cast<double>(high);
  const double least =
      std::max(static_cast<double>(*std::ranges::min_element(above)), top * std::pow(10.0, -kAxisDecades));
  const double room = std::pow(top / least, kAxisRoom);
  return {static_cast<float>(least / room), static_cast<float>(top * room), true};
}

} // namespace

double HistogramAxis::placeOf(double value) const {
  const auto from = static_cast<double>(low), to = static_cast<double>(high);
  if (!isLogarithmic) return (value - from) / (to - from);
  return value <= from ? 0.0 : std::log(value / from) / std::log(to / from);
}

double HistogramAxis::valueAt(double place) const {
  const auto from = static_cast<double>(low), to = static_cast<double>(high);
  if (!isLogarithmic) return from + place * (to - from);
  return place <= 0.0 ? 0.0 : from * std::pow(to / from, place);
}

HistogramAxis axisOf(const std::vector<float>& values, const Intermediate& row,
                     const std::optional<std::pair<float, float>>& also) {
  ValueEnds ends;
  for (const float value : values) ends.add(value);
  if (also) {
    ends.add(also->first);
    ends.add(also->second);
  }
  if (ends.min > ends.max) return {};
  const bool startsAtZero = isNeverNegative(row) && ends.min >= 0.0f;
  if (startsAtZero)
    if (const std::vector<float> above = crowdedAtLeft(values, ends.max); !above.empty())
      return logarithmicAxis(above, ends.max);
  const double span = static_cast<double>(ends.max) - static_cast<double>(ends.min);
  const double room =
      span > 0.0 ? kAxisRoom * span : std::max(1.0, std::fabs(static_cast<double>(ends.max))) / 2;
  const double low = static_cast<double>(ends.min) - room;
  return {static_cast<float>(startsAtZero ? std::max(0.0, low) : low),
          static_cast<float>(static_cast<double>(ends.max) + room)};
}

std::vector<int> countedOn(const HistogramAxis& axis, const std::vector<float>& values, int bins) {
  std::vector<int> counts(static_cast<std::size_t>(bins), 0);
  for (const float value : values) {
    const double place = axis.placeOf(static_cast<double>(value)) * bins;
    if (place < 0.0 || place > bins) continue;
    ++counts[std::min(static_cast<std::size_t>(place), counts.size() - 1)];
  }
  return counts;
}

bool isCategorical(const Intermediate& row) {
  return row.visual == Visual::Index || row.visual == Visual::Mask;
}

namespace {

/// Takes the values of one channel in turn.
class SpreadMaker {
 public:
  explicit SpreadMaker(std::vector<float>& finite) : finite_(finite) {}
  void takeAbsent() { ++spread_.absent; }
  void take(float value) {
    if (std::isnan(value))
      ++spread_.nan;
    else if (std::isinf(value))
      ++spread_.infinite;
    else
      finite_.push_back(value);
  }
  ChannelSpread made();

 private:
  std::vector<float>& finite_;
  ChannelSpread spread_;
};

ChannelSpread SpreadMaker::made() {
  spread_.count = static_cast<int>(finite_.size());
  if (finite_.empty()) return spread_;
  spread_.min = *std::ranges::min_element(finite_);
  spread_.max = *std::ranges::max_element(finite_);
  double sum = 0.0, squares = 0.0;
  for (const float value : finite_) sum += static_cast<double>(value);
  spread_.mean = sum / spread_.count;
  for (const float value : finite_) {
    const double away = static_cast<double>(value) - spread_.mean;
    squares += away * away;
  }
  spread_.deviation = std::sqrt(squares / spread_.count);
  for (std::size_t index = 0; index < kPercentiles.size(); ++index)
    spread_.percentiles[index] = percentile(finite_, kPercentiles[index]);
  return spread_;
}

std::vector<std::pair<int, int>> categoryCounts(const std::vector<float>& values) {
  std::map<int, int> counts;
  for (const float value : values) ++counts[static_cast<int>(value)];
  std::vector<std::pair<int, int>> categories(counts.begin(), counts.end());
  std::ranges::stable_sort(categories, std::ranges::greater(), &std::pair<int, int>::second);
  return categories;
}

} // namespace

RegionSpread regionSpread(const Image& values, const Image& absence, const Intermediate& row,
                          const gl::Rect& region) {
  RegionSpread spread{.region = region, .channels = {}, .axis = {}, .counts = {}, .categories = {}};
  std::vector<float> all;
  const auto isNothing = [&](float value) {
    return row.visual == Visual::Vector && value >= kNoPreviousPosition && !std::isinf(value);
  };
  for (int channel = 0; channel < std::min(values.channels, row.channels); ++channel) {
    std::vector<float> finite;
    SpreadMaker maker(finite);
    for (int y = 0; y < values.height; ++y)
      for (int x = 0; x < values.width; ++x) {
        const float value = values.at(x, y)[channel];
        if ((!absence.empty() && *absence.at(x, y) != 0.0f) || isNothing(value))
          maker.takeAbsent();
        else
          maker.take(value);
      }
    spread.channels.push_back(maker.made());
    all.insert(all.end(), finite.begin(), finite.end());
  }
  if (isCategorical(row)) spread.categories = categoryCounts(all);
  if (all.empty()) return spread;
  spread.axis = axisOf(all, row, {});
  spread.counts = countedOn(spread.axis, all, kRegionBins);
  return spread;
}

std::optional<gl::Rect> insidePicture(const gl::Rect& region, int width, int height) {
  const int left = std::max(0, region.x), top = std::max(0, region.y);
  const int right = std::min(width, region.x + region.width);
  const int bottom = std::min(height, region.y + region.height);
  if (right <= left || bottom <= top) return {};
  return gl::Rect{left, top, right - left, bottom - top};
}

} // namespace taa
