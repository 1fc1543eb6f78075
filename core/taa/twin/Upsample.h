// Pixels of a picture made from a smaller drawing: where their samples lie, and what these give (manual
// §22).
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/SampleStages.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace taa::twin {

/// Size of what was drawn against that of the picture (manual §22: r).
template <typename Real = float>
Vec2<Real> renderRatio(const Inputs& inputs);
/// A motion of the inputs, render px, in px of the picture; the mark of no previous position stays.
template <typename Real = float>
Vec2<Real> pictureMotion(const Inputs& inputs, const Vec2<Real>& motion);
/// Which sample lies nearest to a pixel of the picture, and where from the pixel's center, render px.
template <typename Real>
struct PlaceOf {
  glm::ivec2 texel{0};
  Vec2<Real> offset{0.0f};
  glm::ivec2 still{0}; ///< the texel that holds the center without jitter
};
using Place = PlaceOf<float>;
template <typename Real = float>
PlaceOf<Real> placeOf(const Inputs& inputs, const glm::ivec2& pixel);

/// The samples that a kernel weighs for that pixel, the nearest in the middle; none where it takes that
/// alone.
template <typename Real = float>
TapsOf<Real> upsampleTaps(const Inputs& inputs, UpsampleKernel chosen, const PlaceOf<Real>& place);
/// The color at the center of a pixel from fewer samples (manual §22); speed in px of the picture.
template <typename Real>
struct CurrentColorOf {
  Vec3<Real> color{0.0f};
  Real confidence = 1.0f; ///< κ
};
using CurrentColor = CurrentColorOf<float>;
template <typename Real = float>
CurrentColorOf<Real> upsample(const Inputs& inputs, UpsampleKernel chosen, const PlaceOf<Real>& place,
                              Real speed);

} // namespace taa::twin
