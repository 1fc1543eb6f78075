// Nodes of a glTF file's scene, parents first, with its cameras and lights.
#pragma once

#include <glm/mat4x4.hpp>

#include <vector>

namespace taa {

struct GltfContext;

/// Fills Scene::nodes (without meshes), cameras and lights from the default scene, and
/// GltfContext::sceneNode.
void addGltfNodes(GltfContext& context);

/// World transforms of the scene's nodes at rest. Throws Error when one is not finite.
std::vector<glm::mat4> restTransforms(const GltfContext& context);

} // namespace taa
