// Relative error: squared differences from the reference, over its own square, so that dark places count as
// bright ones do. No GL.
//
// Rousselle, Knaus, Zwicker: Adaptive Sampling and Reconstruction using Greedy Error Minimization, SIGGRAPH
// Asia 2011, give the form, (x − R)² / (R² + ε). ε = 0.01 is that of the published program of Gharbi et al.
// 2019 (whose loss has a factor ½ more): it says below what black counts as black, R ≈ 0.1. Scene-linear, not
// clamped, the mean over red, green and blue.
#pragma once

#include "core/base/Image.h"

#include <glm/vec3.hpp>

namespace taa {

inline constexpr double kRelativeEpsilon = 0.01;

double relativeError(const glm::vec3& picture, const glm::vec3& reference);

/// Relative MSE: the mean over all pixels. Both have the same size and three channels at least.
double relativeMse(const Image& picture, const Image& reference);

} // namespace taa
