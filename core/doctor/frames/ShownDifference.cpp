#include "core/doctor/frames/ShownDifference.h"

#include "core/doctor/frames/Regions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa::doctor {

namespace {

// What one sees: px, |log| of a distance, luma of comparedLuma().
constexpr double kSeenJitterPx = 0.05, kSeenMotionPx = 0.25, kSeenDepth = 0.02, kSeenLuma = 0.01;
// A motion that is none, and a distance to nothing, are so far from any other.
constexpr double kFarthestPx = 16.0, kFarthestLog = 2.0;
/// Of the other difference, with room for rounding to half floats.
constexpr double kSmallShare = 0.1, kHalfRounding = 1e-3;

double motionBetween(const DoctorFrame& a, const DoctorFrame& b, int x, int y) {
  const glm::vec2 ofA = a.motionAt(x, y), ofB = b.motionAt(x, y);
  if (!isMotion(ofA) || !isMotion(ofB)) return isMotion(ofA) == isMotion(ofB) ? 0.0 : kFarthestPx;
  return std::min(static_cast<double>(glm::distance(ofA, ofB)), kFarthestPx);
}

double depthBetween(float a, float b) {
  if (!(a > 0.0f) || !(b > 0.0f)) return (a > 0.0f) == (b > 0.0f) ? 0.0 : kFarthestLog;
  return std::min(std::abs(std::log(static_cast<double>(a) / static_cast<double>(b))), kFarthestLog);
}

/// Of outputs as large as what is drawn; what is no number is as far as can be from what is one.
double outputBetween(const DoctorFrame& a, const DoctorFrame& b, int x, int y) {
  const auto hasIt = [](const DoctorFrame& frame) {
    return frame.output.width == frame.luma.width && frame.output.height == frame.luma.height;
  };
  if (!hasIt(a) || !hasIt(b)) return 0.0;
  const auto bounded = [&](const DoctorFrame& frame) {
    const double green = frame.output.at(x, y)[1];
    return green / (1.0 + green);
  };
  const double ofA = bounded(a), ofB = bounded(b);
  if (std::isnan(ofA) || std::isnan(ofB)) return std::isnan(ofA) == std::isnan(ofB) ? 0.0 : 1.0;
  return std::abs(ofA - ofB);
}

} // namespace

void ShownDifference::add(const DoctorFrame& a, const DoctorFrame& b) {
  // Nothing reads motion where history starts anew.
  const bool usesMotion = !a.motionPx.empty() && !(a.startsHistory && b.startsHistory);
  std::size_t seen = 0;
  double motion = 0.0, depths = 0.0, lumas = 0.0, outputs = 0.0;
  for (int y = 0; y < a.luma.height; ++y)
    for (int x = 0; x < a.luma.width; ++x) {
      const double moved = usesMotion ? motionBetween(a, b, x, y) : 0.0;
      const double farther =
          a.depthView.empty() ? 0.0 : depthBetween(*a.depthView.at(x, y), *b.depthView.at(x, y));
      const double lighter = std::abs(static_cast<double>(*a.luma.at(x, y) - *b.luma.at(x, y)));
      const double resolved = outputBetween(a, b, x, y);
      motion += moved;
      depths += farther;
      lumas += lighter;
      outputs += resolved;
      if (moved > kSeenMotionPx || farther > kSeenDepth || lighter > kSeenLuma || resolved > kSeenLuma)
        ++seen;
    }
  const double pixels = static_cast<double>(a.luma.width) * a.luma.height;
  const auto jittered = static_cast<double>(glm::distance(a.jitterPx, b.jitterPx));
  ++frames;
  jitterPx += jittered;
  motionPx += motion / pixels;
  depth += depths / pixels;
  luma += lumas / pixels;
  output += outputs / pixels;
  if (seen >= kLeastPart || jittered > kSeenJitterPx || a.startsHistory != b.startsHistory) ++shown;
}

bool ShownDifference::isSmallBeside(const ShownDifference& other) const {
  const auto isSmall = [&](double ShownDifference::*sum) {
    return this->*sum <= kSmallShare * other.*sum + kHalfRounding * frames;
  };
  return isSmall(&ShownDifference::jitterPx) && isSmall(&ShownDifference::motionPx) &&
         isSmall(&ShownDifference::depth) && isSmall(&ShownDifference::luma) &&
         isSmall(&ShownDifference::output);
}

} // namespace taa::doctor
