// How depth goes on over flat surfaces: that of a projection grows evenly from pixel to pixel there, and so
// does 1 over a distance.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/frames/Regions.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::doctor {

/// Three pixels in a row, of one region: those over which the value stored grows clearly more evenly than 1
/// over it, and the other way around.
struct DepthForm {
  std::size_t even = 0, evenReciprocal = 0;

  void add(const DoctorFrame& frame, const std::vector<RegionIndex>& labels);
  std::size_t rows() const { return even + evenReciprocal; }
  /// Of these, over which 1 over the value is the even one. 0: there are none.
  double distanceShare() const;
  /// Whether the value stored is a distance, which is even as 1 over it; nothing where the rows do not agree.
  std::optional<bool> isDistance() const;
};

} // namespace taa::doctor
