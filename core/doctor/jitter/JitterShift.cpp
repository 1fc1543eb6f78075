#include "core/doctor/jitter/JitterShift.h"

#include "core/base/Median.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/frames/Detail.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

constexpr double kShiftSamples = 6000.0;
constexpr std::size_t kLeastShiftSamples = 200;
constexpr int kShiftReachPx = 2;
constexpr int kShiftSteps = 8;
constexpr double kConvergedPx = 1e-3, kFarthestStepPx = 0.5;
/// Of luma per px, squared, in the mean: with less detail along some direction there is nothing to measure.
constexpr double kLeastDetail = 2e-6;
/// Of what one place leaves: another one is told only where it leaves less than this share.
constexpr double kClearlyLess = 0.9;

std::optional<glm::vec2> restingMotion(const DoctorFrame& frame, const glm::ivec2& pixel) {
  if (frame.previousClipFromClip) return cameraMotionPx(frame, pixel);
  if (frame.motionPx.empty()) return {};
  const glm::vec2 given = frame.motionAt(pixel.x, pixel.y);
  if (!isMotion(given)) return {};
  return given;
}

double medianDifference(const std::vector<SearchedPixel>& samples, const Image& luma,
                        const glm::vec2& shift) {
  std::vector<double> differences;
  for (const SearchedPixel& sample : samples)
    differences.push_back(
        std::abs(static_cast<double>(sample.luma - capture::betweenPixels(luma, sample.place + shift))));
  return upperMedian(std::move(differences));
}

/// Sums of weighted least squares for the step that the shift lacks: A · step = b.
struct NormalEquations {
  double xx = 0.0, xy = 0.0, yy = 0.0, bx = 0.0, by = 0.0, weight = 0.0;

  void add(const glm::dvec2& slope, double difference, double w) {
    xx += w * slope.x * slope.x;
    xy += w * slope.x * slope.y;
    yy += w * slope.y * slope.y;
    bx += w * slope.x * difference;
    by += w * slope.y * difference;
    weight += w;
  }
  double determinant() const { return xx * yy - xy * xy; }
  /// Mean detail along the direction that has least.
  double leastDetail() const {
    const double half = 0.5 * (xx + yy);
    return weight > 0.0 ? (half - std::sqrt(std::max(0.0, half * half - determinant()))) / weight : 0.0;
  }
  glm::dvec2 step() const { return glm::dvec2(bx * yy - by * xy, by * xx - bx * xy) / determinant(); }
};

NormalEquations equationsAt(const std::vector<SearchedPixel>& samples, const Image& luma,
                            const glm::vec2& shift) {
  const double scale = std::max(1e-4, kTukeyMedians * medianDifference(samples, luma, shift));
  NormalEquations out;
  for (const SearchedPixel& sample : samples) {
    const glm::vec2 place = sample.place + shift;
    const auto at = [&](float x, float y) {
      return static_cast<double>(capture::betweenPixels(luma, place + glm::vec2(x, y)));
    };
    const double difference = static_cast<double>(sample.luma) - at(0.0f, 0.0f);
    const double weight = tukeyWeight(difference, scale);
    if (weight == 0.0) continue;
    out.add({at(0.5f, 0.0f) - at(-0.5f, 0.0f), at(0.0f, 0.5f) - at(0.0f, -0.5f)}, difference, weight);
  }
  return out;
}

/// The shift near `shift` that fits best; nothing where there is too little detail, or it runs away.
std::optional<glm::vec2> refinedShift(const std::vector<SearchedPixel>& samples, const Image& luma,
                                      glm::vec2 shift) {
  for (int i = 0; i < kShiftSteps; ++i) {
    const NormalEquations equations = equationsAt(samples, luma, shift);
    if (!(equations.leastDetail() >= kLeastDetail)) return {};
    const glm::dvec2 step = equations.step();
    const double length = glm::length(step);
    if (!(length <= kFarthestStepPx)) return {};
    shift += glm::vec2(step);
    if (length < kConvergedPx) break;
  }
  return shift;
}

