// Everything about a few pixels: the resolve again, on those pixels only, with all of its inside exposed.
#pragma once

#include "core/taa/TaaPass.h"
#include "core/taa/twin/Twin.h"

#include <vector>

namespace taa {

/// All rows that a resolve gives for the pixels of `region`, row-major; those of the reference are NaN. The
/// region lies inside the picture. `resolved`: what the resolve made of the same.
std::vector<twin::PixelRecord> probeRegion(TaaPass& pass, const FrameInputs& inputs, const History* previous,
                                           const History& resolved, const Settings& settings,
                                           const gl::Rect& region);

} // namespace taa
