// FLIP: how much a person who flips between two pictures on a screen sees of their difference. No GL.
//
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP: A Difference Evaluator for
// Alternating Images, HPG 2020. With all steps and constants of the paper:
//   color    linear RGB → YCxCz; each channel filtered by what the eye resolves at so many pixels per degree
//            (a Gaussian for Y and Cx, a sum of two for Cz); clamped to the RGB cube; L*a*b* with a* and b*
//            times 0.01 L* (Hunt); HyAB distance |ΔL| + √(Δa² + Δb²), to the power 0.7 =: e
//            ΔEc = 0.95 e / (0.4 m) below 0.4 m, else 0.95 + 0.05 (e − 0.4 m) / (0.6 m), with m that of green
//            and blue
//   feature  Y in 0…1 filtered by the first and the second derivative of a Gaussian, 0.082 degrees wide,
//   along x
//            and y: length of the edge, length of the point
//            ΔEf = √(max(|Δ edge|, |Δ point|) / √2)
//   FLIP     ΔEc ^ (1 − ΔEf), 0 to 1
// The filters are products along rows and columns; outside the picture its outermost pixels go on.
#pragma once

#include "core/base/Image.h"

namespace taa {

/// The paper's: a screen 0.7 m wide with 3840 pixels across, seen from 0.7 m. 67.02.
inline constexpr double kFlipPixelsPerDegree = 3840.0 * 3.14159265358979323846 / 180.0;

/// How far a pixel's value reaches, px: the map of a part that is this much larger on all sides holds the
/// part's own values, bit for bit.
int flipReach(double pixelsPerDegree = kFlipPixelsPerDegree);

/// FLIP of each pixel of what a screen shows of scene-linear pictures: exposure 0, clamped to 0…1. Both have
/// the same size and three channels at least. The number of a picture is the mean of its map, as the paper
/// says.
Image flipMap(const Image& picture, const Image& reference, double pixelsPerDegree = kFlipPixelsPerDegree);

} // namespace taa
