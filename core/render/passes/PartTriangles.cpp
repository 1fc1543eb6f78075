#include "core/render/passes/PartTriangles.h"

#include "core/scene/Scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <cmath>

namespace taa {

namespace {

/// More than a dozen roundings of 32-bit floats; and where joints and targets are summed up, whose terms may
/// be larger than their sum.
constexpr float kPlacedRounding = 1e-6f, kDeformedRounding = 1e-5f;

/// GL rounds places to 1/16 px or finer.
constexpr float kSnapPx = 1.0f / 32.0f;

/// Beyond every picture.
constexpr float kFarPx = 1e6f;

constexpr std::size_t kFewIndices = 3 * TriangleGroups::kMaxTriangles;

/// What a value may be summed up from, of points that lie no farther than `largest` from the origin.
float termsAt(const glm::vec4& terms, const glm::vec3& largest) {
  return glm::dot(glm::vec3(terms), largest) + terms.w;
}

float alongAxes(const glm::vec2& edge) {
  return std::abs(edge.x) + std::abs(edge.y);
}

/// Those of `count` pixels from `first` on whose centers lie between them.
struct Centers {
  int first = 0, last = -1;
  int count() const { return last - first + 1; }
};

Centers centersBetween(float low, float high, int first, int count) {
  const float left = std::max(low - 0.5f, static_cast<float>(first));
  const float right = std::min(high - 0.5f, static_cast<float>(first + count - 1));
  if (!(right >= left)) return {};
  return {static_cast<int>(std::ceil(left)), static_cast<int>(right)};
}

} // namespace

// None of the lines along its sides parts the point from all of it.
bool PartTriangles::Triangle::mayHold(const glm::vec2& pointPx) const {
  for (std::size_t side = 0; side < corners.size(); ++side) {
    const glm::vec2 &from = corners[side], along = corners[(side + 1) % 3] - from;
    const glm::vec2 across(-along.y, along.x);
    const float width = glm::dot(across, corners[(side + 2) % 3] - from);
    const float point = glm::dot(across, pointPx - from), off = offPx * alongAxes(across);
    if (point < std::min(0.0f, width) - off || point > std::max(0.0f, width) + off) return false;
  }
  return true;
}

// Most are so small that one center lies in the box around them, or none.
bool PartTriangles::Triangle::mayShow(const gl::Rect& part, const glm::vec2& jitterPx) const {
  constexpr int kFewCenters = 4;
  const glm::vec2 low = glm::min(corners[0], glm::min(corners[1], corners[2])) - offPx + jitterPx;
  const glm::vec2 high = glm::max(corners[0], glm::max(corners[1], corners[2])) + offPx + jitterPx;
  const Centers columns = centersBetween(low.x, high.x, part.x, part.width);
  const Centers rows = centersBetween(low.y, high.y, part.y, part.height);
  if (columns.count() * rows.count() > kFewCenters) return true;
  for (int y = rows.first; y <= rows.last; ++y)
    for (int x = columns.first; x <= columns.last; ++x)
      if (mayHold(glm::vec2(x, y) + 0.5f - jitterPx)) return true;
  return false;
}

void PartTriangles::clear() {
  triangles_.clear();
  ends_.clear();
  indices_.clear();
  ranges_.clear();
}

void PartTriangles::findCandidates(const PlacedPrimitive& placed, const std::array<HalfSpace, 4>& beyond) {
  const Primitive& primitive = placed.primitive;
  candidates_.clear();
  if (placed.deformer || primitive.indices.size() <= kFewIndices) {
    candidates_ = primitive.indices;
    return;
  }
  auto groups = groups_.find(placed.key);
  if (groups == groups_.end())
    groups = groups_.emplace(placed.key, TriangleGroups(primitive, placed.wind)).first;
  groups->second.append(primitive, beyond, candidates_);
}

PartTriangles::Tests PartTriangles::testsOf(const PlacedPrimitive& placed, const PartSides& part,
                                            const std::array<HalfSpace, 4>& beyond) const {
  Bounds bounds = placed.primitive.bounds;
  if (placed.deformer) {
    bounds = {};
    for (const glm::vec3& position : deformed_) bounds.add(position);
  }
  const glm::vec3 largest = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
  const float rounding = placed.deformer ? kDeformedRounding : kPlacedRounding;
  Tests tests{beyond, {}, 0.0f};
  for (std::size_t side = 0; side < beyond.size(); ++side)
    tests.limits[side] = rounding * termsAt(beyond[side].terms, largest);
  const glm::vec4 w = glm::abs(glm::row(placed.clipFromVertex, 3));
  for (int axis = 0; axis < 2; ++axis) {
    const glm::vec4 terms = glm::abs(glm::row(placed.clipFromVertex, axis)) + w;
    tests.offAtW1Px =
        std::max(tests.offAtW1Px, 0.5f * part.sizePx[axis] * rounding * termsAt(terms, largest));
  }
  return tests;
}

const PartTriangles::Corner& PartTriangles::corner(const PlacedPrimitive& placed, const PartSides& part,
                                                   const Tests& tests, std::uint32_t vertex) {
  Corner& corner = corners_[vertex];
  if (runs_[vertex] == run_) return corner;
  runs_[vertex] = run_;
  corner = {};
  const glm::vec4 position(placed.deformer ? deformed_[vertex] : placed.primitive.vertices[vertex].position,
                           1.0f);
  for (std::size_t side = 0; side < tests.beyond.size(); ++side)
    if (glm::dot(tests.beyond[side].plane, position) > tests.limits[side]) corner.beyond |= 1u << side;
  if (!placed.movesWithJitter) return corner;
  // What reaches out of the picture is clipped: slivers of it may lie anywhere, and show either side.
  constexpr float kMarginPx = 4.0f;
  const glm::vec4 clip = placed.clipFromVertex * position;
  const glm::vec2 inside = clip.w * (1.0f - 2.0f * kMarginPx / part.sizePx);
  if (!(std::abs(clip.x) < inside.x && std::abs(clip.y) < inside.y && clip.z > 0.0f && clip.z < clip.w))
    return corner;
  corner.isPlaced = true;
  corner.px = 0.5f * part.sizePx * (1.0f + glm::vec2(clip.x, -clip.y) / clip.w); // rows go down, y goes up
  corner.offPx = kSnapPx + tests.offAtW1Px / clip.w;
  return corner;
}

void PartTriangles::addSeen(const PlacedPrimitive& placed, const PartSides& part,
                            const std::array<HalfSpace, 4>& beyond) {
  // Where the wind takes a vertex is the shader's to say: sines are not the same everywhere.
  const bool isKnown = placed.wind.amplitude == 0.0f;
  const std::size_t vertices = placed.primitive.vertices.size();
  runs_.resize(std::max(runs_.size(), vertices), run_);
  corners_.resize(runs_.size());
  ++run_;
  deformed_.clear();
  for (std::size_t vertex = 0; placed.deformer && vertex < vertices; ++vertex)
    deformed_.push_back(placed.deformer->position(vertex));
  const Tests tests = testsOf(placed, part, beyond);
  for (std::size_t at = 0; at + 2 < candidates_.size(); at += 3) {
    Triangle triangle{{candidates_[at], candidates_[at + 1], candidates_[at + 2]}, {}, kFarPx};
    if (!isKnown) {
      triangles_.push_back(triangle);
      continue;
    }
    const Corner& a = corner(placed, part, tests, candidates_[at]);
    const Corner& b = corner(placed, part, tests, candidates_[at + 1]);
    const Corner& c = corner(placed, part, tests, candidates_[at + 2]);
    if ((a.beyond & b.beyond & c.beyond) != 0) continue;
    if (a.isPlaced && b.isPlaced && c.isPlaced) {
      const float off = std::max({a.offPx, b.offPx, c.offPx});
      if (placed.culledClockwise) {
        // Twice the area; where corners are off by e it is by 2e·(|x| + |y|) of two edges and 8e².
        const glm::vec2 ab = b.px - a.px, ac = c.px - a.px;
        const float clockwise = ab.x * ac.y - ab.y * ac.x;
        const float culled = *placed.culledClockwise ? clockwise : -clockwise;
        if (culled > 2.0f * off * (alongAxes(ab) + alongAxes(ac) + 4.0f * off)) continue;
      }
      triangle.corners = {a.px, b.px, c.px};
      triangle.offPx = off;
    }
    triangles_.push_back(triangle);
  }
}

std::optional<std::uint32_t> PartTriangles::add(const PlacedPrimitive& placed, const PartSides& part) {
  const Primitive& primitive = placed.primitive;
  const bool isBlown = placed.wind.amplitude != 0.0f;
  if (primitive.topology != Topology::Triangles || (placed.deformer && isBlown)) return {};
  part_ = part.part;
  const std::array<HalfSpace, 4> beyond = beyondSides(placed.clipFromVertex, part.sides, part.jitter);
  const std::size_t first = triangles_.size();
  findCandidates(placed, beyond);
  addSeen(placed, part, beyond);
  const bool isSmall = primitive.indices.size() <= kFewIndices;
  if (isSmall && triangles_.size() > first) {
    triangles_.resize(first);
    return {};
  }
  ends_.push_back(triangles_.size());
  return static_cast<std::uint32_t>(ends_.size() - 1);
}

void PartTriangles::select(const glm::vec2& jitterPx) {
  indices_.clear();
  ranges_.clear();
  std::size_t at = 0;
  for (const std::size_t end : ends_) {
    const std::size_t first = indices_.size();
    for (; at < end; ++at) {
      const Triangle& triangle = triangles_[at];
      if (triangle.mayShow(part_, jitterPx))
        indices_.insert(indices_.end(), triangle.vertices.begin(), triangle.vertices.end());
    }
    ranges_.push_back({first, indices_.size() - first});
  }
}

} // namespace taa
