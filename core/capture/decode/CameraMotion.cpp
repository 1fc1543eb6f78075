#include "core/capture/decode/CameraMotion.h"

#include "core/capture/decode/Rows.h"

#include <glm/matrix.hpp>

namespace taa::capture {

CameraMotion::CameraMotion(const DecodedCamera& camera, const DecodedCamera& previous,
                           const glm::ivec2& sizePx, const glm::dvec2& depthJitterPx)
    : ndcPerPx_(glm::dvec2(2.0, -2.0) / glm::dvec2(sizePx)), jitterPx_(depthJitterPx) {
  const glm::dmat4 worldFromClip = glm::inverse(camera.clipFromView * camera.viewFromWorld);
  // Exactly 1 for a camera that rests, so that nothing moves by rounding.
  const bool rests = camera == previous;
  previousClipFromClip_ =
      rests ? glm::dmat4(1.0) : previous.clipFromView * previous.viewFromWorld * worldFromClip;
  const glm::dmat4 previousViewFromClip =
      rests ? glm::inverse(camera.clipFromView) : previous.viewFromWorld * worldFromClip;
  for (int column = 0; column < 4; ++column) {
    previousZ_[column] = previousViewFromClip[column][2];
    previousW_[column] = previousViewFromClip[column][3];
  }
}

Image previousDepthOf(const CameraMotion& motion, const Image& depth) {
  Image result(depth.width, depth.height, 1);
  forRows(depth.height, depth.pixels.size(), [&](int first, int end) {
    for (int y = first; y < end; ++y) {
      const float* from = depth.at(0, y);
      float* to = result.at(0, y);
      for (int x = 0; x < depth.width; ++x) to[x] = motion.previousDepth(x, y, from[x]);
    }
  });
  return result;
}

Image motionOf(const CameraMotion& motion, const Image& depth) {
  Image result(depth.width, depth.height, 2);
  forRows(depth.height, depth.pixels.size(), [&](int first, int end) {
    for (int y = first; y < end; ++y) {
      const float* from = depth.at(0, y);
      float* to = result.at(0, y);
      for (int x = 0; x < depth.width; ++x) {
        const glm::vec2 px = motion.motionPx(x, y, from[x]);
        to[2 * x] = px.x;
        to[2 * x + 1] = px.y;
      }
    }
  });
  return result;
}

} // namespace taa::capture
