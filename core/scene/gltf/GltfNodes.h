// Nodes of a glTF file's scene, parents first, with its cameras and lights.
#pragma once

namespace taa {

struct GltfContext;

/// Fills Scene::nodes (without meshes), cameras and lights from the default scene, and
/// GltfContext::sceneNode.
void addGltfNodes(GltfContext& context);

/// Leaves kMaxLights of the scene's lights, and says so: directional ones first, then by candela at rest.
void keepStrongestLights(GltfContext& context);

/// Throws Error when the world transform of a node at rest is not finite.
void checkRestTransforms(const GltfContext& context);

} // namespace taa
