// Colors as the resolve sees them: read safely, measured, and moved into the space of the box.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace taa::twin {

/// NaN, negative, infinite or above the largest half float.
template <typename Real = float>
bool isBad(Real value);
/// The color with bad channels those of another, or 0.
template <typename Real = float>
Vec3<Real> saneOr(const Vec3<Real>& other, const Vec3<Real>& color);
template <typename Real = float>
Vec3<Real> sanitized(const Vec3<Real>& color);

/// What a computed color becomes: negative values and NaN 0, too bright ones the brightest half.
template <typename Real = float>
Vec3<Real> storable(const Vec3<Real>& color);

/// Rec. 709 luma of scene-linear color.
template <typename Real = float>
Real luma(const Vec3<Real>& color);
/// Luma that colors are weighed by, in every stage (manual 15.1).
template <typename Real = float>
Real weightLuma(const Vec3<Real>& color, WeightLuma chosen);

/// x^(e/8) by whole powers and square roots; e: whole, 1 to 64.
template <typename Real = float>
Real powerOfEighths(Real x, double eighths) {
  Real power = 1.0f;
  for (; eighths >= 8.0; eighths -= 8.0) power = power * x;
  Real root = x;
  for (double share = 4.0; share >= 1.0; share /= 2.0) {
    root = sqrt(root);
    if (eighths < share) continue;
    eighths -= share;
    power = power * root;
  }
  return power;
}

/// x^(steps/256), likewise; steps ≥ 0.
template <typename Real = float>
Real powerOf256ths(Real x, int steps) {
  Real result = 1.0f;
  for (int left = steps / 256; left > 0; --left) result = result * x;
  Real root = x;
  for (int bit = 7; bit >= 0; --bit) {
    root = sqrt(root);
    if ((steps >> bit & 1) != 0) result = result * root;
  }
  return result;
}

/// The same value, which formulas state as a number, however it was made.
template <typename Real = float>
Real named(Real x) {
  return x;
}
template <typename Real = float>
Vec3<Real> named(const Vec3<Real>& color) {
  return {named(color.x), named(color.y), named(color.z)};
}

/// Within 0 and 1; NaN becomes 0.
template <typename Real = float>
Real saturated(Real x);
/// x²(3 − 2x) of that.
template <typename Real = float>
Real smooth(Real x) {
  const Real t = saturated(x);
  return (t * t) * (3.0f - 2.0f * t);
}

/// Highlights bounded (manual §15), and back.
template <typename Real = float>
Vec3<Real> compress(const Vec3<Real>& color, ToneSpace tone);
template <typename Real = float>
Vec3<Real> decompress(const Vec3<Real>& color, ToneSpace tone);

/// Whether colors are compressed before they are mixed (manual 15.3 to 15.7); that, and back.
bool mixesCompressed(ToneWeight tone);
template <typename Real = float>
Vec3<Real> compress(const Vec3<Real>& color, const BlendSettings& blend);
template <typename Real = float>
Vec3<Real> decompress(const Vec3<Real>& color, const BlendSettings& blend);

/// Scene-linear color in the space the box is built in (manual §9, §15), and back.
template <typename Real = float>
Vec3<Real> toBox(const Vec3<Real>& color, const SpaceSettings& space);
template <typename Real = float>
Vec3<Real> fromBox(const Vec3<Real>& box, const SpaceSettings& space);
/// The same axes with a way back that is not clamped as printed (manual §26, D7).
SpaceSettings withoutClamp(const SpaceSettings& space);
/// Luma of a color of that space.
template <typename Real = float>
Real boxLuma(const Vec3<Real>& box, const SpaceSettings& space);

// By comparisons, so that what NaN does is defined; of colors channel by channel.
template <typename Real = float>
Real minimum(Real a, Same<Real> b) {
  return a < b ? a : b;
}
template <typename Real = float>
Real maximum(Real a, Same<Real> b) {
  return a > b ? a : b;
}
template <typename Real = float>
Real bounded(Real value, Same<Real> low, Same<Real> high) {
  const Real atLeast = value < low ? low : value; // the upper wall has the last word
  return atLeast > high ? high : atLeast;
}
template <typename Real = float>
Vec3<Real> minimum(const Vec3<Real>& a, const Vec3<Real>& b);
template <typename Real = float>
Vec3<Real> maximum(const Vec3<Real>& a, const Vec3<Real>& b);
template <typename Real = float>
Vec3<Real> clamped(const Vec3<Real>& value, const Vec3<Real>& low, const Vec3<Real>& high);

/// The texel that a position in texels lies in.
template <typename Real = float>
glm::ivec2 texelOf(const Vec2<Real>& position);
/// The pixel of the picture, so of its history, nearest to `pixel`.
glm::ivec2 clampedToPicture(const glm::ivec2& pixel, const Inputs& inputs);
/// The texel of what was drawn nearest to `texel`.
glm::ivec2 clampedToDrawn(const glm::ivec2& texel, const Inputs& inputs);
/// This frame's color at `texel`, clamped to the border, sanitized.
template <typename Real = float>
Vec3<Real> currentColor(const Inputs& inputs, const glm::ivec2& texel);

} // namespace taa::twin
