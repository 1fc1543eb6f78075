// One primitive of a glTF mesh.
#pragma once

#include "core/scene/Scene.h"

namespace tinygltf {
struct Primitive;
}

namespace taa {

struct GltfContext;

/// Reads a primitive with the joints, morph targets and velocities (`_VELOCITY`) that move its vertices.
/// Throws Error with the place inside the mesh when its data are wrong. Without positions it comes back
/// empty.
Primitive readPrimitive(GltfContext& context, const tinygltf::Primitive& source);

} // namespace taa
