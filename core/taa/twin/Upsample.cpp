// Stage 4 where the scene is drawn smaller than the picture: the color at a pixel's center from fewer
// samples, and how much they say about it.
#include "core/taa/twin/Upsample.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Powers.h"
#include "core/taa/twin/Stages.h"

#include <cmath>
#include <cstddef>

namespace taa::twin {
namespace {

/// (x² − 1)(x² − 4)³/64 inside |x| ≤ 2.
template <typename Real>
Real lanczosOfSquare(Real squared) {
  const Real x2 = minimum(squared, 4.0f);
  const Real a = x2 - 1.0f, b = x2 - 4.0f;
  return ((a * b) * (b * b)) / 64.0f;
}

// Weights of the sample at d, render px from the pixel's center, with `ratio` render px to a pixel.

template <typename Real>
Real lanczos2Weight(const Vec2<Real>& d, const Vec2<Real>& ratio) {
  const Vec2<Real> x = d / ratio;
  return lanczosOfSquare(x.x * x.x) * lanczosOfSquare(x.y * x.y);
}

template <typename Real>
Real hdrpWeight(const Vec2<Real>& d, const Vec2<Real>& ratio) {
  const Vec2<Real> x = d / ratio;
  const Real root = 0.9656852f * saturated(x.x * x.x + x.y * x.y) - 1.0f;
  return root * root;
}

template <typename Real>
Real fsr2Weight(const Vec2<Real>& d, const Vec2<Real>& ratio) {
  Vec2<Real> x;
  for (int i = 0; i < 2; ++i) {
    const Real scale = 1.0f / ratio[i];
    x[i] = d[i] * (scale < 1.99f ? scale : 1.99f);
  }
  return lanczosOfSquare(x.x * x.x + x.y * x.y);
}

template <typename Real>
Real upsampleWeight(UpsampleKernel chosen, const Vec2<Real>& d, const Vec2<Real>& ratio) {
  switch (chosen) {
  case UpsampleKernel::SampleWeight: // the nearest alone
    break;
  case UpsampleKernel::Lanczos2:
    return lanczos2Weight(d, ratio);
  case UpsampleKernel::Hdrp:
  case UpsampleKernel::HdrpGaussian:
    return hdrpWeight(d, ratio);
  case UpsampleKernel::Fsr2:
    return fsr2Weight(d, ratio);
  }
  return 0.0f;
}

/// κ of the nearest sample alone (manual 22.1).
template <typename Real>
Real nearestConfidence(const Vec2<Real>& d, const Vec2<Real>& ratio, Real speed) {
  const Vec2<Real> squared = (d * d) / ratio;
  const Real near = saturated(1.0f - (squared.x + squared.y));
  return maximum(near, smooth(speed));
}

/// Within a box of ½/r (manual 22.3).
template <typename Real>
Real boxConfidence(const Vec2<Real>& d, const Vec2<Real>& ratio) {
  return fabs(d.x) <= 0.5f / ratio.x && fabs(d.y) <= 0.5f / ratio.y ? 1.0f : 0.0f;
}

/// HDRP's Gaussian of the nearest sample's distance (manual 22.3).
template <typename Real>
Real gaussianConfidence(const Vec2<Real>& d, const Vec2<Real>& ratio) {
  const Vec2<Real> x = d / ratio;
  const Real bell = exp2Of(-3.125f * (x.x * x.x + x.y * x.y)) / (ratio.x * ratio.y); // −½/0.4²
  return minimum(bell, 1.0f);
}

} // namespace

template <typename Real>
Vec2<Real> renderRatio(const Inputs& inputs) {
  return Vec2<Real>(inputs.width(), inputs.height()) /
         Vec2<Real>(inputs.outputWidth(), inputs.outputHeight());
}

template <typename Real>
Vec2<Real> pictureMotion(const Inputs& inputs, const Vec2<Real>& motion) {
  return motion.x == kNoPreviousPosition ? motion : motion / renderRatio<Real>(inputs);
}

template <typename Real>
PlaceOf<Real> placeOf(const Inputs& inputs, const glm::ivec2& pixel) {
  const Vec2<Real> center = (Vec2<Real>(pixel) + 0.5f) * renderRatio<Real>(inputs);
  PlaceOf<Real> place;
  // Texel k holds the scene at k + ½ − j, which is nearest where k is the floor of x + j.
  const Vec2<Real> jitterPx(inputs.jitterPx);
  const glm::ivec2 nearest = texelOf(center + jitterPx);
  place.texel = clampedToDrawn(nearest, inputs);
  place.offset = ((Vec2<Real>(place.texel) + 0.5f) - center) - jitterPx;
  place.offset = {named(place.offset.x), named(place.offset.y)};
  place.still = clampedToDrawn(texelOf(center), inputs);
  return place;
}

template <typename Real>
TapsOf<Real> upsampleTaps(const Inputs& inputs, UpsampleKernel chosen, const PlaceOf<Real>& place) {
  TapsOf<Real> taps;
  if (chosen == UpsampleKernel::SampleWeight) return taps;
  const Vec2<Real> ratio = renderRatio<Real>(inputs);
  const bool isFsr2 = chosen == UpsampleKernel::Fsr2;
  // 4×4 around the center: two samples before it, two behind, on each axis.
  const glm::ivec2 first =
      isFsr2 ? glm::ivec2(place.offset.x > 0.0f ? -2 : -1, place.offset.y > 0.0f ? -2 : -1) : glm::ivec2(-1);
  const int count = isFsr2 ? 4 : 3;
  taps.middle = static_cast<std::size_t>(-first.y * count - first.x);
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < count; ++column) {
      const glm::ivec2 step = first + glm::ivec2(column, row);
      taps.add(currentColor<Real>(inputs, place.texel + step),
               named(upsampleWeight(chosen, place.offset + Vec2<Real>(step), ratio)));
    }
  }
  return taps;
}

