// JSON, by a name that a local variable does not have.
#pragma once

#include <nlohmann/json.hpp>

namespace taa {

using Json = nlohmann::json;

} // namespace taa
