// What a picture is made of: a row of a frame of a lane.
#pragma once

#include "core/taa/Intermediates.h"

#include <optional>

namespace taa {

struct PictureSource {
  IntermediateId id = IntermediateId::resolved;
  int lane = 0;
  std::optional<int> frame{}; ///< a comparison frame; nothing: the frame on show
  /// Read where each pixel of the frame on show came from: `frame` is the one before, nothing: there is none.
  bool alongMotion = false;
  bool operator==(const PictureSource&) const = default;
};

} // namespace taa
