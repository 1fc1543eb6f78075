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

// Channel by channel.
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
