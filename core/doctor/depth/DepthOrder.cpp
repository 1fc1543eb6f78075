#include "core/doctor/depth/DepthOrder.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace taa::doctor {

namespace {

constexpr std::size_t kEnoughHidden = 40;
constexpr int kEnoughHidingFrames = 2;
constexpr double kOneVoiced = 0.95;
/// Of what is left of a depth to the nearer end of 0 to 1: depths that differ by less may be one.
constexpr float kDepthApart = 0.1f;

/// Which of two depths is clearly the greater one: 1 the first, −1 the second, 0 neither.
int compareDepths(float a, float b) {
  const float left = std::min({a, b, 1.0f - a, 1.0f - b});
  if (std::abs(a - b) <= kDepthApart * std::max(left, 1e-7f)) return 0;
  return a > b ? 1 : -1;
}

/// Whether a pixel is of an object by its number, or of the sky, which is at one end or the other.
bool isThing(const DoctorFrame& frame, std::size_t pixel) {
  const float depth = frame.depth.pixels[pixel];
  return frame.objectId[pixel] != 0 || depth == 0.0f || depth == 1.0f;
}

} // namespace

void DepthOrder::add(const DoctorFrame& now, const DoctorFrame& before,
                     const std::vector<RegionIndex>& labels, const std::vector<RegionIndex>& labelsBefore) {
  const glm::ivec2 size = now.sizePx();
  if (now.motionPx.empty() || now.depth.empty() || before.depth.empty() || before.sizePx() != size) return;
  // Parts that no number says end where depth or motion does, which may be anywhere on a surface.
  if (now.objectId.empty() || before.objectId.empty()) return;
  const glm::vec2 rasterStep = before.depthJitterPx - now.depthJitterPx;
  const std::size_t found = pixels();
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
      const glm::vec2 motion = now.motionAt(x, y);
      if (!isThing(now, i) || !isMotion(motion)) continue;
      const auto around = pixelsAround(glm::vec2(x, y) + 0.5f - motion + rasterStep, size);
      if (!around) continue;
      const RegionIndex hiding = labelsBefore[around->front()];
      const bool isHidden = hiding != labels[i] && std::ranges::all_of(*around, [&](std::size_t place) {
                              return labelsBefore[place] == hiding && isThing(before, place);
                            });
      if (!isHidden || !isWide(labels, size, x, y)) continue;
      const int order = compareDepths(before.depth.pixels[around->front()], *now.depth.at(x, y));
      if (order > 0) ++nearer;
      if (order < 0) ++farther;
    }
  if (pixels() > found) ++frames;
}

double DepthOrder::reversedShare() const {
  return pixels() == 0 ? 0.0 : static_cast<double>(farther) / static_cast<double>(pixels());
}

OrderVerdict DepthOrder::verdict() const {
  if (pixels() < kEnoughHidden || frames < kEnoughHidingFrames) return OrderVerdict::TooFew;
  const double share = reversedShare();
  if (share >= kOneVoiced) return OrderVerdict::Reversed;
  return share <= 1.0 - kOneVoiced ? OrderVerdict::Agrees : OrderVerdict::Unclear;
}

} // namespace taa::doctor
