// Stage 2, reproject: pixel center minus motion.
#include "core/taa/reference/Stages.h"

#include <cmath>

namespace taa::reference {
namespace {

/// Both components of the motion of a point behind the previous camera, px; as in render/FrameInputs.h.
constexpr float kNoPreviousPosition = 65504.0f;

} // namespace

Reprojected reproject(const Inputs& inputs, const glm::vec2& motionPx, const glm::ivec2& pixel) {
  Reprojected result;
  result.noPrevious = motionPx.x == kNoPreviousPosition;
  const glm::vec2 q = (glm::vec2(pixel) + 0.5f) - motionPx;
  result.position = q;
  result.onScreen = q.x >= 0.0f && q.x <= static_cast<float>(inputs.width()) && q.y >= 0.0f &&
                    q.y <= static_cast<float>(inputs.height()); // NaN is off the screen
  const float speed = std::sqrt(motionPx.x * motionPx.x + motionPx.y * motionPx.y);
  result.speed = speed <= kNoPreviousPosition ? speed : kNoPreviousPosition; // NaN is the fastest
  return result;
}

} // namespace taa::reference
