// How much memory a process may still take.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace taa {

/// Bytes the machine can hand out without taking from others, or what the limit of the process's control
/// group leaves, whichever is less. Nothing where the system does not say.
std::optional<std::size_t> freeMemory();

/// "MemAvailable:  123 kB" of /proc/meminfo as bytes.
std::optional<std::size_t> availableIn(std::string_view meminfo);

} // namespace taa
