// Which of some names are spelled most like one that is not among them, for "did you mean".
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace taa {

/// The `count` names, or all where there are fewer, that take the fewest changed letters, the best first. Of
/// a long name only the beginning is looked at, so that it costs no time.
std::vector<std::string_view> nearestNames(std::string_view name, std::span<const std::string_view> names,
                                           std::size_t count);

} // namespace taa
