// JSON of somebody else's, read in time and memory that its size bounds.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string_view>

namespace taa {

inline constexpr std::size_t kMaxJsonBytes = std::size_t(64) << 20;

struct JsonLimits {
  std::size_t bytes = kMaxJsonBytes;           ///< of the text
  int depth = 32;                              ///< objects and lists in each other
  std::size_t entries = 1'000'000;             ///< of one object or list
  std::size_t memory = std::size_t(400) << 20; ///< bytes of what is read, about
};

/// In time that grows with the text alone. Throws Error that says where: not JSON, a key twice in an object,
/// deeper or larger than the limits.
nlohmann::json parseLimited(std::string_view text, const JsonLimits& limits = {});

} // namespace taa
