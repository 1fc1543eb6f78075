// Node animations of a glTF file.
#pragma once

namespace taa {

struct GltfContext;

/// Fills Scene::animations with what moves nodes of the scene.
void addGltfAnimations(GltfContext& context);

} // namespace taa
