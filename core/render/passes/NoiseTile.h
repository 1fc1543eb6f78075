// A tile of blue noise: ranks spread so that no low frequencies are in any of its thresholds.
#pragma once

#include "core/base/Image.h"

namespace taa {

inline constexpr int kNoiseTileSize = 32;

/// Void-and-cluster (Ulichney 1993) on a torus: one channel, each of (rank + ½)/1024 once. The same bits on
/// every run; takes some milliseconds.
Image blueNoiseTile();

} // namespace taa
