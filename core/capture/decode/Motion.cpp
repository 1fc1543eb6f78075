#include "core/capture/decode/Motion.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/decode/Rows.h"
#include "core/capture/decode/ScreenUnits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taa::capture {

namespace {

constexpr double kUnrealSmallest = 1.0 / 65535.0;

/// No picture is so wide: motion this long stands for kNoPreviousPosition, which other units have rounded.
constexpr float kNotMotion = 65000.0f;

double decodedUnreal(double stored) {
  const double root = (stored - kUnrealRest) / kUnrealSlope;
  return 0.5 * root * std::abs(root);
}

double encodedUnreal(double value) {
  const double root = std::copysign(std::sqrt(2.0 * std::abs(value)), value);
  return std::clamp(root * kUnrealSlope + kUnrealRest, kUnrealSmallest, 1.0);
}

bool isFiniteAndNot0(double value) {
  return std::isfinite(value) && value != 0.0;
}

void checkMotion(const MotionConventions& motion) {
  if (!isFiniteAndNot0(motion.scale.x) || !isFiniteAndNot0(motion.scale.y))
    throw Error(
        say<"motion.scaleX and motion.scaleY are not numbers that motion can be scaled by; neither is "
            "0">());
  if (!std::isfinite(motion.offset.x) || !std::isfinite(motion.offset.y))
    throw Error(say<"motion.offsetX and motion.offsetY are not finite numbers">());
}

glm::dvec2 pxPerValueOf(const Manifest& manifest) {
  const MotionConventions& motion = manifest.conventions.motion;
  glm::dvec2 px = motion.scale * pxPerUnit(motion.unit, motion.yAxis, manifest.sizePx);
  if (motion.unit == ScreenUnit::Pixels && motion.pixelOf == PixelOf::Output)
    px *= glm::dvec2(manifest.sizePx) / glm::dvec2(manifest.outputSize());
  return motion.direction == MotionDirection::PreviousMinusCurrent ? -px : px;
}

/// px that stored motion holds besides motion: content is where it is plus its frame's jitter.
glm::dvec2 jitterLeftOf(JitterInMotion kind, const MotionInputs& inputs) {
  glm::dvec2 px(0.0);
  if (kind == JitterInMotion::Both || kind == JitterInMotion::Current) px += inputs.jitterPx;
  if (kind == JitterInMotion::Both || kind == JitterInMotion::Previous) px -= inputs.previousJitterPx;
  return px;
}

bool isNoPrevious(const glm::vec2& motionPx) {
  return motionPx.x == kNoPreviousPosition || motionPx.y == kNoPreviousPosition;
}

/// The mark of what has no previous position, wherever motion is as long as it; NaN and infinity stay.
glm::vec2 marked(const glm::vec2& motionPx) {
  const float length = std::max(std::abs(motionPx.x), std::abs(motionPx.y));
  return length >= kNotMotion && length <= std::numeric_limits<float>::max() ? glm::vec2(kNoPreviousPosition)
                                                                             : motionPx;
}

template <MotionEncoding kEncoding>
double decodedValue(float stored, double offset) {
  if (kEncoding == MotionEncoding::Unreal) return decodedUnreal(static_cast<double>(stored));
  if (kEncoding == MotionEncoding::Offset) return static_cast<double>(stored) - offset;
  return static_cast<double>(stored);
}

} // namespace

MotionDecoder::MotionDecoder(const Manifest& manifest, const MotionInputs& inputs)
    : conventions_(manifest.conventions.motion), inputs_(inputs), pxPerValue_(pxPerValueOf(manifest)),
      jitterLeft_(jitterLeftOf(conventions_.jitter, inputs)), notWritten_(conventions_.notWritten) {
  checkMotion(conventions_);
  if (conventions_.encoding == MotionEncoding::Unreal && !conventions_.notWritten)
    notWritten_ = StoredValue(0.0);
  if (!inputs_.depth) conventions_.whereNothing = {};
  if (!inputs_.depth || !inputs_.camera) conventions_.includesCamera = true;
  // This program's own value of "no previous position" stands for itself.
  const bool keepsMarks = !notWritten_.isStated() || (conventions_.fallback == MotionFallback::None &&
                                                      notWritten_.value() == kNoPreviousPosition);
  isIdentity_ = conventions_.encoding == MotionEncoding::Plain && pxPerValue_ == glm::dvec2(1.0) &&
                conventions_.jitter == JitterInMotion::Removed && conventions_.includesCamera && keepsMarks &&
                !conventions_.whereNothing;
}

