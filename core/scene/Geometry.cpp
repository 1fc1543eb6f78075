#include "core/scene/Geometry.h"

#include "core/scene/Deform.h"
#include "core/scene/Pose.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace taa {

namespace {

glm::vec3 normalizedOr(const glm::vec3& v, const glm::vec3& fallback) {
  const float length = glm::length(v);
  return std::isfinite(length) && length > 0.0f ? v / length : fallback;
}

glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return normalizedOr(glm::cross(b - a, c - a), glm::vec3(0, 0, 1));
}

glm::vec3 anyPerpendicular(const glm::vec3& n) {
  const glm::vec3 other = std::abs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return normalizedOr(glm::cross(glm::cross(n, other), n), glm::vec3(1, 0, 0));
}

/// Directions in which u grows and v falls, weighted by the triangle's size.
struct UvAxes {
  glm::vec3 alongU{0.0f}, againstV{0.0f};
};

UvAxes uvAxes(const Vertex& a, const Vertex& b, const Vertex& c, const TextureSlot& map) {
  const auto uv = [&](const Vertex& v) {
    return glm::vec2(map.uvFromUv * glm::vec3(map.uvSet == 0 ? v.uv0 : v.uv1, 1.0f));
  };
  const glm::vec3 e1 = b.position - a.position, e2 = c.position - a.position;
  const glm::vec2 d1 = uv(b) - uv(a), d2 = uv(c) - uv(a);
  const float area = d1.x * d2.y - d2.x * d1.y;
  if (!std::isfinite(area) || area == 0.0f) return {};
  const float weight = glm::length(glm::cross(e1, e2)), sign = area > 0.0f ? 1.0f : -1.0f;
  const glm::vec3 u = sign * (e1 * d2.y - e2 * d1.y), v = sign * (e2 * d1.x - e1 * d2.x);
  return {weight * normalizedOr(u, glm::vec3(0.0f)), -weight * normalizedOr(v, glm::vec3(0.0f))};
}

/// For each index in turn its `perVertex` elements, in each of `frames` lists of `count` vertices.
template <class T>
std::vector<T> taken(const std::vector<T>& from, const std::vector<std::uint32_t>& indices, int frames = 1,
                     std::size_t count = 0, int perVertex = 1) {
  const auto size = static_cast<std::size_t>(perVertex);
  std::vector<T> result;
  result.reserve(static_cast<std::size_t>(frames) * indices.size() * size);
  for (std::size_t frame = 0; frame < static_cast<std::size_t>(frames); ++frame)
    for (const std::uint32_t index : indices)
      for (std::size_t i = 0; i < size; ++i) result.push_back(from[(frame * count + index) * size + i]);
  return result;
}

/// Sums of the normals of the faces around each vertex, by area; `place` tells where a vertex is.
template <class Place>
std::vector<glm::vec3> facesAround(const Primitive& primitive, Place place) {
  std::vector<glm::vec3> sums(primitive.vertices.size(), glm::vec3(0.0f));
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t* corner = &primitive.indices[i];
    const glm::vec3 a = place(corner[0]);
    const glm::vec3 face = glm::cross(place(corner[1]) - a, place(corner[2]) - a);
    for (int k = 0; k < 3; ++k) sums[corner[k]] += face;
  }
  return sums;
}

} // namespace

void makeMorphNormals(Primitive& primitive) {
  if (primitive.topology != Topology::Triangles) return;
  // Differences of such sums, so that the mesh's own normals stay as they are.
  const std::vector<glm::vec3> rest =
      facesAround(primitive, [&](std::size_t i) { return primitive.vertices[i].position; });
  for (std::vector<MorphDelta>& target : primitive.targets) {
    const std::vector<glm::vec3> moved = facesAround(
        primitive, [&](std::size_t i) { return primitive.vertices[i].position + target[i].position; });
    for (std::size_t i = 0; i < target.size(); ++i) {
      const glm::vec3 before = normalizedOr(rest[i], primitive.vertices[i].normal);
      target[i].normal = normalizedOr(moved[i], before) - before;
    }
  }
}

