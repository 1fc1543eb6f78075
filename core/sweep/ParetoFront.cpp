#include "core/sweep/ParetoFront.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace taa {

// Along the first number, a trade-off is on the front where its second is less than all before it have: of
// those with the same first number only the least second, which all that share both have.
std::vector<bool> onParetoFront(std::span<const TradeOff> tradeOffs) {
  std::vector<std::size_t> order;
  for (std::size_t index = 0; index < tradeOffs.size(); ++index)
    if (const TradeOff& each = tradeOffs[index]; each && !std::isnan((*each)[0]) && !std::isnan((*each)[1]))
      order.push_back(index);
  std::ranges::sort(order, {}, [&](std::size_t index) { return *tradeOffs[index]; });
  std::vector<bool> isOnFront(tradeOffs.size(), false);
  double least = std::numeric_limits<double>::infinity();
  bool isFirst = true;
  std::array<double, 2> last{};
  for (const std::size_t index : order) {
    const std::array<double, 2>& each = *tradeOffs[index];
    const bool isEqual = !isFirst && each == last;
    if (!isFirst && !isEqual && !(each[1] < least)) continue;
    isOnFront[index] = true;
    least = each[1];
    last = each;
    isFirst = false;
  }
  return isOnFront;
}

} // namespace taa
