#include "core/probe/Probe.h"

#include "core/scene/Deform.h"
#include "core/taa/twin/SampleStages.h"

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace taa {

namespace {

/// What an object's number stands for, counted as GBufferPass does: by node, instance and primitive.
struct DrawnObject {
  NodeInstance at{-1};
  const Primitive* primitive = nullptr;
};

DrawnObject drawnObject(const Scene& scene, int object) {
  int before = 0; // objects of the nodes before
  for (int index = 0; index < static_cast<int>(scene.nodes.size()) && object > 0; ++index) {
    const Node& node = scene.nodes[static_cast<std::size_t>(index)];
    if (node.mesh < 0) continue;
    const std::vector<Primitive>& primitives = scene.meshes[static_cast<std::size_t>(node.mesh)].primitives;
    const int parts = static_cast<int>(primitives.size()), place = object - 1 - before;
    if (place < parts * node.timesDrawn())
      return {{index, place / parts}, &primitives[static_cast<std::size_t>(place % parts)]};
    before += parts * node.timesDrawn();
  }
  return {};
}

glm::dvec2 ndcOf(const glm::dvec2& positionPx, const glm::ivec2& picturePx) {
  const glm::dvec2 part = positionPx / glm::dvec2(picturePx);
  return {2.0 * part.x - 1.0, 1.0 - 2.0 * part.y};
}

glm::dvec2 positionOf(const glm::dvec4& clip, const glm::ivec2& picturePx) {
  const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
  return glm::dvec2(0.5 * (ndc.x + 1.0), 0.5 * (1.0 - ndc.y)) * glm::dvec2(picturePx);
}

/// A line of sight in view space: depth grows along it by one for each unit of t.
struct Ray {
  glm::dvec3 origin{0.0}, direction{0.0};
};

/// `clipFromWorld`: that of the picture `positionPx` is a place in, unjittered or as it was drawn.
Ray rayThrough(const glm::dvec2& positionPx, const View& view, const glm::mat4& clipFromWorld,
               const glm::ivec2& picturePx) {
  const glm::dmat4 viewFromWorld(view.block.viewFromWorld);
  const glm::dmat4 viewFromClip = viewFromWorld * glm::inverse(glm::dmat4(clipFromWorld));
  const glm::dvec2 ndc = ndcOf(positionPx, picturePx);
  const auto at = [&](double depth) { // any two device depths, reversed: 1 is the near plane
    const glm::dvec4 point = viewFromClip * glm::dvec4(ndc, depth, 1.0);
    return glm::dvec3(point) / point.w;
  };
  const glm::dvec3 near = at(1.0), way = at(0.5) - near;
  const glm::dvec3 direction = way / -way.z;
  return {near + near.z * direction, direction}; // where depth is 0
}

/// Weights of the corners of the triangle that the ray meets, and the depth there; nothing beside it.
struct Hit {
  glm::dvec3 weights{0.0};
  double depth = 0.0;
};

std::optional<Hit> meet(const Ray& ray, const std::array<glm::dvec3, 3>& corners) {
  // Möller and Trumbore, 1997.
  const glm::dvec3 edge1 = corners[1] - corners[0], edge2 = corners[2] - corners[0];
  const glm::dvec3 across = glm::cross(ray.direction, edge2);
  const double determinant = glm::dot(edge1, across);
  if (determinant == 0.0) return {};
  const glm::dvec3 from = ray.origin - corners[0];
  const double u = glm::dot(from, across) / determinant;
  const glm::dvec3 turned = glm::cross(from, edge1);
  const double v = glm::dot(ray.direction, turned) / determinant;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return {};
  return Hit{{1.0 - u - v, u, v}, glm::dot(edge2, turned) / determinant};
}

std::vector<glm::dvec3> viewPositions(const Scene& scene, const View& view, const DrawnObject& object) {
  const Deformer deformer(scene, object.at, *object.primitive, view.pose, view.pose.time);
  const glm::dmat4 viewFromWorld(view.block.viewFromWorld);
  std::vector<glm::dvec3> positions;
  positions.reserve(object.primitive->vertices.size());
  for (std::size_t vertex = 0; vertex < object.primitive->vertices.size(); ++vertex)
    positions.emplace_back(viewFromWorld * glm::dvec4(glm::dvec3(deformer.position(vertex)), 1.0));
  return positions;
}

/// Of the triangles on the line of sight the one whose depth is that of what was drawn.
std::optional<SurfaceAnchor> anchorOn(const Ray& ray, const Primitive& primitive,
                                      const std::vector<glm::dvec3>& positions, double depth) {
  std::optional<SurfaceAnchor> best;
  double least = std::numeric_limits<double>::max();
  for (std::size_t first = 0; first + 2 < primitive.indices.size(); first += 3) {
    const std::array<std::uint32_t, 3> corners{primitive.indices[first], primitive.indices[first + 1],
                                               primitive.indices[first + 2]};
    const auto hit = meet(ray, {positions[corners[0]], positions[corners[1]], positions[corners[2]]});
    if (!hit || std::abs(hit->depth - depth) >= least) continue;
    least = std::abs(hit->depth - depth);
    best = SurfaceAnchor{0, corners, glm::vec3(hit->weights)};
  }
  return best;
}

/// The vertex nearest to the ray at that depth: for lines and points.
SurfaceAnchor nearestVertex(const Ray& ray, const std::vector<glm::dvec3>& positions, double depth) {
  const glm::dvec3 seen = ray.origin + depth * ray.direction;
  std::uint32_t nearest = 0;
  for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex)
    if (glm::distance(positions[vertex], seen) < glm::distance(positions[nearest], seen)) nearest = vertex;
  return {0, {nearest, nearest, nearest}, glm::vec3(1.0f, 0.0f, 0.0f)};
}

glm::ivec2 pixelNear(const glm::dvec2& position, const glm::ivec2& picturePx) {
  return glm::ivec2(glm::clamp(glm::floor(position), glm::dvec2(0.0), glm::dvec2(picturePx - 1)));
}

} // namespace

