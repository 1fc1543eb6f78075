// One primitive of a glTF mesh.
#pragma once

#include "core/scene/Scene.h"

#include <span>

namespace tinygltf {
struct Primitive;
}

namespace taa {

struct GltfContext;

/// Reads a primitive; `worldFromSkin`, one matrix for each joint, moves its vertices when it is not empty.
/// Throws Error with the place inside the mesh when its data are wrong. Without positions it comes back
/// empty.
Primitive readPrimitive(GltfContext& context, const tinygltf::Primitive& source,
                        std::span<const glm::mat4> worldFromSkin);

} // namespace taa
