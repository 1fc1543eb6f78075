// Builds the shapes of the built-in scenes into one primitive: boxes, tubes, balls, sheets.
#pragma once

#include "core/scene/Scene.h"

#include <cstdint>
#include <numbers>
#include <span>

namespace taa {

/// Radians.
inline constexpr float kTurn = 2.0f * std::numbers::pi_v<float>;

/// Collects triangles, counter-clockwise seen from outside; lengths in meters.
class MeshBuilder {
 public:
  /// A parallelogram from `corner` along `right` and `up`; uv (0,1) at the corner, `uvSize` across.
  void quad(const glm::vec3& corner, const glm::vec3& right, const glm::vec3& up,
            const glm::vec2& uvSize = {1, 1});
  /// One flat triangle; uv in meters along the horizontal and down, times `uvPerMeter`.
  void face(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, float uvPerMeter = 1.0f);
  /// An axis-aligned box; uv in meters times `uvPerMeter`.
  void box(const glm::vec3& min, const glm::vec3& max, float uvPerMeter = 1.0f);
  void ball(const glm::vec3& center, float radius, int segments);
  /// A round wire through `points`, at least two; open ends have no caps.
  void tube(std::span<const glm::vec3> points, float radius, int sides, bool closed = false);
  /// A ring around z.
  void ring(const glm::vec3& center, float ringRadius, float radius, int segments, int sides);
  /// A solid of revolution around z: `profile` gives (radius, z) from front to back.
  void lathe(const glm::vec3& center, std::span<const glm::vec2> profile, int segments);
  /// A grid of points, rows along v, seen from where columns go right and rows go down; normals from the
  /// grid.
  void sheet(std::span<const glm::vec3> points, int columns);

  /// The primitive with tangents and bounds; the builder is empty afterwards.
  Primitive build(int material);

 private:
  std::uint32_t vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// `hasPoles`: the first row and the last are single points, where half of the triangles have no area.
  void gridTriangles(std::uint32_t first, int columns, int rows, bool hasPoles = false);

  Primitive primitive_;
};

} // namespace taa
