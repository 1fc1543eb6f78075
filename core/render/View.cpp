#include "core/render/View.h"

#include "core/render/FrameClock.h"
#include "core/render/Jitter.h"
#include "core/render/SceneRenderer.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>

namespace taa {

namespace {

int addLight(shared::LightBlock& block, int count, const glm::vec4& position, const glm::vec3& direction,
             const glm::vec3& color, const glm::vec4& terms) {
  if (count == shared::kMaxLights) return count;
  block.lightPosition[count] = position;
  block.lightDirection[count] = glm::vec4(direction, 0.0f);
  block.lightColor[count] = glm::vec4(color, 0.0f);
  block.lightTerms[count] = terms;
  return count + 1;
}

/// Cone scale and offset, 1/range²: KHR_lights_punctual's recommended falloff.
glm::vec4 lightTerms(const Light& light) {
  glm::vec4 terms(0.0f, 1.0f, 0.0f, 0.0f);
  if (light.kind == LightKind::Spot) {
    const float inner = std::cos(light.innerConeAngle), outer = std::cos(light.outerConeAngle);
    terms.x = 1.0f / std::max(0.001f, inner - outer);
    terms.y = -outer * terms.x;
  }
  if (light.range > 0.0f) terms.z = 1.0f / (light.range * light.range);
  return terms;
}

/// The sun first, then the scene's lights in order, as many as there is room for. Returns how many.
int fillLights(const Scene& scene, const Pose& pose, shared::LightBlock& block) {
  int count = 0;
  if (scene.sky.sunEnabled) {
    const glm::vec3 toSun = glm::normalize(scene.sky.sunDirection);
    count = addLight(block, count, glm::vec4(toSun, 0.0f), -toSun, scene.sky.sunColor, {0, 1, 0, 0});
  }
  for (const Light& light : scene.lights) {
    if (light.node < 0) continue;
    const glm::mat4& world = pose.worldFromNode[static_cast<std::size_t>(light.node)];
    const glm::vec3 beam = -glm::vec3(world[2]);
    const float length = glm::length(beam);
    if (!(length > 0.0f)) continue; // scaled to nothing: it has no direction
    const glm::vec3 direction = beam / length;
    const bool isDirectional = light.kind == LightKind::Directional;
    const glm::vec4 position =
        isDirectional ? glm::vec4(-direction, 0.0f) : glm::vec4(glm::vec3(world[3]), 1.0f);
    count = addLight(block, count, position, direction, light.color * light.intensity,
                     isDirectional ? glm::vec4(0, 1, 0, 0) : lightTerms(light));
  }
  return count;
}

void fillSky(const Sky& sky, shared::FrameBlock& block) {
  block.skyZenith = glm::vec4(sky.zenith, block.skyZenith.w);
  block.skyHorizon = glm::vec4(sky.horizon, 0.0f);
  block.skyGround = glm::vec4(sky.ground, 0.0f);
  block.sunDirection = glm::vec4(glm::normalize(sky.sunDirection), sky.sunEnabled ? 1.0f : 0.0f);
  block.sunColor = glm::vec4(sky.sunColor, 0.0f);
}

void fillCameras(const CameraState& camera, const CameraState& previous, glm::vec2 sizePx, glm::vec2 jitter,
                 shared::FrameBlock& block) {
  const glm::mat4 jitteredClipFromView = jittered(camera.clipFromView, jitter, sizePx);
  block.clipFromWorld = camera.clipFromView * camera.viewFromWorld;
  block.jitteredClipFromWorld = jitteredClipFromView * camera.viewFromWorld;
  // In double, because what is reconstructed from depth is compared at a thousandth of a pixel.
  block.worldFromJitteredClip =
      glm::mat4(glm::inverse(glm::dmat4(jitteredClipFromView) * glm::dmat4(camera.viewFromWorld)));
  block.viewFromWorld = camera.viewFromWorld;
  block.previousClipFromWorld = previous.clipFromView * previous.viewFromWorld;
  block.previousViewFromWorld = previous.viewFromWorld;
  block.sizePx = sizePx;
  block.jitterPx = jitter;
  block.cameraPosition = glm::affineInverse(camera.viewFromWorld)[3];
  block.cameraPosition.w = camera.orthographic ? 1.0f : 0.0f;
  const glm::mat4& p = camera.clipFromView;
  block.depthTerms = glm::vec4(p[3][3], p[3][2], p[2][3], p[2][2]);
}

} // namespace

View viewAt(const Scene& scene, const FrameRequest& request, int frame) {
  View view;
  view.info = frameInfo(scene, request.jitter, frame);
  const glm::vec2 sizePx(request.width, request.height);
  const float aspect = sizePx.x / sizePx.y;
  const double time = frameTime(scene, frame);
  const double previousTime = frameTime(scene, previousFrame(scene, frame));
  view.pose = poseAt(scene, time);
  view.previousPose = poseAt(scene, previousTime);
  fillCameras(cameraAt(scene, request.camera, time, aspect),
              cameraAt(scene, request.camera, previousTime, aspect), sizePx, view.info.jitterPx, view.block);
  fillSky(scene.sky, view.block);
  view.block.skyZenith.w = static_cast<float>(fillLights(scene, view.pose, view.lights));
  view.block.storage.x = request.inputs.precision == Precision::Half ? 1.0f : 0.0f;
  return view;
}

} // namespace taa
