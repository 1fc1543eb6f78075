#include "core/doctor/frames/Detail.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa::doctor {

namespace {

/// `counts`: whether a pixel beside it, x and y, is one to compare with.
template <typename Counts>
bool standsOut(const Image& luma, int x, int y, Counts counts) {
  constexpr float kLeastDetailOfLuma = 0.004f;
  constexpr int kReach = 2;
  float sum = 0.0f;
  int count = 0;
  for (int v = std::max(0, y - kReach); v <= std::min(luma.height - 1, y + kReach); ++v)
    for (int u = std::max(0, x - kReach); u <= std::min(luma.width - 1, x + kReach); ++u) {
      if (!counts(u, v)) continue;
      sum += *luma.at(u, v);
      ++count;
    }
  return count > 0 && std::abs(*luma.at(x, y) - sum / static_cast<float>(count)) >= kLeastDetailOfLuma;
}

} // namespace

bool hasDetail(const Image& luma, int x, int y) {
  return standsOut(luma, x, y, [](int, int) { return true; });
}

bool hasDetail(const Image& luma, const std::vector<RegionIndex>& labels, int x, int y) {
  const auto labelAt = [&](int u, int v) { return labels[static_cast<std::size_t>(v) * luma.width + u]; };
  return standsOut(luma, x, y, [&](int u, int v) { return labelAt(u, v) == labelAt(x, y); });
}

bool skyHasDetail(const DoctorFrame& frame, int x, int y) {
  bool isAllSky = true;
  const auto counts = [&](int u, int v) {
    isAllSky &= frame.isSky(static_cast<std::size_t>(v) * frame.luma.width + u);
    return true;
  };
  return standsOut(frame.luma, x, y, counts) && isAllSky;
}

} // namespace taa::doctor
