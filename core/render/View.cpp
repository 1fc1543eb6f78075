#include "core/render/View.h"

#include "core/render/Cameras.h"
#include "core/render/FogCones.h"
#include "core/render/FrameClock.h"
#include "core/render/FrameRequest.h"
#include "core/render/Lights.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
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

/// The texels that are wanted; clamping the fog's history reads around them.
std::optional<gl::Rect> drawnPart(const Scene& scene, const FrameRequest& request, const glm::ivec2& sizePx) {
  if (!request.part || request.inputs.fogHistory == FogHistory::None || !drawsFog(scene, request.inputs))
    return request.part;
  return gl::grown(*request.part, 1, sizePx);
}

} // namespace

CameraState cameraOf(const Scene& scene, const FrameRequest& request, int frame) {
  const float aspect = static_cast<float>(request.width) / static_cast<float>(request.height);
  if (request.track) return cameraAt(scene, request.track->at(frame), aspect);
  return cameraAt(scene, request.camera, frameTime(scene, frame), aspect);
}

View viewAt(const Scene& scene, const FrameRequest& request, int frame) {
  View view;
  view.info = frameInfo(scene, request, frame);
  view.projection = request.jitter.projection;
  const glm::ivec2 drawnPx = drawnSize({request.width, request.height}, request.inputs.renderScale);
  const glm::vec2 sizePx(drawnPx);
  view.part = drawnPart(scene, request, drawnPx);
  const double time = frameTime(scene, frame);
  const int previous = request.movesOn ? frame + 1 : previousFrame(scene, frame);
  const double previousTime = frameTime(scene, previous);
  view.pose = poseAt(scene, time);
  view.previousPose = poseAt(scene, previousTime);
  const CameraState camera = cameraOf(scene, request, frame);
  CameraState previousCamera = cameraOf(scene, request, previous);
  if (request.inputs.motion == MotionSource::CurrentProjectionAsPrinted)
    previousCamera.clipFromView = camera.clipFromView; // manual §26, D16
  const glm::vec2 previousJitter = frameInfo(scene, request, previous).jitterPx;
  view.cameras = {camera, previousCamera, sizePx, view.info.jitterPx, previousJitter, view.projection};
  fillCameras(view.cameras, view.block);
  fillSky(scene.sky, view.block);
  view.lights = lightBlock(scene, view.pose);
  view.nodes = nodeStates(scene, request.motionModes, time, previousTime);
  view.classes = givenClasses(scene, request.objectClasses);
  const std::vector<bool> isDrawn = drawnNodes(scene, request.filter);
  for (std::size_t i = 0; i < view.nodes.size(); ++i) view.nodes[i].isVisible &= isDrawn[i];
  const float bias = request.inputs.mipBias;
  fillStorage(request.inputs.precision, bias, frame, view.block);
  return view;
}

void setJitter(View& view, const glm::vec2& jitterPx) {
  view.info.jitterPx = jitterPx;
  view.cameras.jitterPx = view.cameras.previousJitterPx = jitterPx;
  fillCameras(view.cameras, view.block);
}

} // namespace taa