void makeFlatNormals(Primitive& primitive) {
  if (primitive.topology != Topology::Triangles) {
    for (Vertex& vertex : primitive.vertices) vertex.normal = {0.0f, 1.0f, 0.0f};
    return;
  }
  std::vector<Vertex> flat = taken(primitive.vertices, primitive.indices);
  const std::size_t count = primitive.vertices.size();
  if (primitive.influenceSets > 0)
    primitive.influences = taken(primitive.influences, primitive.indices, 1, count, primitive.influenceSets);
  for (std::vector<MorphDelta>& target : primitive.targets) target = taken(target, primitive.indices);
  primitive.cache.entries = taken(primitive.cache.entries, primitive.indices, primitive.cache.frames, count);
  for (std::size_t i = 0; i + 2 < flat.size(); i += 3) {
    const glm::vec3 normal = faceNormal(flat[i].position, flat[i + 1].position, flat[i + 2].position);
    for (std::size_t corner = 0; corner < 3; ++corner) flat[i + corner].normal = normal;
    for (std::vector<MorphDelta>& target : primitive.targets) {
      const auto moved = [&](std::size_t k) { return flat[i + k].position + target[i + k].position; };
      const glm::vec3 change = faceNormal(moved(0), moved(1), moved(2)) - normal;
      for (std::size_t corner = 0; corner < 3; ++corner) target[i + corner].normal = change;
    }
  }
  primitive.vertices = std::move(flat);
  for (std::size_t i = 0; i < primitive.indices.size(); ++i)
    primitive.indices[i] = static_cast<std::uint32_t>(i);
}

void makeTangents(Primitive& primitive, const TextureSlot& normalMap) {
  std::vector<UvAxes> axes(primitive.vertices.size());
  if (primitive.topology == Topology::Triangles)
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
      const std::uint32_t* corner = &primitive.indices[i];
      const UvAxes triangle = uvAxes(primitive.vertices[corner[0]], primitive.vertices[corner[1]],
                                     primitive.vertices[corner[2]], normalMap);
      for (int k = 0; k < 3; ++k) {
        axes[corner[k]].alongU += triangle.alongU;
        axes[corner[k]].againstV += triangle.againstV;
      }
    }
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Vertex& vertex = primitive.vertices[i];
    const glm::vec3& n = vertex.normal;
    const glm::vec3 tangent =
        normalizedOr(axes[i].alongU - n * glm::dot(n, axes[i].alongU), anyPerpendicular(n));
    const bool mirrored = glm::dot(glm::cross(n, tangent), axes[i].againstV) < 0.0f;
    vertex.tangent = glm::vec4(tangent, mirrored ? -1.0f : 1.0f);
  }
}

void updateBounds(Primitive& primitive) {
  primitive.bounds = {};
  for (const Vertex& vertex : primitive.vertices) primitive.bounds.add(vertex.position);
}

namespace {

/// `pose`: of the scene at rest.
void addRestBounds(Bounds& bounds, const Scene& scene, const NodeInstance& at, const Primitive& primitive,
                   const Pose& pose) {
  if (primitive.bounds.isEmpty()) return;
  if (isDeformed(scene, scene.nodes[static_cast<std::size_t>(at.node)], primitive)) {
    const Deformer deformer(scene, at, primitive, pose, 0.0);
    for (std::size_t vertex = 0; vertex < primitive.vertices.size(); ++vertex)
      bounds.add(deformer.position(vertex));
    return;
  }
  const glm::mat4 world = worldFromInstance(scene, pose, at);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 point(corner & 1 ? primitive.bounds.max.x : primitive.bounds.min.x,
                          corner & 2 ? primitive.bounds.max.y : primitive.bounds.min.y,
                          corner & 4 ? primitive.bounds.max.z : primitive.bounds.min.z);
    bounds.add(glm::vec3(world * glm::vec4(point, 1.0f)));
  }
}

} // namespace

Bounds restBounds(const Scene& scene) {
  Scene atRest;
  atRest.nodes = scene.nodes;
  Pose pose = poseAt(atRest, 0.0);
  pose.morphWeights = scene.morphWeights;
  Bounds bounds;
  for (int index = 0; index < static_cast<int>(scene.nodes.size()); ++index) {
    const Node& node = scene.nodes[static_cast<std::size_t>(index)];
    for (int instance = 0; instance < node.timesDrawn(); ++instance)
      for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives)
        addRestBounds(bounds, scene, {index, instance}, primitive, pose);
  }
  return bounds;
}

} // namespace taa
