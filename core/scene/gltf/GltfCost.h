// What the meshes of a glTF file will take, from the counts of its accessors: before any of them is read.
#pragma once

#include "core/scene/SceneCost.h"

namespace taa {

struct GltfContext;

/// Objects, triangles, vertices and bytes of the scene's meshes as costOf() will find them, images left out.
/// Expects GltfContext::sceneNode.
SceneCost gltfCost(const GltfContext& context);

/// Throws Error that names the node, or the mesh, that asks for most when the budget is smaller.
void checkGltfCost(const GltfContext& context, const SceneBudget& budget);

} // namespace taa