SurfaceAnchor anchorAt(const Scene& scene, const View& view, const glm::ivec2& picturePx,
                       const glm::ivec2& pixel, const SeenSurface& seen) {
  const glm::dvec2 middle = glm::dvec2(pixel) + 0.5;
  const DrawnObject object = drawnObject(scene, seen.object);
  if (!object.primitive) {
    const Ray ray = rayThrough(middle, view, view.block.clipFromWorld, picturePx);
    const glm::dmat3 worldFromView = glm::inverse(glm::dmat3(glm::dmat4(view.block.viewFromWorld)));
    return {0, {}, glm::vec3(glm::normalize(worldFromView * ray.direction))};
  }
  const double depth = twin::viewDepth(seen.depth, view.block.depthTerms);
  const std::vector<glm::dvec3> positions = viewPositions(scene, view, object);
  // The sample was taken beside the middle, by the jitter: at an edge only that finds the surface.
  const glm::dvec2 scale = glm::dvec2(picturePx) / glm::dvec2(view.block.sizePx);
  const Ray sample = rayThrough((glm::floor(middle / scale) + 0.5) * scale, view,
                                view.block.jitteredClipFromWorld, picturePx);
  std::optional<SurfaceAnchor> anchor;
  for (const Ray& ray : {rayThrough(middle, view, view.block.clipFromWorld, picturePx), sample})
    if (!anchor && object.primitive->topology == Topology::Triangles)
      anchor = anchorOn(ray, *object.primitive, positions, depth);
  if (!anchor) anchor = nearestVertex(sample, positions, depth);
  anchor->object = seen.object;
  return *anchor;
}

ProbeSpot spotOf(const Scene& scene, const View& view, const glm::ivec2& picturePx, const Probe& probe) {
  if (probe.follow == Follow::Screen) {
    const glm::ivec2 pixel = glm::clamp(probe.pixel, glm::ivec2(0), picturePx - 1);
    return {pixel, glm::vec2(probe.pixel) + 0.5f, 0.0f,
            pixel == probe.pixel ? ProbeState::Seen : ProbeState::OffScreen};
  }
  assert(probe.anchor);
  const SurfaceAnchor& anchor = *probe.anchor;
  const DrawnObject object = drawnObject(scene, anchor.object);
  if (anchor.object > 0 && !object.primitive) return {.state = ProbeState::Gone};
  glm::dvec4 world(glm::dvec3(anchor.weights), 0.0);
  if (object.primitive) {
    if (std::ranges::max(anchor.vertices) >= object.primitive->vertices.size())
      return {.state = ProbeState::Gone};
    if (!view.nodes[static_cast<std::size_t>(object.at.node)].isVisible) return {.state = ProbeState::Gone};
    const Deformer deformer(scene, object.at, *object.primitive, view.pose, view.pose.time);
    glm::dvec3 point(0.0);
    for (int corner = 0; corner < 3; ++corner)
      if (anchor.weights[corner] != 0.0f)
        point += static_cast<double>(anchor.weights[corner]) *
                 glm::dvec3(deformer.position(anchor.vertices[static_cast<std::size_t>(corner)]));
    world = glm::dvec4(point, 1.0);
  }
  const glm::dvec4 clip = glm::dmat4(view.block.clipFromWorld) * world;
  const double depth = -(glm::dmat4(view.block.viewFromWorld) * world).z;
  if (!(depth > 0.0) || !(clip.w > 0.0)) return {.state = ProbeState::OffScreen};
  const glm::dvec2 position = positionOf(clip, picturePx);
  const bool isInside =
      position.x >= 0.0 && position.y >= 0.0 && position.x < picturePx.x && position.y < picturePx.y;
  return {pixelNear(position, picturePx), glm::vec2(position),
          object.primitive ? static_cast<float>(depth) : 0.0f,
          isInside ? ProbeState::Seen : ProbeState::OffScreen};
}

bool isHidden(const ProbeSpot& spot, const SurfaceAnchor& anchor, const SeenSurface& drawn,
              float drawnViewDepth) {
  constexpr float kSameSurface = 0.01f; // relative; a pixel's slope and the rounding of depth
  if (spot.state != ProbeState::Seen || drawn.object == 0) return false; // nothing is behind the sky
  if (anchor.object == 0) return true;
  // Its own object may bend over it, too, but at its silhouette depth changes within a pixel.
  const float margin = drawn.object == anchor.object ? 5.0f * kSameSurface : kSameSurface;
  return drawnViewDepth < spot.viewDepth * (1.0f - margin);
}

} // namespace taa
