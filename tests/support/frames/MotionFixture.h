// A fixture that draws small scenes by their camera and looks at their motion.
#pragma once

#include "core/render/passes/SceneRenderer.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/SmallScene.h"

#include <memory>

namespace taa::test {

inline constexpr int kWidth = 320, kHeight = 180;
inline constexpr float kP11 = 1.7320508f; ///< of the camera's 60°
inline constexpr float kP00 = kP11 * kHeight / kWidth;
inline const glm::vec3 kRight(40, 0, 0), kUp(0, 40, 0); ///< sides of a quad that fills the picture

/// Where the scene sample of pixel (x, y) lies on the unjittered raster, from the middle, px, y down.
inline glm::vec2 fromMiddle(const FrameInfo& info, int x, int y) {
  return glm::vec2(float(x) + 0.5f - 0.5f * kWidth, float(y) + 0.5f - 0.5f * kHeight) - info.jitterPx;
}

/// Of emptyScene() and what tests put into it; 32-bit motion.
class MotionFixture : public GlTest {
 protected:
  static FrameRequest request(MotionSource source = MotionSource::Objects) {
    FrameRequest request;
    request.camera = kEye;
    request.width = kWidth;
    request.height = kHeight;
    request.inputs = {Precision::Full, source};
    return request;
  }
  static FrameInputs draw(const Scene& scene, const FrameRequest& request, int frame = 1) {
    SceneRenderer renderer(std::make_shared<const Scene>(scene));
    FrameInputs inputs;
    renderer.draw(request, frame, inputs);
    return inputs;
  }
  static Image motion(const Scene& scene, const FrameRequest& request, int frame = 1) {
    return draw(scene, request, frame).motion.download();
  }
  static Image motion(const Scene& scene, int frame = 1) { return motion(scene, request(), frame); }
};

} // namespace taa::test
