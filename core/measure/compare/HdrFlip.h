// HDR-FLIP: FLIP of scene-linear pictures at all exposures in which somebody may look at them. No GL.
//
// Andersson, Nilsson, Shirley, Akenine-Möller: Visualizing Errors in Rendered High Dynamic Range Images,
// Eurographics 2021. A pixel's value is the largest FLIP over the exposures. Both pictures are multiplied by
// 2^c, tone mapped with Narkowicz's fit of ACES and compared as FLIP does; c goes in equal steps from the
// exposure at which the reference's brightest pixel becomes 0.85 to that at which its median does, by
// luminance (Rec. 709). There are max(2, ⌈last − first⌉) exposures. Where more than half of the reference is
// black, the median is that of the pixels that are not, which the paper does not say; a reference that is all
// black is looked at with exposure 0.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"

#include <vector>

namespace taa {

/// Narkowicz's fit of ACES, without its factor 0.6 on the exposure, as the paper has it; clamped to 0…1.
float acesToneMapped(float linear);

/// Exposures in stops at which pictures are compared with this reference, rising.
std::vector<double> flipExposures(const Image& reference);

/// Costs a FLIP for each exposure: seconds. Reports each of them; throws Cancelled.
Image hdrFlipMap(const Image& picture, const Image& reference, const Progress& progress = {});

} // namespace taa
