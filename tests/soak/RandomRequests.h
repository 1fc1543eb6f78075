// Requests to the render thread, drawn at random: of every kind, with values that are right and values that
// are none.
#pragma once

#include "core/requests/Requests.h"

#include <random>
#include <string>

namespace taa::soak {

struct RandomRequest {
  Request request;
  std::string text; ///< what it is, for the log
};

/// The next one of a sequence that `random` alone decides.
RandomRequest randomRequest(std::mt19937& random);

} // namespace taa::soak
