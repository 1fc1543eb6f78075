#include "core/base/NearestNames.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace taa {

namespace {

constexpr std::size_t kLongestCompared = 48; ///< bytes of a name that are compared: more than any table's has

// Levenshtein's distance.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::array<std::size_t, kLongestCompared + 1> row;
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, substituted});
    }
  }
  return row[b.size()];
}

} // namespace

std::vector<std::string_view> nearestNames(std::string_view name, std::span<const std::string_view> names,
                                           std::size_t count) {
  std::vector<std::pair<std::size_t, std::string_view>> ranked;
  for (const std::string_view known : names)
    ranked.emplace_back(editDistance(name.substr(0, kLongestCompared), known.substr(0, kLongestCompared)),
                        known);
  std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, std::string_view>::first);
  std::vector<std::string_view> nearest;
  for (const auto& [distance, known] : ranked)
    if (nearest.size() < count) nearest.push_back(known);
  return nearest;
}

} // namespace taa
