// Which of some trade-offs nobody would turn down: no other one is better in one metric and not worse in the
// other.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace taa {

/// Two numbers of which less is better; nothing where one of them is not known.
using TradeOff = std::optional<std::array<double, 2>>;

/// Where each of them lies on the front. Equal ones are on it together; what is not known, or no number, is
/// not.
std::vector<bool> onParetoFront(std::span<const TradeOff> tradeOffs);

} // namespace taa
