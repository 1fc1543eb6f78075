// What people see of a hypothesis: a frame, the frame before it moved as the conventions say, and what is
// left between them.
#pragma once

#include "core/base/Image.h"
#include "core/capture/decode/DecodedFrame.h"

namespace taa::capture {

/// One channel each, luma l as l / (1 + l); as large as the frame.
struct WarpedPair {
  Image current, warped, difference; ///< difference: |current − warped|; 0 where nothing is known
  double residual = 0.0;             ///< mean of the difference × 1000
};

/// Of a frame and the one before, decoded under the conventions that are looked at; see decode(). Without
/// motion nothing moves but the jitter. Throws Error where the two are not of one size.
WarpedPair warpedPair(const DecodedFrame& frame, const DecodedFrame& previous);

} // namespace taa::capture
