#include "core/doctor/frames/SharedTexels.h"

#include <algorithm>

namespace taa::doctor {

namespace {

constexpr int kPixelsOfAllRows = 400000;
constexpr std::size_t kEnoughTexelPairs = 1000;
constexpr double kNearlyAllEqual = 0.97, kFewEqual = 0.3;

/// Bit for bit but for the sign of 0: what is no number is not equal to itself.
bool areEqual(const float* a, const float* b, int channels) {
  return std::equal(a, a + channels, b);
}

} // namespace

void SharedTexels::add(const Image& plane) {
  const auto addPair = [&](int x, int y, int dx, int dy) {
    const int place = dx > 0 ? x : y;
    const auto at = [&](int i) { return plane.at(x + i * dx, y + i * dy); };
    const bool isEqual = areEqual(at(0), at(1), plane.channels);
    // Where nothing changes all that is side by side is equal.
    if (isEqual && areEqual(at(0), at(-1), plane.channels) && areEqual(at(1), at(2), plane.channels)) return;
    for (std::size_t i = 0; i < bySide_.size(); ++i) {
      const int side = kLeastSide + static_cast<int>(i);
      Pairs& pairs = bySide_[i];
      const bool isBetween = place % side == side - 1;
      ++(isBetween ? pairs.between : pairs.within);
      if (isEqual) ++(isBetween ? pairs.betweenEqual : pairs.withinEqual);
    }
  };
  // Of larger pictures each seventh row, so that all rows of a square come by.
  const int step = plane.width * plane.height > kPixelsOfAllRows ? 7 : 1;
  for (int y = 1; y + 2 < plane.height; y += step)
    for (int x = 1; x + 2 < plane.width; ++x) {
      addPair(x, y, 1, 0);
      addPair(x, y, 0, 1);
    }
}

std::optional<int> SharedTexels::side() const {
  std::optional<int> out;
  for (std::size_t i = 0; i < bySide_.size(); ++i) {
    const Pairs& pairs = bySide_[i];
    const bool isShared =
        pairs.within >= kEnoughTexelPairs && pairs.between >= kEnoughTexelPairs &&
        static_cast<double>(pairs.withinEqual) >= kNearlyAllEqual * static_cast<double>(pairs.within) &&
        static_cast<double>(pairs.betweenEqual) <= kFewEqual * static_cast<double>(pairs.between);
    if (isShared) out = kLeastSide + static_cast<int>(i);
  }
  return out;
}

} // namespace taa::doctor
