// Boxes around deformed vertices, from what is known before a vertex is moved: never too small.
#pragma once

#include "core/scene/Pose.h"

#include <span>
#include <vector>

namespace taa {

/// How far the vertices of a primitive reach in each of the things that deform it; model space, made once.
struct DeformExtent {
  std::vector<Bounds>
      joints;           ///< of the vertices that each joint of a skin moves; empty ones it moves none of
  bool isConvex = true; ///< no weight is negative: a vertex stays between what its joints make of it
  std::vector<Bounds> targets;     ///< of what each morph target adds at weight 1
  float windReach = 0.0f;          ///< the largest amplitude of a vertex, in lengths of the wind's direction
  std::vector<Bounds> cacheFrames; ///< of each entry of the cache
};

DeformExtent deformExtent(const Primitive& primitive, const Wind& wind);

/// Which deformations count for a primitive at a node.
struct DeformedPrimitive {
  const Primitive& primitive;
  const DeformExtent& extent;
  const Wind& wind;
  std::span<const float> morphWeights;      ///< of this frame; empty: not morphed
  std::span<const glm::mat4> jointMatrices; ///< world from model, of this frame; empty: not skinned
};

/// A box that holds every vertex at `time` seconds: in world space for a skin, else in model space. Empty
/// when nothing can be said.
Bounds deformedBounds(const DeformedPrimitive& deformed, double time);

} // namespace taa
