// What kind of thing an object is, as an engine marks it in the stencil (catalogue 12.2).
#pragma once

#include "core/scene/Scene.h"

#include <cstdint>
#include <vector>

namespace taa {

enum class ObjectClass : std::uint8_t {
  Sky,
  Still,
  Moving,   ///< as a whole
  Deforming ///< by a skin, morph targets, a cache or wind
};

/// Which nodes move: those that the animation or a jump moves, and what hangs on them.
std::vector<bool> movingNodes(const Scene& scene);

} // namespace taa
