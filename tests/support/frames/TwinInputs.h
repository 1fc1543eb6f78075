// Hand-made inputs of the CPU twin, and frames resolved by it.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec3.hpp>

#include <array>

namespace taa::test {

/// Everything at rest 1 m away, one color, no jitter, no history. Near plane at 0.1 m.
twin::Inputs constantInputs(int width, int height, const glm::vec3& color);

/// Gives `inputs` a history of one color and length, of the surface 1 m away.
void setHistory(twin::Inputs& inputs, const glm::vec3& color, float length);

/// Stores `color` at a pixel of an image of three or more channels.
void setColor(Image& image, int x, int y, const glm::vec3& color);
/// Stores gray levels of a 3×3 picture, row-major.
void setGrays(Image& image, const std::array<float, 9>& grays);

/// The simplest pipeline: center color, bilinear history, linear RGB, nothing rectified or rejected,
/// constant α, plain blend, full precision.
Settings plainSettings();

/// The plain average of all frames: that pipeline with α = 1/(N + 1) and 32-bit inputs.
Settings averagingSettings(int period = 16);

/// Everything about pixel (x, y) after every pixel was resolved and became the history of `inputs`.
twin::PixelRecord advance(twin::Inputs& inputs, const Settings& settings, int x, int y);

} // namespace taa::test
