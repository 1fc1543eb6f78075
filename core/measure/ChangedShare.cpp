#include "core/measure/ChangedShare.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace taa {

double shareOfChanged(std::span<const ChangedRow> rows) {
  assert(!rows.empty() && !rows.front().row.empty());
  const std::size_t pixels = static_cast<std::size_t>(rows.front().row.width) * rows.front().row.height;
  std::vector<bool> changed(pixels, false);
  for (const auto& [row, untouched] : rows) {
    const auto channels = static_cast<std::size_t>(row.channels);
    assert(row.pixels.size() == pixels * channels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
      for (std::size_t channel = 0; channel < channels; ++channel)
        if (row.pixels[pixel * channels + channel] != untouched) changed[pixel] = true;
  }
  return static_cast<double>(std::ranges::count(changed, true)) / static_cast<double>(pixels);
}

} // namespace taa
