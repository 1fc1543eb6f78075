#include "core/scene/Deform.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace taa {

std::vector<glm::mat4> jointMatrices([[maybe_unused]] const Scene& scene, const Skin& skin,
                                     const Pose& pose) {
  assert(skin.joints.size() == skin.inverseBinds.size() && pose.worldFromNode.size() == scene.nodes.size());
  std::vector<glm::mat4> matrices;
  matrices.reserve(skin.joints.size());
  for (std::size_t i = 0; i < skin.joints.size(); ++i)
    matrices.push_back(pose.worldFromNode[static_cast<std::size_t>(skin.joints[i])] * skin.inverseBinds[i]);
  return matrices;
}

bool isDeformed(const Scene& scene, const Node& node, const Primitive& primitive) {
  return (node.skin >= 0 && primitive.influenceSets > 0) || !primitive.targets.empty() ||
         primitive.cache.frames > 0 ||
         scene.materials[static_cast<std::size_t>(primitive.material)].wind.amplitude != 0.0f;
}

int cacheFrame(const VertexCache& cache, double time) {
  if (cache.frames == 0) return 0;
  const auto frame = static_cast<long long>(std::floor(time * cache.framesPerSecond + 0.5));
  return static_cast<int>(frame % cache.frames);
}

Deformer::Deformer(const Scene& scene, const NodeInstance& at, const Primitive& primitive, const Pose& pose,
                   double cacheTime, double secondsBack)
    : scene_(scene), node_(scene.nodes[static_cast<std::size_t>(at.node)]), primitive_(primitive),
      pose_(pose), worldFromModel_(worldFromInstance(scene, pose, at)),
      firstEntry_(static_cast<std::size_t>(cacheFrame(primitive.cache, cacheTime)) *
                  primitive.vertices.size()),
      secondsBack_(static_cast<float>(secondsBack)) {
  if (node_.skin >= 0 && primitive.influenceSets > 0)
    joints_ = jointMatrices(scene, scene.skins[static_cast<std::size_t>(node_.skin)], pose);
}

glm::vec3 Deformer::position(std::size_t vertex) const {
  glm::vec3 position = primitive_.vertices[vertex].position;
  if (primitive_.cache.frames > 0) {
    const VertexCache::Entry& entry = primitive_.cache.entries[firstEntry_ + vertex];
    position = entry.position - secondsBack_ * entry.velocity;
  }
  for (std::size_t target = 0; node_.firstWeight >= 0 && target < primitive_.targets.size(); ++target)
    position += pose_.morphWeights[static_cast<std::size_t>(node_.firstWeight) + target] *
                primitive_.targets[target][vertex].position;
  const Wind& wind = scene_.materials[static_cast<std::size_t>(primitive_.material)].wind;
  if (wind.amplitude != 0.0f) {
    const float phase =
        wind.waveNumber * (position.x + position.z) + wind.frequency * static_cast<float>(pose_.time);
    position += wind.direction * (wind.amplitude * primitive_.vertices[vertex].uv1.y * std::sin(phase));
  }
  return joints_.empty() ? glm::vec3(worldFromModel_ * glm::vec4(position, 1.0f)) : skinned(vertex, position);
}

// Σ w_j M_j x over the joints of the vertex (3.4).
glm::vec3 Deformer::skinned(std::size_t vertex, const glm::vec3& position) const {
  glm::vec3 sum(0.0f);
  const auto sets = static_cast<std::size_t>(primitive_.influenceSets);
  for (std::size_t set = 0; set < sets; ++set) {
    const Influence& influence = primitive_.influences[vertex * sets + set];
    for (int i = 0; i < 4; ++i)
      sum += influence.weights[i] *
             glm::vec3(joints_[static_cast<std::size_t>(influence.joints[i])] * glm::vec4(position, 1.0f));
  }
  return sum;
}

} // namespace taa
