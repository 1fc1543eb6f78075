// What a model that brings neither light nor camera stands on, so that it does not float.
#pragma once

#include "core/scene/Scene.h"

#include <string_view>

namespace taa {

inline constexpr std::string_view kGroundName = "added ground"; ///< of its node

/// Whether a file is a model alone: something to see, but no light and no camera.
bool isModelAlone(const Scene& scene);

/// Adds a round floor under the model, the last of the nodes, and lets the sun cast soft shadows on it. The
/// bounds stay those of the model, so that cameras look at it. Expects isModelAlone().
void addGround(Scene& scene);

} // namespace taa
