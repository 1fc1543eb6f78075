// Motion and previous distance of what stands still in the world, from depth and both cameras (manual §3.1,
// §3.2), in double. Its positions are those of shaders/scene/camera_motion.frag.
#pragma once

#include "core/base/Image.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/render/FrameInputs.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace taa::capture {

class CameraMotion {
 public:
  /// `depthJitterPx`: displacement of what depth shows, 0 where it was drawn without jitter.
  CameraMotion(const DecodedCamera& camera, const DecodedCamera& previous, const glm::ivec2& sizePx,
               const glm::dvec2& depthJitterPx);

  /// px, current − previous; kNoPreviousPosition for what was behind the previous camera. `depth` is this
  /// program's, 0: infinitely far away.
  glm::vec2 motionPx(int x, int y, float depth) const {
    const double ndcX = (x + 0.5 - jitterPx_.x) * ndcPerPx_.x - 1.0;
    const double ndcY = (y + 0.5 - jitterPx_.y) * ndcPerPx_.y + 1.0;
    const double w = row(ndcX, ndcY, depth, 3), perW = 1.0 / w;
    const auto motionX = static_cast<float>((ndcX - row(ndcX, ndcY, depth, 0) * perW) / ndcPerPx_.x);
    const auto motionY = static_cast<float>((ndcY - row(ndcX, ndcY, depth, 1) * perW) / ndcPerPx_.y);
    // Comparisons are written so that NaN fails them.
    const bool isKnown =
        w > 0.0 && std::abs(motionX) < kNoPreviousPosition && std::abs(motionY) < kNoPreviousPosition;
    return isKnown ? glm::vec2(motionX, motionY) : glm::vec2(kNoPreviousPosition);
  }

  /// Distance along the previous camera's axis, m; 0: nothing, or behind it.
  float previousDepth(int x, int y, float depth) const {
    const double ndcX = (x + 0.5 - jitterPx_.x) * ndcPerPx_.x - 1.0;
    const double ndcY = (y + 0.5 - jitterPx_.y) * ndcPerPx_.y + 1.0;
    const auto of = [&](const glm::dvec4& terms) {
      return ndcX * terms.x + ndcY * terms.y + static_cast<double>(depth) * terms.z + terms.w;
    };
    const double distance = -of(previousZ_) / of(previousW_);
    return depth > 0.0f && distance > 0.0 ? static_cast<float>(distance) : 0.0f;
  }

 private:
  double row(double ndcX, double ndcY, float depth, int i) const {
    const glm::dmat4& m = previousClipFromClip_;
    return ndcX * m[0][i] + ndcY * m[1][i] + static_cast<double>(depth) * m[2][i] + m[3][i];
  }

  glm::dmat4 previousClipFromClip_;
  glm::dvec4 previousZ_, previousW_; ///< of the previous view space, by x, y, depth and 1 of this clip space
  glm::dvec2 ndcPerPx_;              ///< 2/W, −2/H
  glm::dvec2 jitterPx_;
};

/// previousDepth() of every pixel.
Image previousDepthOf(const CameraMotion& motion, const Image& depth);

/// motionPx() of every pixel.
Image motionOf(const CameraMotion& motion, const Image& depth);

} // namespace taa::capture
