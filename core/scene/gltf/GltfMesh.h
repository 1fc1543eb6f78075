// Meshes of a glTF file: vertices from accessors, all topologies unrolled, normals and tangents made where
// missing.
#pragma once

namespace taa {

struct GltfContext;

/// Builds the meshes, skins and morph weights the scene's nodes ask for and puts them on the nodes; instances
/// of EXT_mesh_gpu_instancing become nodes.
void addGltfMeshes(GltfContext& context);

} // namespace taa
