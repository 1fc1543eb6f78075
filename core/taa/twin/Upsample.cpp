// Stage 4 where the scene is drawn smaller than the picture: the color at a pixel's center from fewer
// samples, and how much they say about it.
#include "core/taa/twin/Upsample.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Powers.h"
#include "core/taa/twin/Stages.h"

#include <cmath>
#include <cstddef>

namespace taa::twin {
namespace {

/// (x² − 1)(x² − 4)³/64 inside |x| ≤ 2.
float lanczosOfSquare(float squared) {
  const float x2 = squared < 4.0f ? squared : 4.0f;
  const float a = x2 - 1.0f, b = x2 - 4.0f;
  return ((a * b) * (b * b)) / 64.0f;
}

// Weights of the sample at d, render px from the pixel's center, with `ratio` render px to a pixel.

float lanczos2Weight(const glm::vec2& d, const glm::vec2& ratio) {
  const glm::vec2 x = d / ratio;
  return lanczosOfSquare(x.x * x.x) * lanczosOfSquare(x.y * x.y);
}

float hdrpWeight(const glm::vec2& d, const glm::vec2& ratio) {
  const glm::vec2 x = d / ratio;
  const float root = 0.9656852f * saturated(x.x * x.x + x.y * x.y) - 1.0f;
  return root * root;
}

float fsr2Weight(const glm::vec2& d, const glm::vec2& ratio) {
  glm::vec2 x;
  for (int i = 0; i < 2; ++i) {
    const float scale = 1.0f / ratio[i];
    x[i] = d[i] * (scale < 1.99f ? scale : 1.99f);
  }
  return lanczosOfSquare(x.x * x.x + x.y * x.y);
}

float upsampleWeight(UpsampleKernel chosen, const glm::vec2& d, const glm::vec2& ratio) {
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
float nearestConfidence(const glm::vec2& d, const glm::vec2& ratio, float speed) {
  const glm::vec2 squared = (d * d) / ratio;
  const float near = saturated(1.0f - (squared.x + squared.y));
  const float x = saturated(speed);
  const float moving = (x * x) * (3.0f - 2.0f * x); // smoothstep(0, 1, ‖v‖)
  return near > moving ? near : moving;
}

/// Within a box of ½/r (manual 22.3).
float boxConfidence(const glm::vec2& d, const glm::vec2& ratio) {
  return std::fabs(d.x) <= 0.5f / ratio.x && std::fabs(d.y) <= 0.5f / ratio.y ? 1.0f : 0.0f;
}

/// HDRP's Gaussian of the nearest sample's distance (manual 22.3).
float gaussianConfidence(const glm::vec2& d, const glm::vec2& ratio) {
  const glm::vec2 x = d / ratio;
  const float bell = exp2Of(-3.125f * (x.x * x.x + x.y * x.y)) / (ratio.x * ratio.y); // −½/0.4²
  return bell < 1.0f ? bell : 1.0f;
}

} // namespace

glm::vec2 renderRatio(const Inputs& inputs) {
  return glm::vec2(inputs.width(), inputs.height()) / glm::vec2(inputs.outputWidth(), inputs.outputHeight());
}

glm::vec2 pictureMotion(const Inputs& inputs, const glm::vec2& motion) {
  return motion.x == kNoPreviousPosition ? motion : motion / renderRatio(inputs);
}

Place placeOf(const Inputs& inputs, const glm::ivec2& pixel) {
  const glm::vec2 center = (glm::vec2(pixel) + 0.5f) * renderRatio(inputs);
  Place place;
  // Texel k holds the scene at k + ½ − j, which is nearest where k is the floor of x + j.
  const glm::ivec2 nearest(static_cast<int>(std::floor(center.x + inputs.jitterPx.x)),
                           static_cast<int>(std::floor(center.y + inputs.jitterPx.y)));
  place.texel = clampedToDrawn(nearest, inputs);
  place.offset = ((glm::vec2(place.texel) + 0.5f) - center) - inputs.jitterPx;
  place.still = clampedToDrawn(
      {static_cast<int>(std::floor(center.x)), static_cast<int>(std::floor(center.y))}, inputs);
  return place;
}

Taps upsampleTaps(const Inputs& inputs, UpsampleKernel chosen, const Place& place) {
  Taps taps;
  if (chosen == UpsampleKernel::SampleWeight) return taps;
  const glm::vec2 ratio = renderRatio(inputs);
  const bool isFsr2 = chosen == UpsampleKernel::Fsr2;
  // 4×4 around the center: two samples before it, two behind, on each axis.
  const glm::ivec2 first =
      isFsr2 ? glm::ivec2(place.offset.x > 0.0f ? -2 : -1, place.offset.y > 0.0f ? -2 : -1) : glm::ivec2(-1);
  const int count = isFsr2 ? 4 : 3;
  taps.middle = static_cast<std::size_t>(-first.y * count - first.x);
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < count; ++column) {
      const glm::ivec2 step = first + glm::ivec2(column, row);
      taps.add(currentColor(inputs, place.texel + step),
               upsampleWeight(chosen, place.offset + glm::vec2(step), ratio));
    }
  }
  return taps;
}

CurrentColor upsample(const Inputs& inputs, UpsampleKernel chosen, const Place& place, float speed) {
  const glm::vec3 nearest = currentColor(inputs, place.texel);
  const glm::vec2 ratio = renderRatio(inputs);
  if (chosen == UpsampleKernel::SampleWeight) return {nearest, nearestConfidence(place.offset, ratio, speed)};
  float sum = 0.0f;
  glm::vec3 difference(0.0f);
  const Taps taps = upsampleTaps(inputs, chosen, place);
  for (const Taps::Tap& tap : taps.all()) {
    sum = sum + tap.weight;
    difference = difference + tap.weight * (tap.color - nearest);
  }
  const bool isWeighed = sum > 1e-4f;
  glm::vec3 color = isWeighed ? nearest + difference / sum : nearest;
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

} // namespace taa::twin