/// In a grid of so many pixels apart.
ShiftSamples samplesEvery(int step, const FrameNeighbors& frames) {
  const DoctorFrame& now = frames.now;
  const glm::ivec2 size = now.sizePx();
  const double pixels = static_cast<double>(size.x) * size.y;
  const glm::vec2 margin(kFarthestShiftPx + 0.5f), last = glm::vec2(size) - margin;
  ShiftSamples out;
  for (int y = step / 2; y < size.y; y += step)
    for (int x = step / 2; x < size.x; x += step) {
      const bool isSky = now.isSky(static_cast<std::size_t>(y) * size.x + x);
      if (isSky) out.skyShare += static_cast<double>(step) * step / pixels;
      const auto motionPx = restingMotion(now, {x, y});
      if (!motionPx || now.isCovered({x, y})) continue;
      if (!(isSky ? skyHasDetail(now, x, y) : hasDetail(now.luma, x, y))) continue;
      const glm::vec2 place = glm::vec2(x, y) + 0.5f - *motionPx;
      if (place.x < margin.x || place.y < margin.y || place.x > last.x || place.y > last.y) continue;
      if (frames.before.isCovered(glm::ivec2(place))) continue;
      out.longestPx = std::max(out.longestPx, static_cast<double>(glm::length(*motionPx)));
      (isSky ? out.sky : out.world).push_back({place, *now.luma.at(x, y)});
    }
  return out;
}

} // namespace

ShiftSamples shiftSamples(const FrameNeighbors& frames) {
  const glm::ivec2 size = frames.now.sizePx();
  const double pixels = static_cast<double>(size.x) * size.y;
  int step = std::max(1, static_cast<int>(std::sqrt(pixels / kShiftSamples)));
  ShiftSamples out = samplesEvery(step, frames);
  const bool isSparse = !areEnough(out.world);
  // Where little has detail all of it is looked at.
  while (step > 1 && !areEnough(out.world)) {
    step = (step + 1) / 2;
    out = samplesEvery(step, frames);
  }
  out.isSparse = isSparse;
  return out;
}

bool areEnough(const std::vector<SearchedPixel>& samples) {
  return samples.size() >= kLeastShiftSamples;
}

double lumaLeft(const std::vector<SearchedPixel>& samples, const Image& previousLuma,
                const glm::vec2& shiftPx) {
  return medianDifference(samples, previousLuma, shiftPx);
}

std::optional<glm::vec2> measureShift(const std::vector<SearchedPixel>& samples,
                                      const FrameNeighbors& frames) {
  const auto rough = searchMotion(samples, frames.before.luma, glm::vec2(0.0f), kShiftReachPx);
  if (!rough) return {};
  // What repeats fits at many places: then the one that is stated is as good as any other. None is no start:
  // lines that snap to pixels stay where they are for a while.
  std::optional<glm::vec2> best;
  double least = std::numeric_limits<double>::infinity();
  for (const glm::vec2& start : {frames.jitterStep(), -*rough}) {
    const auto shift = refinedShift(samples, frames.before.luma, start);
    const double left = shift ? medianDifference(samples, frames.before.luma, *shift) : least;
    if (!(left < kClearlyLess * least)) continue;
    best = shift;
    least = left;
  }
  return best;
}

std::optional<double> measureShare(const std::vector<SearchedPixel>& samples, const FrameNeighbors& frames) {
  constexpr float kLeastStepPx = 0.1f, kHalfSlope = 0.25f;
  constexpr double kFarthestShare = 3.0, kClearlyLess = 0.6;
  const glm::vec2 step = frames.jitterStep();
  if (!(glm::length(step) >= kLeastStepPx)) return {};
  const Image& luma = frames.before.luma;
  const auto left = [&](double share) {
    return medianDifference(samples, luma, static_cast<float>(share) * step);
  };
  double share = left(0.0) < left(1.0) ? 0.0 : 1.0;
  for (int i = 0; i < kShiftSteps; ++i) {
    const double scale = std::max(1e-6, kTukeyMedians * left(share));
    double slopes = 0.0, products = 0.0;
    for (const SearchedPixel& sample : samples) {
      const auto at = [&](float more) {
        const glm::vec2 place = sample.place + (static_cast<float>(share) + more) * step;
        return static_cast<double>(capture::betweenPixels(luma, place));
      };
      const double difference = static_cast<double>(sample.luma) - at(0.0f);
      const double weight = tukeyWeight(difference, scale);
      if (weight == 0.0) continue;
      const double slope = (at(kHalfSlope) - at(-kHalfSlope)) / (2.0 * static_cast<double>(kHalfSlope));
      slopes += weight * slope * slope;
      products += weight * slope * difference;
    }
    if (!(slopes > 0.0)) return {};
    share += products / slopes;
    if (!(std::abs(share) <= kFarthestShare)) return {};
  }
  if (!(left(share) <= kClearlyLess * std::max(left(0.0), left(1.0)))) return {};
  return share;
}

} // namespace taa::doctor
