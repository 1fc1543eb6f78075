// Scenes of a few quads for tests of the renderer: everything in them has a known place and motion.
#pragma once

#include "core/scene/Scene.h"

#include <string>

namespace taa::test {

inline constexpr const char* kEye = "gltf:eye"; ///< camera path of the scenes below

/// No objects; a perspective camera at (0, 0, 10) that looks along −z with fovY 60°, and no sun. Node 0 is
/// the camera's, material 0 is unlit white. 60 frames a second, 16 frames.
Scene emptyScene();

/// Adds a parallelogram around the origin of its own node, facing right × up, at `center`. Returns the node.
int addQuad(Scene& scene, const glm::vec3& center, const glm::vec3& right, const glm::vec3& up,
            int material = 0);

/// Adds a material like material 0 with another base color.
int addColor(Scene& scene, const glm::vec4& baseColor);

/// Moves or turns `node` at once between frames 0 and 1: from `before` to `after`.
void jump(Scene& scene, int node, AnimationPath path, const glm::vec4& before, const glm::vec4& after);

} // namespace taa::test
