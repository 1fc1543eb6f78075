// Colors as the resolve sees them: read safely, measured, and moved into the space of the box.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace taa::twin {

/// NaN, negative, infinite or above the largest half float.
bool isBad(float value);
/// The color with bad channels those of another, or 0.
glm::vec3 saneOr(const glm::vec3& other, const glm::vec3& color);
glm::vec3 sanitized(const glm::vec3& color);

/// What a computed color becomes: negative values and NaN 0, too bright ones the brightest half.
glm::vec3 storable(const glm::vec3& color);

/// Rec. 709 luma of scene-linear color.
float luma(const glm::vec3& color);
/// Luma that colors are weighed by, in every stage (manual 15.1).
float weightLuma(const glm::vec3& color, WeightLuma chosen);

/// Within 0 and 1; NaN becomes 0.
float saturated(float x);

/// Highlights bounded (manual §15), and back.
glm::vec3 compress(const glm::vec3& color, ToneSpace tone);
glm::vec3 decompress(const glm::vec3& color, ToneSpace tone);

/// Whether colors are compressed before they are mixed (manual 15.3 to 15.7); that, and back.
bool mixesCompressed(ToneWeight tone);
glm::vec3 compress(const glm::vec3& color, const BlendSettings& blend);
glm::vec3 decompress(const glm::vec3& color, const BlendSettings& blend);

/// Scene-linear color in the space the box is built in (manual §9, §15), and back.
glm::vec3 toBox(const glm::vec3& color, const SpaceSettings& space);
glm::vec3 fromBox(const glm::vec3& box, const SpaceSettings& space);
/// The same axes with a way back that is not clamped as printed (manual §26, D7).
SpaceSettings withoutClamp(const SpaceSettings& space);
/// Luma of a color of that space.
float boxLuma(const glm::vec3& box, const SpaceSettings& space);

// By comparisons, so that what NaN does is defined; of colors channel by channel.
inline float minimum(float a, float b) {
  return a < b ? a : b;
}
inline float maximum(float a, float b) {
  return a > b ? a : b;
}
glm::vec3 minimum(const glm::vec3& a, const glm::vec3& b);
glm::vec3 maximum(const glm::vec3& a, const glm::vec3& b);
glm::vec3 clamped(const glm::vec3& value, const glm::vec3& low, const glm::vec3& high);

/// The texel that a position in texels lies in.
glm::ivec2 texelOf(const glm::vec2& position);
/// The pixel of the picture, so of its history, nearest to `pixel`.
glm::ivec2 clampedToPicture(const glm::ivec2& pixel, const Inputs& inputs);
/// The texel of what was drawn nearest to `texel`.
glm::ivec2 clampedToDrawn(const glm::ivec2& texel, const Inputs& inputs);
/// This frame's color at `texel`, clamped to the border, sanitized.
glm::vec3 currentColor(const Inputs& inputs, const glm::ivec2& texel);

} // namespace taa::twin
