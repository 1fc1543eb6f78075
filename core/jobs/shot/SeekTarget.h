// The frame that the render thread is on its way to.
#pragma once

#include <optional>

namespace taa {

struct SeekTarget {
  std::optional<int> frame; ///< nothing: where it is
  bool isNear = false;      ///< the nearest cached frame is on show until it is there

  void set(int to) {
    frame = to;
    isNear = false;
  }
};

} // namespace taa
