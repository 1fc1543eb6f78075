// Puts a scene together by code: hands out the indices that parts of a scene know each other by.
#pragma once

#include "core/scene/Scene.h"
#include "core/scene/builtin/MeshBuilder.h"

#include <functional>
#include <string>
#include <vector>

namespace taa {

class SceneBuilder {
 public:
  explicit SceneBuilder(std::string name);

  int addImage(SceneImage image);
  int addMaterial(const Material& material);
  /// One node with one mesh; the primitives may have different materials.
  int addObject(const std::string& name, std::vector<Primitive> primitives, int parent = -1);
  /// Another node that draws the mesh of `object`.
  int addInstance(int object, const glm::vec3& translation, const glm::vec3& scale = glm::vec3(1.0f));
  int addNode(const std::string& name, const glm::vec3& translation, const glm::quat& rotation = {1, 0, 0, 0},
              int parent = -1);
  void addPointLight(const std::string& name, const glm::vec3& position, const glm::vec3& color,
                     float candela);
  /// A camera on a node of its own, looking along `direction`; returns the node.
  int addCamera(const std::string& name, const glm::vec3& eye, const glm::vec3& direction, float fovY);

  /// Moves `node` by `offset(angle)` (with its derivative by the angle) around a loop of `seconds`.
  void animateLoop(int node, float seconds, const std::function<glm::vec3(float)>& position,
                   const std::function<glm::vec3(float)>& derivative);
  /// Spins `node` around its z axis, counter-clockwise, `turns` times in `seconds`.
  void animateSpin(int node, float seconds, int turns);

  /// Swings `node` around its z axis by up to `angle` radians to both sides, `times` in `seconds`.
  void animateSwing(int node, float seconds, float angle, int times);
  /// Morph weights of `node` at each of `times`, one value a target.
  void animateWeights(int node, const std::vector<float>& times, const std::vector<float>& weights);
  /// Puts `node` from place to place, `seconds` at each, at once.
  void animateSteps(int node, float seconds, const std::vector<glm::vec3>& places);
  /// Moves `node` at a constant speed and starts over after `seconds`.
  void animateSteady(int node, float seconds, const glm::vec3& from, const glm::vec3& to);

  Scene& scene() { return scene_; }
  /// The scene with its bounds.
  Scene finish();

 private:
  Animation& animation(float seconds);

  Scene scene_;
};

/// A plain material; `color` linear.
Material paintOf(const glm::vec3& color, float roughness, float metallic = 0.0f);

/// A slot that shows `image`, repeated.
TextureSlot textureSlot(int image);

/// The rotation of a camera or light that looks along `direction`, y up.
glm::quat lookRotation(const glm::vec3& direction);

} // namespace taa
