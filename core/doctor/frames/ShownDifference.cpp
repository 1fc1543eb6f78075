#include "core/doctor/frames/ShownDifference.h"

#include "core/capture/import/FrameSamples.h"
#include "core/doctor/frames/Regions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace taa::doctor {

namespace {

// What one sees: px, |log| of a distance, luma of comparedLuma().
constexpr double kSeenJitterPx = 0.05, kSeenDepth = 0.02, kSeenLuma = 0.01;
/// So few may hold a value that is none: what a resolve makes of that shows in the output.
constexpr std::size_t kSpeckPixels = 16;
// A motion that is none, and a distance to nothing, are so far from any other.
constexpr double kFarthestPx = 16.0, kFarthestLog = 2.0;
/// Of the other difference, with room for rounding to half floats.
constexpr double kSmallShare = 0.1, kHalfRounding = 1e-3;

double motionBetween(const DoctorFrame& a, const DoctorFrame& b, int x, int y) {
  const glm::vec2 ofA = a.motionAt(x, y), ofB = b.motionAt(x, y);
  if (!isMotion(ofA) || !isMotion(ofB)) return isMotion(ofA) == isMotion(ofB) ? 0.0 : kFarthestPx;
  return std::min(static_cast<double>(glm::distance(ofA, ofB)), kFarthestPx);
}

/// Light of the frame before where a pixel was that moves like this; NaN: beyond the picture, or there was
/// none.
double lightRead(const DoctorFrame& frame, const DoctorFrame& before, const glm::ivec2& pixel,
                 const glm::vec2& motionPx) {
  constexpr double kNoLight = std::numeric_limits<double>::quiet_NaN();
  if (!isMotion(motionPx)) return kNoLight;
  const glm::vec2 place = glm::vec2(pixel) + 0.5f - motionPx + before.jitterPx - frame.jitterPx;
  const glm::vec2 size(frame.sizePx());
  // Comparisons are written so that NaN fails them.
  if (!(place.x >= 0.0f && place.y >= 0.0f && place.x <= size.x && place.y <= size.y)) return kNoLight;
  return static_cast<double>(capture::betweenPixels(before.luma, place));
}

/// How far a pixel is from what was read for it; NaN: nothing was.
double contradictionAt(const ReadFrame& frame, const glm::ivec2& pixel) {
  const glm::vec2 motion = frame.now.motionAt(pixel.x, pixel.y);
  const double read = lightRead(frame.now, *frame.before, pixel, motion);
  return std::abs(static_cast<double>(*frame.now.luma.at(pixel.x, pixel.y)) - read);
}

/// Whether a frame contradicts the one before it more than one without the fault does.
bool isContradicted(const ReadFrame& faulty, const ReadFrame& sound, const glm::ivec2& pixel) {
  const double ofFaulty = contradictionAt(faulty, pixel), ofSound = contradictionAt(sound, pixel);
  // Only one of them says that there is something to read.
  if (std::isnan(ofFaulty) || std::isnan(ofSound)) return std::isnan(ofFaulty) != std::isnan(ofSound);
  return ofFaulty > ofSound + kSeenLuma;
}

double depthBetween(float a, float b) {
  if (!(a > 0.0f) || !(b > 0.0f)) return (a > 0.0f) == (b > 0.0f) ? 0.0 : kFarthestLog;
  return std::min(std::abs(std::log(static_cast<double>(a) / static_cast<double>(b))), kFarthestLog);
}

/// What is no number in one of them is left to the output, in which it spreads.
double lightBetween(float a, float b) {
  const double apart = std::abs(static_cast<double>(a - b));
  return std::isnan(apart) ? 0.0 : apart;
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

void ShownDifference::add(const ReadFrame& faulty, const ReadFrame& sound) {
  const DoctorFrame &a = faulty.now, &b = sound.now;
  // Nothing reads motion where history starts anew.
  const bool usesMotion = !a.motionPx.empty() && !(a.startsHistory && b.startsHistory);
  const bool isRead = usesMotion && faulty.before && sound.before;
  std::size_t seen = 0, seenInOutput = 0, lighterPixels = 0;
  double motion = 0.0, depths = 0.0, lumas = 0.0, outputs = 0.0;
  for (int y = 0; y < a.luma.height; ++y)
    for (int x = 0; x < a.luma.width; ++x) {
      const double farther =
          a.depthView.empty() ? 0.0 : depthBetween(*a.depthView.at(x, y), *b.depthView.at(x, y));
      const double lighter = lightBetween(*a.luma.at(x, y), *b.luma.at(x, y));
      const double resolved = outputBetween(a, b, x, y);
      if (usesMotion) motion += motionBetween(a, b, x, y);
      depths += farther;
      lumas += lighter;
      outputs += resolved;
      if (lighter > kSeenLuma) ++lighterPixels;
      if (farther > kSeenDepth || (isRead && isContradicted(faulty, sound, {x, y}))) ++seen;
      if (resolved > kSeenLuma) ++seenInOutput;
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
  if (seenInOutput >= kLeastPart) ++shownInOutput;
  if (lighterPixels > kSpeckPixels) ++lit;
}

bool ShownDifference::shows() const {
  if (shown > 0) return true;
  const bool isGivenTheSame = jitterPx == 0.0 && motionPx == 0.0 && depth == 0.0 && lit == 0;
  return isGivenTheSame && shownInOutput > 0;
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