template <typename Real>
CurrentColorOf<Real> upsample(const Inputs& inputs, UpsampleKernel chosen, const PlaceOf<Real>& place,
                              Real speed) {
  const Vec3<Real> nearest = currentColor<Real>(inputs, place.texel);
  const Vec2<Real> ratio = renderRatio<Real>(inputs);
  if (chosen == UpsampleKernel::SampleWeight) return {nearest, nearestConfidence(place.offset, ratio, speed)};
  Real sum = 0.0f;
  Vec3<Real> difference(0.0f);
  const TapsOf<Real> taps = upsampleTaps(inputs, chosen, place);
  for (const auto& tap : taps.all()) {
    sum = sum + tap.weight;
    difference = difference + tap.weight * (tap.color - nearest);
  }
  const bool isWeighed = sum > 1e-4f;
  Vec3<Real> color = isWeighed ? nearest + difference / sum : nearest;
  switch (chosen) {
  case UpsampleKernel::Hdrp:
    return {storable(color), boxConfidence(place.offset, ratio)};
  case UpsampleKernel::HdrpGaussian:
    return {storable(color), gaussianConfidence(place.offset, ratio)};
  case UpsampleKernel::SampleWeight: // does not come here
  case UpsampleKernel::Lanczos2:
  case UpsampleKernel::Fsr2:
    break;
  }
  return {storable(boundedBySamples(inputs, place.texel, color)), isWeighed ? saturated(sum) : 0.0f};
}

#define TAA_UPSAMPLE(Real)                                                                                   \
  template Vec2<Real> renderRatio(const Inputs& inputs);                                                     \
  template Vec2<Real> pictureMotion(const Inputs& inputs, const Vec2<Real>& motion);                         \
  template PlaceOf<Real> placeOf(const Inputs& inputs, const glm::ivec2& pixel);                             \
  template TapsOf<Real> upsampleTaps(const Inputs& inputs, UpsampleKernel chosen,                            \
                                     const PlaceOf<Real>& place);                                            \
  template CurrentColorOf<Real> upsample(const Inputs& inputs, UpsampleKernel chosen,                        \
                                         const PlaceOf<Real>& place, Real speed);
TAA_EACH_NUMBER(TAA_UPSAMPLE)
#undef TAA_UPSAMPLE

} // namespace taa::twin
