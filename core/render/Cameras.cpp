#include "core/render/Cameras.h"

#include "core/render/Jitter.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <cmath>

namespace taa {

namespace {

glm::dmat4 clipFromWorld(const CameraState& camera) {
  return glm::dmat4(camera.clipFromView) * glm::dmat4(camera.viewFromWorld);
}

bool isSame(const CameraState& a, const CameraState& b) {
  return a.clipFromView == b.clipFromView && a.viewFromWorld == b.viewFromWorld;
}

} // namespace

glm::mat4 previousClipFromClip(const glm::dmat4& clipFromWorld, const glm::dmat4& previousClipFromWorld) {
  if (clipFromWorld == previousClipFromWorld) return glm::mat4(1.0f);
  return glm::mat4(previousClipFromWorld * glm::inverse(clipFromWorld));
}

void fillCameras(const FrameCameras& cameras, shared::FrameBlock& block) {
  const CameraState &camera = cameras.camera, &previous = cameras.previous;
  const glm::mat4 jitteredClipFromView =
      jittered(camera.clipFromView, cameras.jitterPx, cameras.sizePx, cameras.projection);
  block.clipFromWorld = camera.clipFromView * camera.viewFromWorld;
  block.jitteredClipFromWorld = jitteredClipFromView * camera.viewFromWorld;
  // In double, because what is reconstructed from depth is compared at a thousandth of a pixel.
  block.worldFromJitteredClip =
      glm::mat4(glm::inverse(glm::dmat4(jitteredClipFromView) * glm::dmat4(camera.viewFromWorld)));
  block.viewFromWorld = camera.viewFromWorld;
  block.previousClipFromWorld = previous.clipFromView * previous.viewFromWorld;
  block.previousViewFromWorld = previous.viewFromWorld;
  block.previousClipFromClip = isSame(camera, previous)
                                   ? glm::mat4(1.0f)
                                   : previousClipFromClip(clipFromWorld(camera), clipFromWorld(previous));
  block.sizePx = cameras.sizePx;
  block.jitterPx = cameras.jitterPx;
  block.previousJitter = glm::vec4(cameras.previousJitterPx, 0.0f, 0.0f);
  block.printedJitter = addedInClip(camera.clipFromView, jitteredClipFromView);
  block.cameraPosition = glm::affineInverse(camera.viewFromWorld)[3];
  block.cameraPosition.w = camera.orthographic ? 1.0f : 0.0f;
  const glm::mat4& p = camera.clipFromView;
  block.depthTerms = glm::vec4(p[3][3], p[3][2], p[2][3], p[2][2]);
}

void fillStorage(Precision precision, float mipBias, int frame, shared::FrameBlock& block) {
  block.textures = {mipBias, std::exp2(mipBias), static_cast<float>(frame % 16), 0.0f};
  block.storage.x = precision == Precision::Half ? 1.0f : 0.0f;
}

} // namespace taa
