// Meshes of a glTF file: vertices from accessors, all topologies unrolled, normals and tangents made where
// missing.
#pragma once

#include <glm/mat4x4.hpp>

#include <span>

namespace taa {

struct GltfContext;

/// Builds the meshes the scene's nodes ask for and puts them on the nodes. `restTransforms` are the nodes' at
/// rest: skinned meshes are put into that pose and stand still; instances of EXT_mesh_gpu_instancing become
/// nodes.
void addGltfMeshes(GltfContext& context, std::span<const glm::mat4> restTransforms);

} // namespace taa
