// SSIM: how alike the structure of two pictures is, and the map of where it is not. No GL.
//
// Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment: From Error Visibility to Structural Similarity,
// IEEE TIP 2004. Of luma of what a screen is sent, 0…1, over a window of 11 × 11 pixels weighted by a
// Gaussian with σ = 1.5 whose sum is 1, with means μ, variances σ² and covariance σxy of that window:
//   SSIM = (2 μx μy + C1) (2 σxy + C2) / ((μx² + μy² + C1) (σx² + σy² + C2)),  C1 = 0.01², C2 = 0.03²
// 1: the same; 0: nothing in common; down to −1 where one is the other's negative. Color is not seen.
#pragma once

#include "core/base/Image.h"

namespace taa {

/// How far a pixel's value reaches, px (see flipReach()).
inline constexpr int kSsimReach = 5;

/// SSIM of each pixel, one channel; outside the picture its outermost pixels go on. Both are what a screen is
/// sent (shownColors()), have the same size and three channels at least.
Image ssimMap(const Image& shown, const Image& reference);

/// Mean of the map over the pixels whose window lies in the picture, as the authors' program has it; over all
/// where the picture has no such pixel.
double meanSsim(const Image& map);

} // namespace taa
