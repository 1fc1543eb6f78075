#include "core/render/View.h"

#include "core/render/FrameClock.h"
#include "core/render/SceneRenderer.h"
#include "core/render/jitter/Jitter.h"
#include "core/render/passes/Lights.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace taa {

namespace {

void fillSky(const Sky& sky, shared::FrameBlock& block) {
  block.skyZenith = glm::vec4(sky.zenith, 0.0f);
  block.skyHorizon = glm::vec4(sky.horizon, 0.0f);
  block.skyGround = glm::vec4(sky.ground, 0.0f);
  block.sunDirection = glm::vec4(glm::normalize(sky.sunDirection), sky.sunEnabled ? 1.0f : 0.0f);
  block.sunColor = glm::vec4(sky.sunColor, 0.0f);
}

/// What takes a picture's clip positions to the previous one's. In double, and exactly 1 for a camera that
/// rests.
glm::mat4 previousClipFromClip(const CameraState& camera, const CameraState& previous) {
  if (camera.clipFromView == previous.clipFromView && camera.viewFromWorld == previous.viewFromWorld)
    return glm::mat4(1.0f);
  const glm::dmat4 clip = glm::dmat4(camera.clipFromView) * glm::dmat4(camera.viewFromWorld);
  return glm::mat4(glm::dmat4(previous.clipFromView) * glm::dmat4(previous.viewFromWorld) *
                   glm::inverse(clip));
}

void fillCameras(const CameraState& camera, const CameraState& previous, glm::vec2 sizePx, glm::vec2 jitter,
                 JitterProjection projection, shared::FrameBlock& block) {
  const glm::mat4 jitteredClipFromView = jittered(camera.clipFromView, jitter, sizePx, projection);
  block.clipFromWorld = camera.clipFromView * camera.viewFromWorld;
  block.jitteredClipFromWorld = jitteredClipFromView * camera.viewFromWorld;
  // In double, because what is reconstructed from depth is compared at a thousandth of a pixel.
  block.worldFromJitteredClip =
      glm::mat4(glm::inverse(glm::dmat4(jitteredClipFromView) * glm::dmat4(camera.viewFromWorld)));
  block.viewFromWorld = camera.viewFromWorld;
  block.previousClipFromWorld = previous.clipFromView * previous.viewFromWorld;
  block.previousViewFromWorld = previous.viewFromWorld;
  block.previousClipFromClip = previousClipFromClip(camera, previous);
  block.sizePx = sizePx;
  block.jitterPx = jitter;
  block.printedJitter = addedInClip(camera.clipFromView, jitteredClipFromView);
  block.cameraPosition = glm::affineInverse(camera.viewFromWorld)[3];
  block.cameraPosition.w = camera.orthographic ? 1.0f : 0.0f;
  const glm::mat4& p = camera.clipFromView;
  block.depthTerms = glm::vec4(p[3][3], p[3][2], p[2][3], p[2][2]);
}

} // namespace

glm::ivec2 drawnSize(const glm::ivec2& picturePx, float renderScale) {
  // A thousandth is let go: r is a float, and 0.67 of 100 shall be 67.
  const auto scaled = [r = static_cast<double>(renderScale)](int side) {
    return static_cast<int>(std::ceil(r * side - 1e-3));
  };
  return {scaled(picturePx.x), scaled(picturePx.y)};
}

CameraState cameraOf(const Scene& scene, const FrameRequest& request, int frame) {
  const float aspect = static_cast<float>(request.width) / static_cast<float>(request.height);
  if (request.track) return cameraAt(scene, request.track->at(frame), aspect);
  return cameraAt(scene, request.camera, frameTime(scene, frame), aspect);
}

View viewAt(const Scene& scene, const FrameRequest& request, int frame) {
  View view;
  view.info = frameInfo(scene, request, frame);
  view.projection = request.jitter.projection;
  const glm::vec2 sizePx(drawnSize({request.width, request.height}, request.inputs.renderScale));
  const double time = frameTime(scene, frame);
  const int previous = previousFrame(scene, frame);
  const double previousTime = frameTime(scene, previous);
  view.pose = poseAt(scene, time);
  view.previousPose = poseAt(scene, previousTime);
  const CameraState camera = cameraOf(scene, request, frame);
  CameraState previousCamera = cameraOf(scene, request, previous);
  if (request.inputs.motion == MotionSource::CurrentProjectionAsPrinted)
    previousCamera.clipFromView = camera.clipFromView; // manual §26, D16
  fillCameras(camera, previousCamera, sizePx, view.info.jitterPx, view.projection, view.block);
  view.block.previousJitter = glm::vec4(frameInfo(scene, request, previous).jitterPx, 0.0f, 0.0f);
  fillSky(scene.sky, view.block);
  view.lights = lightBlock(scene, view.pose);
  view.nodes = nodeStates(scene, request.motionModes, time, previousTime);
  view.classes = givenClasses(scene, request.objectClasses);
  const std::vector<bool> isDrawn = drawnNodes(scene, request.filter);
  for (std::size_t i = 0; i < view.nodes.size(); ++i) view.nodes[i].isVisible &= isDrawn[i];
  const float bias = request.inputs.mipBias;
  view.block.textures = {bias, std::exp2(bias), static_cast<float>(frame % 16), 0.0f};
  view.block.storage.x = request.inputs.precision == Precision::Half ? 1.0f : 0.0f;
  return view;
}

} // namespace taa
