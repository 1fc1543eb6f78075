// The triangles of a primitive in groups of near ones: where a part of the picture is wanted, those that lie
// outside it need not be drawn.
#pragma once

#include "core/scene/Material.h"
#include "core/scene/Mesh.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace taa {

/// Points with dot(plane, (point, 1)) > 0, model space.
struct HalfSpace {
  glm::vec4 plane{0.0f};
  glm::vec4 terms{0.0f}; ///< what the plane was summed up from, as absolutes: how far it may be off
};

class TriangleGroups {
 public:
  static constexpr std::size_t kMaxTriangles = 32; ///< of a group

  /// Expects triangles that nothing but `wind` deforms.
  TriangleGroups(const Primitive& primitive, const Wind& wind);

  /// Appends the indices of the primitive, in their order, without those of groups that lie wholly in one of
  /// the half spaces whenever the wind blows.
  void append(const Primitive& primitive, std::span<const HalfSpace> outside,
              std::vector<std::uint32_t>& indices) const;

 private:
  struct Group {
    glm::vec3 center{0.0f}, extent{0.0f}; ///< of a box, from its middle to its sides
    std::size_t first = 0, count = 0;     ///< among triangles_
  };
  std::vector<std::uint32_t> triangles_; ///< numbers, group after group
  std::vector<Group> groups_;
};

} // namespace taa
