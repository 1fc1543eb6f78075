// Which triangles may be seen in a part of a picture. Samples of references are drawn of small parts, many
// times, where triangles are often smaller than pixels: most of them lie between the centers of pixels.
#pragma once

#include "core/gl/Rect.h"
#include "core/render/passes/ClipSides.h"
#include "core/scene/Deform.h"
#include "core/scene/Mesh.h"
#include "core/scene/TriangleGroups.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace taa {

struct Wind;

/// A primitive as it is drawn at a node.
struct PlacedPrimitive {
  std::pair<int, int> key; ///< numbers of mesh and primitive
  const Primitive& primitive;
  const Wind& wind;
  std::optional<Deformer> deformer{};    ///< of what more than the wind deforms
  glm::mat4 clipFromVertex{1.0f};        ///< from the world where there is a deformer, else from the model
  std::optional<bool> culledClockwise{}; ///< whether triangles that run so are not drawn; nothing: all are
  bool movesWithJitter = true;           ///< all of it alike, by FrameBlock::jitterPx
};

/// What is seen, of what is drawn.
struct PartSides {
  ClipSides sides;
  glm::vec4 jitter{0.0f}; ///< FrameBlock::printedJitter where it moves what is drawn
  gl::Rect part;          ///< px
  glm::vec2 sizePx{0.0f}; ///< of all, not of the part
};

class PartTriangles {
 public:
  /// Indices among indices().
  struct Range {
    std::size_t first = 0, count = 0;
  };

  /// For another view.
  void clear();
  /// Adds what may be seen of a primitive at any jitter within the margin of `sides`. Returns its number
  /// among those that were added, or nothing: all of it is drawn. Few triangles are all drawn or none.
  std::optional<std::uint32_t> add(const PlacedPrimitive& placed, const PartSides& part);
  /// Whether none of it may be seen.
  bool isEmpty(std::size_t number) const { return ends_[number] == (number == 0 ? 0 : ends_[number - 1]); }
  /// Takes what may be seen at one jitter.
  void select(const glm::vec2& jitterPx);

  /// Selected: of each primitive those of triangles that may be seen, in their order.
  const std::vector<std::uint32_t>& indices() const { return indices_; }
  const Range& range(std::size_t number) const { return ranges_[number]; }

 private:
  /// A vertex on its way to the picture.
  struct Corner {
    unsigned beyond = 0; ///< a bit for each side that it lies beyond
    bool isPlaced = false;
    glm::vec2 px{0.0f}; ///< without jitter
    float offPx = 0.0f; ///< how far from there it may be drawn, along x and y
  };
  struct Triangle {
    std::array<std::uint32_t, 3> vertices;
    std::array<glm::vec2, 3> corners{}; ///< px, without jitter
    float offPx;                        ///< how far from there they may be drawn, along x and y
    bool mayShow(const gl::Rect& part, const glm::vec2& jitterPx) const;
    bool mayHold(const glm::vec2& pointPx) const; ///< without jitter
  };
  /// What is the same for all vertices of a primitive.
  struct Tests {
    std::array<HalfSpace, 4> beyond;
    std::array<float, 4> limits{}; ///< of the values there
    float offAtW1Px = 0.0f;        ///< what a corner at w = 1 is off by
  };
  void findCandidates(const PlacedPrimitive& placed, const std::array<HalfSpace, 4>& beyond);
  Tests testsOf(const PlacedPrimitive& placed, const PartSides& part,
                const std::array<HalfSpace, 4>& beyond) const;
  const Corner& corner(const PlacedPrimitive& placed, const PartSides& part, const Tests& tests,
                       std::uint32_t vertex);
  /// Those of the candidates that may be seen.
  void addSeen(const PlacedPrimitive& placed, const PartSides& part, const std::array<HalfSpace, 4>& beyond);

  std::map<std::pair<int, int>, TriangleGroups> groups_; ///< by key
  gl::Rect part_;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> ends_; ///< among them, of each primitive that was added
  std::vector<std::uint32_t> indices_;
  std::vector<Range> ranges_;
  // Of the primitive that is added; corners count where their run is the present one.
  std::vector<std::uint32_t> candidates_;
  std::vector<glm::vec3> deformed_;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> runs_;
  std::uint32_t run_ = 0;
};

} // namespace taa
