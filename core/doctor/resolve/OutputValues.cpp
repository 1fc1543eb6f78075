#include "core/doctor/resolve/OutputValues.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taa::doctor {

namespace {

constexpr float kByteStep = 1.0f / 255.0f;
/// Of a step: halves near 1 are off by so much.
constexpr float kStepTolerance = 0.08f;
/// What a frame wants otherwise by so much is lost at an α of a tenth where it is rounded to steps.
constexpr float kLeastOff = kByteStep, kMostOff = 3.0f * kByteStep;
constexpr std::size_t kEnoughValues = 2000;
constexpr double kNearlyAll = 0.999, kHardlyAny = 0.6;
constexpr int kPersists = 2; ///< frames with what is no number

bool isNumber(const Image& plane, int x, int y) {
  for (int channel = 0; channel < 3; ++channel)
    if (!std::isfinite(plane.at(x, y)[channel])) return false;
  return true;
}

/// Whether the colors that a pixel is made of are numbers.
bool isSoundAround(const Image& color, int x, int y) {
  for (int v = std::max(0, y - 1); v <= std::min(color.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(color.width - 1, x + 1); ++u)
      if (!isNumber(color, u, v)) return false;
  return true;
}

bool isInSteps(float value) {
  const float steps = value / kByteStep;
  return std::abs(steps - std::round(steps)) <= kStepTolerance;
}

/// Whether a value tells steps from none: 0 and what is beyond 1 may be of any precision.
bool tellsSteps(float value) {
  return value > 0.5f * kByteStep && value <= 1.0f;
}

} // namespace

void OutputValues::add(const DoctorFrame& frame, const DoctorFrame* before) {
  const Image& output = frame.output;
  if (output.empty()) return;
  ++frames;
  constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
  const bool hasSize = output.width == frame.color.width && output.height == frame.color.height;
  const bool goesOn = hasSize && before && !before->output.empty() && !frame.motionPx.empty();
  std::size_t spoiled = 0;
  glm::ivec2 spoiledPixel(0);
  for (int y = 0; y < output.height; ++y)
    for (int x = 0; x < output.width; ++x) {
      if (!isNumber(output, x, y)) {
        if (hasSize && !isSoundAround(frame.color, x, y)) continue;
        ++spoiled;
        spoiledPixel = {x, y};
        continue;
      }
      const bool rests = goesOn && frame.motionAt(x, y) == glm::vec2(0.0f);
      for (int channel = 0; channel < 3; ++channel)
        addValue(output.at(x, y)[channel], hasSize ? frame.color.at(x, y)[channel] : kUnknown,
                 rests ? before->output.at(x, y)[channel] : kUnknown);
    }
  if (spoiled > 0) addSpoiled(frame.frame, spoiled, spoiledPixel);
}

void OutputValues::addValue(float value, float color, float before) {
  if (value > 1.0f) ++beyond;
  if (!tellsSteps(value)) return;
  ++values;
  if (isInSteps(value)) ++inSteps;
  if (tellsSteps(color)) {
    ++colorValues;
    if (isInSteps(color)) ++colorInSteps;
  }
  const float off = std::abs(color - before);
  if (!(off >= kLeastOff && off <= kMostOff)) return; // NaN, too
  ++resting;
  if (value == before) ++stuck;
}

void OutputValues::addSpoiled(int frame, std::size_t pixels, const glm::ivec2& pixel) {
  ++spoiledFrames;
  if (firstFrame < 0) firstFrame = frame;
  if (pixels <= most) return;
  most = pixels;
  mostFrame = frame;
  mostPixel = pixel;
}

bool OutputValues::keepsNan() const {
  return spoiledFrames >= kPersists;
}

bool OutputValues::isOfFewBits() const {
  if (values < kEnoughValues || colorValues == 0 || beyond > 0) return false;
  return static_cast<double>(inSteps) >= kNearlyAll * static_cast<double>(values) &&
         static_cast<double>(colorInSteps) <= kHardlyAny * static_cast<double>(colorValues);
}

} // namespace taa::doctor
