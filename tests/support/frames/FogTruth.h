// What a ray meets in a cone of fog, from the cone's own geometry: sampled finely in doubles, point by point.
#pragma once

#include "core/scene/Scene.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace taa::test {

struct FogTruth {
  double length = 0.0;   ///< m of the ray inside the cone, before the surface
  double opacity = 0.0;  ///< 1 − exp(−σ · length)
  glm::dvec3 light{0.0}; ///< ∫ σ c(t) exp(−σ · length up to t) dt
};

/// A cone of a scene, in the world.
struct PlacedCone {
  FogCone cone;
  glm::dvec3 apex, axis; ///< axis: normalized
};

/// Along `origin` + t·`direction` (normalized) from 0 to `end`, `parts` midpoints.
FogTruth fogTruth(const PlacedCone& placed, const glm::dvec3& origin, const glm::dvec3& direction, double end,
                  int parts = 4000);

/// Of a camera at `eye` that looks along −z, 60° high: the ray through the middle of a pixel of `size`.
glm::dvec3 rayThrough(const glm::ivec2& pixel, const glm::ivec2& size);

} // namespace taa::test
