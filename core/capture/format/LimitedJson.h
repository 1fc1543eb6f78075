// JSON of somebody else's, read in time and memory that its size bounds.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string_view>

namespace taa::capture {

inline constexpr std::size_t kMaxJsonBytes = std::size_t(64) << 20;
inline constexpr int kMaxJsonDepth = 32;                              ///< objects and lists in each other
inline constexpr std::size_t kMaxJsonEntries = 1'000'000;             ///< of one object or list
inline constexpr std::size_t kMaxJsonMemory = std::size_t(400) << 20; ///< bytes of what is read, about

/// Throws Error that says where: not JSON, a key twice in an object, deeper or larger than the limits.
nlohmann::json parseLimited(std::string_view text);

} // namespace taa::capture
