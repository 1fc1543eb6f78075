#include "core/scene/TriangleGroups.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace taa {

namespace {

/// More than a dozen roundings of 32-bit floats, as the shader and the test below make them.
constexpr float kPlaneRounding = 1e-6f;

/// The vertices of a triangle.
std::span<const std::uint32_t> cornersOf(const Primitive& primitive, std::uint32_t triangle) {
  return std::span(primitive.indices).subspan(3 * static_cast<std::size_t>(triangle), 3);
}

glm::vec3 middleOf(const Primitive& primitive, std::uint32_t triangle) {
  glm::vec3 sum(0.0f);
  for (const std::uint32_t vertex : cornersOf(primitive, triangle))
    sum += primitive.vertices[vertex].position;
  return sum / 3.0f;
}

/// The axis along which points are spread most.
int longestAxis(const Bounds& bounds) {
  const glm::vec3 size = bounds.max - bounds.min;
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

/// Around triangles wherever the wind takes them.
Bounds swayingBounds(const Primitive& primitive, const Wind& wind, std::span<const std::uint32_t> triangles) {
  Bounds bounds;
  for (const std::uint32_t triangle : triangles)
    for (const std::uint32_t index : cornersOf(primitive, triangle)) {
      const Vertex& vertex = primitive.vertices[index];
      const glm::vec3 sway = std::abs(wind.amplitude * vertex.uv1.y) * glm::abs(wind.direction);
      bounds.add(vertex.position - sway);
      bounds.add(vertex.position + sway);
    }
  return bounds;
}

bool liesWhollyIn(const HalfSpace& space, const glm::vec3& center, const glm::vec3& extent) {
  const glm::vec3 normal(space.plane);
  const float lowest = glm::dot(normal, center) + space.plane.w - glm::dot(glm::abs(normal), extent);
  const float terms = glm::dot(glm::vec3(space.terms), glm::abs(center) + extent) + space.terms.w;
  return lowest > kPlaneRounding * terms;
}

} // namespace

TriangleGroups::TriangleGroups(const Primitive& primitive, const Wind& wind)
    : triangles_(primitive.indices.size() / 3) {
  assert(primitive.topology == Topology::Triangles);
  std::iota(triangles_.begin(), triangles_.end(), 0u);
  std::vector<glm::vec3> centroids;
  for (const std::uint32_t triangle : triangles_) centroids.push_back(middleOf(primitive, triangle));
  std::vector<std::pair<std::size_t, std::size_t>> waiting{{0, triangles_.size()}}; // first and count
  while (!waiting.empty()) {
    const auto [first, count] = waiting.back();
    waiting.pop_back();
    const std::span<std::uint32_t> own = std::span(triangles_).subspan(first, count);
    if (count <= kMaxTriangles) {
      if (count == 0) continue;
      const Bounds bounds = swayingBounds(primitive, wind, own);
      groups_.push_back({bounds.center(), 0.5f * (bounds.max - bounds.min), first, count});
      continue;
    }
    Bounds spread;
    for (const std::uint32_t triangle : own) spread.add(centroids[triangle]);
    const int axis = longestAxis(spread);
    const std::size_t half = count / 2;
    std::ranges::nth_element(own, own.begin() + static_cast<std::ptrdiff_t>(half), {},
                             [&](std::uint32_t triangle) { return centroids[triangle][axis]; });
    waiting.emplace_back(first, half);
    waiting.emplace_back(first + half, count - half);
  }
}

void TriangleGroups::append(const Primitive& primitive, std::span<const HalfSpace> outside,
                            std::vector<std::uint32_t>& indices) const {
  assert(triangles_.size() == primitive.indices.size() / 3);
  std::vector<bool> isKept(triangles_.size(), false);
  for (const Group& group : groups_) {
    const bool isLeftOut = std::ranges::any_of(
        outside, [&](const HalfSpace& space) { return liesWhollyIn(space, group.center, group.extent); });
    if (isLeftOut) continue;
    for (std::size_t at = 0; at < group.count; ++at) isKept[triangles_[group.first + at]] = true;
  }
  for (std::uint32_t triangle = 0; triangle < isKept.size(); ++triangle)
    if (isKept[triangle])
      for (const std::uint32_t index : cornersOf(primitive, triangle)) indices.push_back(index);
}

} // namespace taa
