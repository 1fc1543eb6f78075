// Squares that are made up, as what is told of them takes them.
#pragma once

#include "core/doctor/flow/Flow.h"

#include <vector>

namespace taa::test {

inline std::vector<const doctor::FlowSquare*> pointersTo(const std::vector<doctor::FlowSquare>& squares) {
  std::vector<const doctor::FlowSquare*> out;
  for (const doctor::FlowSquare& square : squares) out.push_back(&square);
  return out;
}

} // namespace taa::test
