// Stage 2, reproject: pixel center minus motion, or the center itself.
#include "core/taa/twin/Stages.h"

#include <cmath>

namespace taa::twin {
namespace {

/// In px of a picture of 1080 lines.
float speedOfLines(float speed, const glm::ivec2& picturePx) {
  return speed * (1080.0f / static_cast<float>(picturePx.y));
}

/// In 1080ths of the picture, across and down.
float speedOfPicture(const glm::vec2& motionPx, const glm::ivec2& picturePx) {
  const glm::vec2 share = motionPx / glm::vec2(picturePx);
  const float length = std::sqrt(share.x * share.x + share.y * share.y);
  return 1080.0f * (length <= kNoPreviousPosition ? length : kNoPreviousPosition);
}

} // namespace

float speedIn(SpeedUnit unit, float speed, const glm::vec2& motionPx, const glm::ivec2& picturePx) {
  switch (unit) {
  case SpeedUnit::Pixels:
    break;
  case SpeedUnit::Lines1080:
    return speedOfLines(speed, picturePx);
  case SpeedUnit::Picture1080:
    return speedOfPicture(motionPx, picturePx);
  }
  return speed;
}

Reprojection reproject(const Inputs& inputs, const ReprojectSettings& settings, const glm::vec2& motionPx,
                       const glm::ivec2& pixel, const glm::vec2& readOff) {
  const bool isInPlace = settings.method == ReprojectMethod::InPlace;
  Reprojection result;
  result.noPrevious = !isInPlace && motionPx.x == kNoPreviousPosition;
  const glm::vec2 center = glm::vec2(pixel) + 0.5f;
  const glm::vec2 q = isInPlace ? center : (center - motionPx) + readOff;
  result.position = q;
  result.onScreen = q.x >= 0.0f && q.x <= static_cast<float>(inputs.outputWidth()) && q.y >= 0.0f &&
                    q.y <= static_cast<float>(inputs.outputHeight()); // NaN is off the screen
  const float speed = std::sqrt(motionPx.x * motionPx.x + motionPx.y * motionPx.y);
  result.speed = speed <= kNoPreviousPosition ? speed : kNoPreviousPosition; // NaN is the fastest
  return result;
}

} // namespace taa::twin
