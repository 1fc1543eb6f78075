// Sharpness: how steep the picture's edges are, compared with the reference's. No GL.
//
// g: length of the gradient of luma of what a screen is sent, by Sobel's two 3 × 3 operators, / 8, so that a
// ramp of s a pixel has g = s. The edges are the pixels with g_reference > 0.05.
//   sharpness = Σ g_picture / Σ g_reference over the edges
// 1: as steep as the reference; less: blurred; more: aliased or sharpened, for a step between two pixels is
// steeper than what the reference has of it. An edge that stands a pixel beside its place is half as
// steep where it should be, so that a wrong place counts as blur.
#pragma once

#include "core/base/Image.h"

#include <optional>

namespace taa {

inline constexpr float kSharpnessEdge = 0.05f; ///< a twentieth of black to white in a pixel

/// Nothing where the reference has no edge. Both are what a screen is sent (shownColors()), have the same
/// size and three channels at least.
std::optional<double> sharpness(const Image& shown, const Image& reference);

} // namespace taa
