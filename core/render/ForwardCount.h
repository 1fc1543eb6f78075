// Where pixels of the last frame are now: what forward reprojection would have to fill (manual §5, source
// 004).
#pragma once

#include "core/base/Image.h"

namespace taa {

/// How many pixels of the last frame land in each pixel. `motionPx`: of the last frame, by what each has
/// moved on since, negated; see kNoPreviousPosition. Pixels that leave the picture land nowhere.
Image forwardCount(const Image& motionPx);

} // namespace taa
