#include "core/scene/DeformBounds.h"

#include "core/scene/Deform.h"

#include <algorithm>
#include <cmath>

namespace taa {

namespace {

void addBounds(Bounds& sum, const Bounds& other) {
  if (other.isEmpty()) return;
  sum.add(other.min);
  sum.add(other.max);
}

/// Every sum of a point of one box and a point of the other.
Bounds sumOf(const Bounds& a, const Bounds& b) {
  return {a.min + b.min, a.max + b.max};
}

Bounds scaled(const Bounds& box, float factor) {
  const glm::vec3 a = factor * box.min, b = factor * box.max;
  return {glm::min(a, b), glm::max(a, b)};
}

/// The box around a box that a matrix has moved.
Bounds moved(const Bounds& box, const glm::mat4& matrix) {
  Bounds result;
  for (int corner = 0; corner < 8; ++corner)
    result.add(
        glm::vec3(matrix * glm::vec4(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                                     corner & 4 ? box.max.z : box.min.z, 1.0f)));
  return result;
}

// Sums of many floats are made in another order on the GPU, and the weights of a skin add up to 1 within some
// last bits: a hundred thousandth of the largest coordinate is more than either.
Bounds widened(const Bounds& box) {
  const glm::vec3 largest = glm::max(glm::abs(box.min), glm::abs(box.max));
  const glm::vec3 margin(1e-5f * std::max({largest.x, largest.y, largest.z}));
  return {box.min - margin, box.max + margin};
}

void addInfluences(const Primitive& primitive, DeformExtent& extent) {
  const auto sets = static_cast<std::size_t>(primitive.influenceSets);
  for (std::size_t i = 0; i < primitive.influences.size(); ++i)
    for (int place = 0; place < 4; ++place) {
      const float weight = primitive.influences[i].weights[place];
      if (weight == 0.0f) continue;
      if (!(weight > 0.0f)) extent.isConvex = false;
      const auto joint = static_cast<std::size_t>(primitive.influences[i].joints[place]);
      if (joint >= extent.joints.size()) extent.joints.resize(joint + 1);
      extent.joints[joint].add(primitive.vertices[i / sets].position);
    }
}

} // namespace

DeformExtent deformExtent(const Primitive& primitive, const Wind& wind) {
  DeformExtent extent;
  if (primitive.influenceSets > 0) addInfluences(primitive, extent);
  for (const std::vector<MorphDelta>& target : primitive.targets) {
    Bounds& bounds = extent.targets.emplace_back();
    for (const MorphDelta& delta : target) bounds.add(delta.position);
  }
  if (wind.amplitude != 0.0f)
    for (const Vertex& vertex : primitive.vertices)
      extent.windReach = std::max(extent.windReach, std::abs(wind.amplitude * vertex.uv1.y));
  const std::size_t vertices = primitive.vertices.size();
  for (std::size_t frame = 0; frame < static_cast<std::size_t>(primitive.cache.frames); ++frame) {
    Bounds& bounds = extent.cacheFrames.emplace_back();
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
      bounds.add(primitive.cache.entries[frame * vertices + vertex].position);
  }
  return extent;
}

// In the order of shaders/scene/deform.glsl: cache, morph targets, wind, skin.
Bounds deformedBounds(const DeformedPrimitive& deformed, double time) {
  const DeformExtent& extent = deformed.extent;
  const bool isCached = !extent.cacheFrames.empty();
  const Bounds start =
      isCached ? extent.cacheFrames[static_cast<std::size_t>(cacheFrame(deformed.primitive.cache, time))]
               : deformed.primitive.bounds;
  if (start.isEmpty()) return {};
  Bounds way{glm::vec3(0.0f), glm::vec3(0.0f)}; // what morph targets and wind add
  for (std::size_t target = 0; target < deformed.morphWeights.size(); ++target)
    if (!extent.targets[target].isEmpty())
      way = sumOf(way, scaled(extent.targets[target], deformed.morphWeights[target]));
  const glm::vec3 sway = extent.windReach * glm::abs(deformed.wind.direction);
  way = sumOf(way, {-sway, sway});
  if (deformed.jointMatrices.empty()) return widened(sumOf(start, way));
  if (!extent.isConvex) return {};
  Bounds world;
  const std::size_t joints = std::min(extent.joints.size(), deformed.jointMatrices.size());
  for (std::size_t joint = 0; joint < joints; ++joint)
    if (!extent.joints[joint].isEmpty())
      addBounds(world,
                moved(sumOf(isCached ? start : extent.joints[joint], way), deformed.jointMatrices[joint]));
  return widened(world);
}

} // namespace taa
