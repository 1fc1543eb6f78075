// What hides what: a pixel that comes out from behind something lay farther away than what hid it. Motion and
// regions tell that without a camera, and depth has to agree.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/frames/Regions.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa::doctor {

enum class OrderVerdict : std::uint8_t {
  TooFew,
  Agrees,   ///< what hides is nearer by the depth stored
  Reversed, ///< it is farther away
  Unclear,  ///< now this, now that: motion or regions are not right
};

/// Pixels that were hidden a frame ago, well inside what hid them, by what the depth stored says of what hid
/// them.
struct DepthOrder {
  std::size_t nearer = 0, farther = 0;
  int frames = 0; ///< in which there were some

  /// `labels`, `labelsBefore`: the regions of the pixels of both frames. Needs motion, depth and object
  /// numbers.
  void add(const DoctorFrame& now, const DoctorFrame& before, const std::vector<RegionIndex>& labels,
           const std::vector<RegionIndex>& labelsBefore);
  std::size_t pixels() const { return nearer + farther; }
  /// Of these pixels, by which what hides is farther away. 0: there are none.
  double reversedShare() const;
  OrderVerdict verdict() const;
};

} // namespace taa::doctor
