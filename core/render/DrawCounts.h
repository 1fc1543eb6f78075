// How much of a scene a frame draws.
#pragma once

#include <cstddef>

namespace taa {

/// What became of a scene's objects in a frame: primitives at nodes.
struct DrawCounts {
  int objects = 0;           ///< that are there at the time and have triangles, lines or points
  int drawn = 0;             ///< those in the view
  std::size_t triangles = 0; ///< of these; lines and points count too
};

} // namespace taa
