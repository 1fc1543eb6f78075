// Where a row of frames that are made beside the one on show has come to.
#pragma once

#include <memory>

namespace taa {

struct History;

/// The history that its last frame left. Worth nothing once what frames are a function of has changed.
struct TraceCursor {
  int frame = 0;
  std::shared_ptr<const History> history; ///< also owned by the frame made last; null: not begun
};

} // namespace taa