glm::vec2 MotionDecoder::cameraMotion(int x, int y) const {
  if (!inputs_.depth || !inputs_.camera) return glm::vec2(0.0f);
  return inputs_.camera->motionPx(x, y, *inputs_.depth->at(x, y));
}

glm::vec2 MotionDecoder::fallback(MotionFallback kind, int x, int y) const {
  if (kind == MotionFallback::Zero) return glm::vec2(0.0f);
  return kind == MotionFallback::None ? glm::vec2(kNoPreviousPosition) : cameraMotion(x, y);
}

template <MotionEncoding kEncoding>
void MotionDecoder::decodeRow(float* row, int width, int y) const {
  const float* depth = conventions_.whereNothing ? inputs_.depth->at(0, y) : nullptr;
  for (int x = 0; x < width; ++x) {
    float* at = row + 2 * x;
    glm::vec2 px;
    if (depth && depth[x] == 0.0f) {
      px = fallback(*conventions_.whereNothing, x, y);
    } else if (notWritten_ == at[0] && notWritten_ == at[1]) {
      px = fallback(conventions_.fallback, x, y);
    } else {
      const double valueX = decodedValue<kEncoding>(at[0], conventions_.offset.x);
      const double valueY = decodedValue<kEncoding>(at[1], conventions_.offset.y);
      px = marked({static_cast<float>(valueX * pxPerValue_.x - jitterLeft_.x),
                   static_cast<float>(valueY * pxPerValue_.y - jitterLeft_.y)});
      if (!conventions_.includesCamera && !isNoPrevious(px)) {
        const glm::vec2 camera = cameraMotion(x, y);
        px = isNoPrevious(camera) ? camera : marked(px + camera);
      }
    }
    at[0] = px.x;
    at[1] = px.y;
  }
}

void MotionDecoder::decode(Image& motion) const {
  if (isIdentity_) return;
  forRows(motion.height, motion.pixels.size(), [&](int first, int end) {
    for (int y = first; y < end; ++y) {
      float* row = motion.at(0, y);
      switch (conventions_.encoding) {
      case MotionEncoding::Plain:
        decodeRow<MotionEncoding::Plain>(row, motion.width, y);
        break;
      case MotionEncoding::Unreal:
        decodeRow<MotionEncoding::Unreal>(row, motion.width, y);
        break;
      case MotionEncoding::Offset:
        decodeRow<MotionEncoding::Offset>(row, motion.width, y);
        break;
      }
    }
  });
}

glm::vec2 MotionDecoder::encoded(const glm::vec2& motionPx, int x, int y) const {
  const bool hasNoPrevious = isNoPrevious(motionPx);
  // Unreal's 16 bits have no room for the mark.
  const bool isLeftOut =
      conventions_.fallback == MotionFallback::None || conventions_.encoding == MotionEncoding::Unreal;
  if (hasNoPrevious && notWritten_.isStated() && isLeftOut) return glm::vec2(notWritten_.value());
  glm::dvec2 px(motionPx);
  if (!hasNoPrevious && !conventions_.includesCamera) px -= glm::dvec2(cameraMotion(x, y));
  if (!hasNoPrevious) px += jitterLeft_;
  const glm::dvec2 value = px / pxPerValue_;
  switch (conventions_.encoding) {
  case MotionEncoding::Unreal:
    return {static_cast<float>(encodedUnreal(value.x)), static_cast<float>(encodedUnreal(value.y))};
  case MotionEncoding::Offset:
    return glm::vec2(value + conventions_.offset);
  case MotionEncoding::Plain:
    break;
  }
  return glm::vec2(value);
}

void MotionDecoder::encodeRow(float* row, int width, int y) const {
  for (int x = 0; x < width; ++x) {
    float* at = row + 2 * x;
    const glm::vec2 motionPx(at[0], at[1]);
    glm::vec2 stored = encoded(motionPx, x, y);
    // A motion that happens to have the value of "not written" moves by the smallest step that halves know.
    const bool isMistaken = notWritten_ == stored.x && notWritten_ == stored.y && !isNoPrevious(motionPx) &&
                            fallback(conventions_.fallback, x, y) != motionPx;
    if (isMistaken) stored.x += std::max(1.0f / 16777216.0f, std::abs(stored.x) / 512.0f);
    at[0] = stored.x;
    at[1] = stored.y;
  }
}

void MotionDecoder::encode(Image& motion) const {
  if (isIdentity_) return;
  forRows(motion.height, motion.pixels.size(), [&](int first, int end) {
    for (int y = first; y < end; ++y) encodeRow(motion.at(0, y), motion.width, y);
  });
}

} // namespace taa::capture
