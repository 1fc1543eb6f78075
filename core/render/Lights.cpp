#include "core/render/Lights.h"

#include <algorithm>
#include <cmath>

namespace taa {

static_assert(kMaxLights == shared::kMaxLights);

namespace {

bool isDrawnAs(const Light& light, bool directional) {
  return light.node >= 0 && (light.kind == LightKind::Directional) == directional;
}

/// Cone scale and offset, 1/range²: the falloff that KHR_lights_punctual recommends.
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

void fillLight(const Light& light, const Pose& pose, shared::LightBlock& block, int index) {
  const glm::mat4& world = pose.worldFromNode[static_cast<std::size_t>(light.node)];
  const glm::vec3 beam = -glm::vec3(world[2]);
  const float length = glm::length(beam);
  const bool hasDirection = length > 0.0f;
  block.lightPosition[index] = world[3];
  block.lightDirection[index] = glm::vec4(hasDirection ? beam / length : glm::vec3(0, -1, 0), 0.0f);
  block.lightColor[index] = glm::vec4(hasDirection ? light.color * light.intensity : glm::vec3(0.0f), 0.0f);
  block.lightTerms[index] = lightTerms(light);
}

} // namespace

LightCounts lightCounts(const Scene& scene) {
  LightCounts counts{.directional = scene.sky.sunEnabled ? 1 : 0};
  for (const Light& light : scene.lights) {
    counts.directional += isDrawnAs(light, true);
    counts.near += isDrawnAs(light, false);
  }
  counts.directional = std::min(counts.directional, shared::kMaxLights);
  counts.near = std::min(counts.near, shared::kMaxLights - counts.directional);
  return counts;
}

shared::LightBlock lightBlock(const Scene& scene, const Pose& pose) {
  shared::LightBlock block{};
  int index = 0;
  if (scene.sky.sunEnabled) {
    block.lightDirection[0] = glm::vec4(-glm::normalize(scene.sky.sunDirection), 0.0f);
    block.lightColor[0] = glm::vec4(scene.sky.sunColor, 0.0f);
    index = 1;
  }
  for (const bool directional : {true, false})
    for (const Light& light : scene.lights)
      if (isDrawnAs(light, directional) && index < shared::kMaxLights) fillLight(light, pose, block, index++);
  return block;
}

} // namespace taa
