#include "core/render/passes/SunView.h"

#include "core/render/FrameRequest.h"
#include "core/render/Lights.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace taa {

namespace {

/// Axes of the sun's picture in the world: right, up, to the sun.
std::array<glm::vec3, 3> sunAxes(const View& view) {
  const glm::vec3 toSun = -glm::vec3(view.lights.lightDirection[0]);
  const glm::vec3 up = std::abs(toSun.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
  const glm::vec3 right = glm::normalize(glm::cross(up, toSun));
  return {right, glm::cross(toSun, right), toSun};
}

/// Around the box, along the axes of the sun; m.
Bounds inAxes(const Bounds& box, const std::array<glm::vec3, 3>& axes) {
  Bounds around;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 point(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                          corner & 4 ? box.max.z : box.min.z);
    around.add({glm::dot(point, axes[0]), glm::dot(point, axes[1]), glm::dot(point, axes[2])});
  }
  return around;
}

/// A texel at each border, and what stands beside the box towards the sun.
Bounds withMargins(Bounds around) {
  constexpr float kLeast = 1e-3f; // m, of a scene without extent
  const glm::vec3 extent = glm::max(around.max - around.min, glm::vec3(kLeast));
  const glm::vec3 border(2.0f * extent.x / kShadowMapSize, 2.0f * extent.y / kShadowMapSize, 0.1f * extent.z);
  around.min -= border;
  around.max += border;
  around.max.z += extent.z;
  return around;
}

/// Samples of a reference take others than frames do, and each another one.
int noiseNumber(const FrameRequest& request, int frame) {
  if (!request.sample) return frame % 256;
  const std::uint32_t mixed = (static_cast<std::uint32_t>(*request.sample) + 1u) * 0x9e3779b9u;
  return static_cast<int>(mixed >> 16);
}

} // namespace

Shadows shadowsOf(SunShadows wanted) {
  switch (wanted) {
  case SunShadows::None:
    return Shadows::None;
  case SunShadows::Hard:
    return Shadows::Hard;
  case SunShadows::Soft:
    return Shadows::Soft;
  }
  std::abort();
}

Shadows shadowsOf(const Scene& scene, const InputSettings& settings) {
  if (lightCounts(scene).directional == 0) return Shadows::None;
  return settings.shadows == Shadows::AsScene ? shadowsOf(scene.sky.shadows) : settings.shadows;
}

bool castsShadows(const Scene& scene, const InputSettings& settings) {
  return shadowsOf(scene, settings) != Shadows::None;
}

const Bounds& shadowedBounds(const Scene& scene) {
  return scene.sky.shadowed.isEmpty() ? scene.bounds : scene.sky.shadowed;
}

View sunView(const Scene& scene, const View& view) {
  const std::array<glm::vec3, 3> axes = sunAxes(view);
  const Bounds around = withMargins(inAxes(shadowedBounds(scene), axes));
  const glm::vec3 extent = around.max - around.min;
  glm::mat4 clipFromWorld(1.0f);
  for (int axis = 0; axis < 3; ++axis) {
    const float scale = (axis < 2 ? 2.0f : 1.0f) / extent[axis];
    const float start = axis < 2 ? -1.0f : 0.0f;
    clipFromWorld =
        glm::row(clipFromWorld, axis,
                 glm::vec4(scale * axes[static_cast<std::size_t>(axis)], start - scale * around.min[axis]));
  }
  View sun = view;
  sun.projection = JitterProjection::Translation;
  sun.part.reset();
  sun.block.clipFromWorld = sun.block.jitteredClipFromWorld = sun.block.previousClipFromWorld = clipFromWorld;
  sun.block.sizePx = glm::vec2(kShadowMapSize);
  sun.block.jitterPx = glm::vec2(0.0f);
  sun.block.previousJitter = sun.block.printedJitter = glm::vec4(0.0f);
  return sun;
}

shared::ShadowBlock shadowBlock(const Scene& scene, const FrameRequest& request, int frame, const View& sun) {
  const Bounds& box = shadowedBounds(scene);
  constexpr float kSize = kShadowMapSize;
  const glm::mat4& clip = sun.block.clipFromWorld;
  const glm::vec3 perMeter(glm::length(glm::vec3(glm::row(clip, 0))) * 0.5f * kSize,
                           glm::length(glm::vec3(glm::row(clip, 1))) * 0.5f * kSize,
                           glm::length(glm::vec3(glm::row(clip, 2)))); // texels, texels, depth
  shared::ShadowBlock block{};
  glm::mat4 mapFromClip(1.0f);
  mapFromClip = glm::row(mapFromClip, 0, {0.5f * kSize, 0.0f, 0.0f, 0.5f * kSize});
  mapFromClip = glm::row(mapFromClip, 1, {0.0f, -0.5f * kSize, 0.0f, 0.5f * kSize});
  block.mapFromWorld = mapFromClip * clip;
  const float texel = 1.0f / std::min(perMeter.x, perMeter.y);
  block.lowest = glm::vec4(box.min, 1.0f / perMeter.z);
  block.highest = glm::vec4(box.max, 0.25f * texel);
  block.toSun = glm::vec4(-glm::vec3(sun.lights.lightDirection[0]), noiseNumber(request, frame));
  const float aside = std::tan(glm::radians(request.inputs.sunRadius)); // m in each m
  block.aside = {aside * perMeter.x, aside * perMeter.y, request.inputs.shadowRays, kSize};
  return block;
}

} // namespace taa
