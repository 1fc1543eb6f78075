// Which explanation tells the most of what is wrong.
#pragma once

#include <cstddef>
#include <vector>

namespace taa::doctor {

/// An explanation that fits a region.
struct FittingTrial {
  std::size_t trial = 0;
  double pixels = 0.0; ///< of the region
  double gain = 0.0;   ///< what it leaves less there than what is given; below 0 where outlines or middles
                       ///< tell it and pixels lose by it
};

/// Of the trials that fit: the one with the most pixels; of those with as many, the first that gains nearly
/// as much as any. Expects one at least.
std::size_t broadestTrial(const std::vector<FittingTrial>& fitting);

} // namespace taa::doctor
