// What is looked at of an open source: a row of a lane's frame.
#pragma once

#include "core/taa/rows/Intermediates.h"

#include <optional>

namespace taa {

struct Look {
  IntermediateId id = IntermediateId::resolved;
  int lane = 0;
  std::optional<int> frame{}; ///< one that is kept aside; nothing: the frame on show
  bool operator==(const Look&) const = default;
};

} // namespace taa
