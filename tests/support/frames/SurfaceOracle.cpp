#include "tests/support/frames/SurfaceOracle.h"

#include "core/render/FrameClock.h"
#include "core/scene/Deform.h"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace taa::test {

namespace {

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

glm::dvec3 rowOf(const glm::dvec4& clip) {
  return {clip.x, clip.y, clip.w};
}

} // namespace

SurfaceOracle::SurfaceOracle(const Scene& scene, const FrameInputs& inputs)
    : sizePx_(inputs.width(), inputs.height()), jitterPx_(inputs.block.jitterPx) {
  int object = 0; // primitives of instances of nodes in their order, as they are drawn
  for (int node = 0; node < static_cast<int>(scene.nodes.size()); ++node) {
    const Node& drawn = scene.nodes[static_cast<std::size_t>(node)];
    for (int instance = 0; instance < drawn.timesDrawn(); ++instance)
      for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(drawn.mesh)].primitives) {
        ++object;
        const AlphaMode mode = scene.materials[static_cast<std::size_t>(primitive.material)].alphaMode;
        if (primitive.topology == Topology::Triangles &&
            mode != AlphaMode::Blend) // that has no depth of its own
          add(scene, inputs, {node, instance}, primitive, object);
      }
  }
}

void SurfaceOracle::add(const Scene& scene, const FrameInputs& inputs, const NodeInstance& at,
                        const Primitive& primitive, int object) {
  const int frame = inputs.info.frame;
  const double time = frameTime(scene, frame), timeBefore = frameTime(scene, previousFrame(scene, frame));
  const Pose pose = poseAt(scene, time), poseBefore = poseAt(scene, timeBefore);
  const Deformer now(scene, at, primitive, pose, time),
      before(scene, at, primitive, poseBefore, time, time - timeBefore);
  const std::array<glm::dmat4, 2> clip{glm::dmat4(inputs.block.clipFromWorld),
                                       glm::dmat4(inputs.block.previousClipFromWorld)};
  const std::array<glm::dmat4, 2> view{glm::dmat4(inputs.block.viewFromWorld),
                                       glm::dmat4(inputs.block.previousViewFromWorld)};
  std::vector<std::array<Corner, 2>> corners;
  for (std::size_t vertex = 0; vertex < primitive.vertices.size(); ++vertex) {
    const std::array<glm::dvec4, 2> world{glm::dvec4(glm::dvec3(now.position(vertex)), 1.0),
                                          glm::dvec4(glm::dvec3(before.position(vertex)), 1.0)};
    std::array<Corner, 2> corner;
    for (std::size_t i = 0; i < 2; ++i) corner[i] = {clip[i] * world[i], -(view[i] * world[i]).z};
    corners.push_back(corner);
  }
  const bool isDoubleSided = scene.materials[static_cast<std::size_t>(primitive.material)].doubleSided;
  for (std::size_t first = 0; first + 2 < primitive.indices.size(); first += 3) {
    Triangle triangle;
    triangle.object = object;
    triangle.isDoubleSided = isDoubleSided;
    for (std::size_t i = 0; i < 2; ++i) {
      glm::dvec4& bounds = triangle.bounds[i] = {kEverywhere, kEverywhere, -kEverywhere, -kEverywhere};
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner& corner = triangle.corners[i][k] = corners[primitive.indices[first + k]][i];
        const glm::dvec2 ndc = glm::dvec2(corner.clip) / corner.clip.w;
        bounds = {glm::min(glm::dvec2(bounds), ndc), glm::max(glm::dvec2(bounds.z, bounds.w), ndc)};
      }
      if (std::ranges::any_of(triangle.corners[i], [](const Corner& each) { return each.clip.w <= 0.0; }))
        bounds = {-kEverywhere, -kEverywhere, kEverywhere, kEverywhere}; // it reaches behind the camera
    }
    triangles_.push_back(triangle);
  }
}

SeenPoint SurfaceOracle::sampleOf(const glm::ivec2& pixel) const {
  return at(glm::dvec2(pixel) + 0.5 - jitterPx_, false);
}

SeenPoint SurfaceOracle::at(const glm::dvec2& positionPx, bool isBefore) const {
  const std::size_t here = isBefore ? 1 : 0, other = 1 - here;
  const glm::dvec2 ndc = glm::dvec2(2.0, -2.0) * (positionPx / sizePx_) + glm::dvec2(-1.0, 1.0);
  const auto windowOf = [&](const glm::dvec4& clip) {
    return (glm::dvec2(0.5, -0.5) * (glm::dvec2(clip) / clip.w) + 0.5) * sizePx_;
  };
  SeenPoint nearest;
  for (const Triangle& triangle : triangles_) {
    const glm::dvec4& bounds = triangle.bounds[here];
    if (!(ndc.x >= bounds.x && ndc.y >= bounds.y && ndc.x <= bounds.z && ndc.y <= bounds.w)) continue;
    const std::array<Corner, 3>& corners = triangle.corners[here];
    // Weights λ with Σ λ (x, y, w) = (ndc, 1): none is negative inside and before the camera.
    const glm::dmat3 edges(rowOf(corners[0].clip), rowOf(corners[1].clip), rowOf(corners[2].clip));
    const double area = glm::determinant(edges);
    if (std::abs(area) < 1e-14 || (area < 0.0 && !triangle.isDoubleSided)) continue;
    glm::dvec3 weights = glm::inverse(edges) * glm::dvec3(ndc, 1.0);
    if (!(weights.x >= 0.0 && weights.y >= 0.0 && weights.z >= 0.0)) continue;
    weights /= weights.x + weights.y + weights.z;
    SeenPoint point{triangle.object, 0.0, {}, 0.0};
    glm::dvec4 clip(0.0), clipOther(0.0);
    for (int k = 0; k < 3; ++k) {
      const Corner &corner = corners[static_cast<std::size_t>(k)],
                   &elsewhere = triangle.corners[other][static_cast<std::size_t>(k)];
      point.depth += weights[k] * corner.depth;
      point.depthBefore += weights[k] * elsewhere.depth;
      clip += weights[k] * corner.clip;
      clipOther += weights[k] * elsewhere.clip;
    }
    if (!(point.depth > 0.0) || (nearest.object != 0 && point.depth >= nearest.depth)) continue;
    if (!isBefore) point.motionPx = windowOf(clip) - windowOf(clipOther);
    nearest = point;
  }
  return nearest;
}

} // namespace taa::test
