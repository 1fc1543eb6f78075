// Where everything is at a time: node transforms and the camera, pure functions of the scene and the time.
#pragma once

#include "core/scene/Scene.h"

#include <string>
#include <vector>

namespace taa {

/// World transforms of all nodes at one instant.
struct Pose {
  std::vector<glm::mat4> worldFromNode; ///< one for each of Scene::nodes
  std::vector<float> morphWeights;      ///< as Scene::morphWeights
  double time = 0.0;                    ///< seconds
};

/// The pose at `time` seconds, the scene's first animation repeating. A pure function: the same time gives
/// the same bits.
Pose poseAt(const Scene& scene, double time);

/// One of the places that a node draws its mesh at: its instances, or itself as number 0.
struct NodeInstance {
  int node = -1, instance = 0;
  // NOLINTNEXTLINE(google-explicit-constructor): most nodes have none
  NodeInstance(int node_, int instance_ = 0) : node(node_), instance(instance_) {}
};

/// World from model there.
glm::mat4 worldFromInstance(const Scene& scene, const Pose& pose, const NodeInstance& at);

/// An entry of Scene::instances: scaled, then turned, then moved.
glm::mat4x3 instanceTransform(const glm::vec3& translation, const glm::quat& rotation,
                              const glm::vec3& scale);

/// What the first uv set is multiplied by (xy) and shifted by (zw) at `time` seconds.
glm::vec4 animatedUv(const UvAnimation& animation, double time);

/// A camera at one instant. View space looks along −z, y up; depth is reversed with an infinite far plane.
struct CameraState {
  glm::mat4 viewFromWorld{1.0f};
  glm::mat4 clipFromView{
      1.0f}; ///< unjittered, reversed depth in 0…1, y up (GL clip space before glClipControl)
  bool orthographic = false;
  float nearPlane = 0.01f;
};

/// Names of the camera paths of a scene: "still", "pan", "orbit", "dolly", then "gltf:<name>" for each of its
/// own and those a built-in scene adds.
std::vector<std::string> cameraNames(const Scene& scene);

/// The camera of path `name` at `time`, fitted to the scene's bounds; `aspect` is width over height.
/// Throws Error when there is no such path (naming those there are).
CameraState cameraAt(const Scene& scene, const std::string& name, double time, float aspect);

/// Reversed-depth projections, infinite far plane for perspective.
glm::mat4 perspectiveReversed(float fovY, float aspect, float nearPlane);
glm::mat4 orthographicReversed(float height, float aspect, float nearPlane, float farPlane);

} // namespace taa
