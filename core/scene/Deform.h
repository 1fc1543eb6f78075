// Where deformed vertices are, by the formulas of manual 3.4 to 3.7; what shaders/scene/deform.glsl does
// on the GPU.
#pragma once

#include "core/scene/Pose.h"

#include <cstddef>
#include <vector>

namespace taa {

/// Joint matrices (world from model) of a skin in a pose.
std::vector<glm::mat4> jointMatrices(const Scene& scene, const Skin& skin, const Pose& pose);

/// Whether vertices of `primitive` at `node` move other than with the node.
bool isDeformed(const Scene& scene, const Node& node, const Primitive& primitive);

/// The entry of the cache that counts at `time` seconds.
int cacheFrame(const VertexCache& cache, double time);

/// The vertices of one primitive at one node, or at one of its instances, in one frame.
class Deformer {
 public:
  /// `secondsBack` moves cached vertices against their velocity: 0 for this frame, Δt for the previous one,
  /// whose `pose` is then that of the previous frame while `cacheTime` stays that of this one.
  Deformer(const Scene& scene, const NodeInstance& at, const Primitive& primitive, const Pose& pose,
           double cacheTime, double secondsBack = 0.0);

  /// World position: cache, morph targets, wind, then the skin or the node's transform.
  glm::vec3 position(std::size_t vertex) const;

 private:
  glm::vec3 skinned(std::size_t vertex, const glm::vec3& position) const;

  const Scene& scene_;
  const Node& node_;
  const Primitive& primitive_;
  const Pose& pose_;
  glm::mat4 worldFromModel_;
  std::size_t firstEntry_ = 0; ///< of the cache
  float secondsBack_;
  std::vector<glm::mat4> joints_;
};

} // namespace taa
