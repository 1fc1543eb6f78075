// Whether a verdict stands on more than the noise of the reference that it was concluded from. No GL.
#pragma once

#include "core/verdict/pixel/PixelVerdict.h"

namespace taa {

/// How far the reference may be off at a pixel.
struct ReferenceDoubt {
  double error = 0.0;   ///< standard error as shown, 0 to 1, of the largest channel
  bool isMoving = true; ///< it is another one in other frames: what is the same in all makes no flicker
};

/// Whether another reference that is off by as much could lead to another verdict: to twice its standard
/// error, the pixel's error may lie on the other side of what is visible, its flicker as well, or another
/// part may be most of the error. `origin`: of which the parts were taken.
bool isInDoubt(const ReferenceDoubt& doubt, const PixelVerdict& verdict, const PixelError& origin);

} // namespace taa
