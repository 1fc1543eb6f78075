#include "core/render/FogCones.h"

#include "core/render/FrameClock.h"
#include "core/render/FrameRequest.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace taa {

static_assert(kMaxFogCones == shared::kMaxFogCones);

namespace {

constexpr int kNoises = 256; ///< frames until the noise repeats

/// Of the frame itself and of those before it that a history of fog may have.
int framesOfFog(const Scene& scene, const FrameRequest& request, int frame) {
  const InputSettings& settings = request.inputs;
  if (settings.fogHistory == FogHistory::None) return 1;
  const int most = std::min(settings.fogFrames, shared::kMaxFogFrames);
  int frames = 1;
  while (frames < most && !startsHistory(scene, request.restarts, frame - frames + 1)) ++frames;
  return frames;
}

void fillShape(const FogCone& cone, float factor, shared::FogBlock& block, int index) {
  block.light[index] = glm::vec4(cone.light, cone.density * factor);
  block.shape[index] = {cone.startRadius, (cone.endRadius - cone.startRadius) / cone.length,
                        cone.fading / cone.length, cone.length};
}

/// Distances from the camera between which a sphere around the cone lies.
glm::vec2 reachOf(const glm::vec4& shape, const glm::vec3& apex, const glm::vec3& axis, const View& view) {
  const float length = shape.w, end = shape.x + shape.y * length;
  const glm::vec3 away = apex + 0.5f * length * axis - glm::vec3(view.block.cameraPosition);
  const glm::vec3 forward =
      -glm::vec3(view.block.viewFromWorld[0].z, view.block.viewFromWorld[1].z, view.block.viewFromWorld[2].z);
  const bool isParallel = view.block.cameraPosition.w > 0.5f;
  const float middle = isParallel ? glm::dot(away, forward) : glm::length(away);
  const float radius = std::sqrt(0.25f * length * length + end * end);
  return {std::max(middle - radius, 0.0f), std::max(middle + radius, 0.0f)};
}

} // namespace

bool drawsFog(const Scene& scene, const InputSettings& settings) {
  return !scene.fog.empty() && settings.fogDensity > 0.0f;
}

shared::FogBlock fogBlock(const Scene& scene, const FrameRequest& request, const View& view) {
  const InputSettings& settings = request.inputs;
  shared::FogBlock block{};
  std::vector<const FogCone*> cones;
  for (const FogCone& cone : scene.fog)
    if (view.nodes[static_cast<std::size_t>(cone.node)].isVisible) cones.push_back(&cone);
  const int count = std::min(static_cast<int>(cones.size()), shared::kMaxFogCones);
  const int frames = framesOfFog(scene, request, view.info.frame);
  block.counts = {count, frames, settings.fogSteps, 0};
  for (int i = 0; i < count; ++i)
    fillShape(*cones[static_cast<std::size_t>(i)], settings.fogDensity, block, i);
  glm::vec2 reach(std::numeric_limits<float>::max(), 0.0f);
  for (int age = 0; age < frames; ++age) {
    const int frame = view.info.frame - age;
    const Pose pose = age == 0 ? view.pose : poseAt(scene, frameTime(scene, frame));
    for (int i = 0; i < count; ++i) {
      const glm::mat4& world =
          pose.worldFromNode[static_cast<std::size_t>(cones[static_cast<std::size_t>(i)]->node)];
      const int at = age * shared::kMaxFogCones + i;
      const glm::vec3 apex(world[3]), axis = glm::normalize(-glm::vec3(world[2]));
      const int noise = settings.fogAnimated == Switch::On ? frame % kNoises : 0;
      block.apex[at] = glm::vec4(apex, static_cast<float>(noise));
      block.axis[at] = glm::vec4(axis, 0.0f);
      const glm::vec2 own = reachOf(block.shape[i], apex, axis, view);
      reach = {std::min(reach.x, own.x), std::max(reach.y, own.y)};
    }
  }
  if (count > 0)
    block.march = {reach.x, (reach.y - reach.x) / static_cast<float>(std::max(settings.fogSteps, 1)), 0.0f,
                   0.0f};
  return block;
}

} // namespace taa
