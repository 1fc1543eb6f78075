#include "core/scene/builtin/MeshBuilder.h"

#include "core/scene/Geometry.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace taa {

namespace {

float fraction(int i, int count) {
  return static_cast<float>(i) / static_cast<float>(count);
}

} // namespace

std::uint32_t MeshBuilder::vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv) {
  Vertex added;
  added.position = position;
  added.normal = normal;
  added.uv0 = added.uv1 = uv;
  primitive_.vertices.push_back(added);
  return static_cast<std::uint32_t>(primitive_.vertices.size() - 1);
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  primitive_.indices.insert(primitive_.indices.end(), {a, b, c});
}

void MeshBuilder::gridTriangles(std::uint32_t first, int columns, int rows, bool hasPoles) {
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const std::uint32_t a = first + static_cast<std::uint32_t>(row * columns + column);
      const std::uint32_t below = a + static_cast<std::uint32_t>(columns);
      if (!hasPoles || row + 2 < rows) triangle(a, below, below + 1);
      if (!hasPoles || row > 0) triangle(a, below + 1, a + 1);
    }
}

void MeshBuilder::quad(const glm::vec3& corner, const glm::vec3& right, const glm::vec3& up,
                       const glm::vec2& uvSize) {
  const glm::vec3 normal = glm::normalize(glm::cross(right, up));
  const std::uint32_t a = vertex(corner, normal, {0.0f, uvSize.y});
  const std::uint32_t b = vertex(corner + right, normal, uvSize);
  const std::uint32_t c = vertex(corner + right + up, normal, {uvSize.x, 0.0f});
  const std::uint32_t d = vertex(corner + up, normal, {0.0f, 0.0f});
  triangle(a, b, c);
  triangle(a, c, d);
}

void MeshBuilder::face(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, float uvPerMeter) {
  const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
  const auto uv = [&](const glm::vec3& point) { return uvPerMeter * glm::vec2(point.x + point.z, -point.y); };
  const std::uint32_t first = vertex(a, normal, uv(a));
  vertex(b, normal, uv(b));
  vertex(c, normal, uv(c));
  triangle(first, first + 1, first + 2);
}

void MeshBuilder::box(const glm::vec3& min, const glm::vec3& max, float uvPerMeter) {
  const glm::vec3 size = max - min;
  const glm::vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  const glm::vec2 front = uvPerMeter * glm::vec2(size.x, size.y),
                  side = uvPerMeter * glm::vec2(size.z, size.y), top = uvPerMeter * glm::vec2(size.x, size.z);
  quad(min + z, x, y, front);
  quad(min + x, -x, y, front);
  quad(min + x + z, -z, y, side);
  quad(min, z, y, side);
  quad(min + y + z, x, -z, top);
  quad(min, x, z, top);
}

void MeshBuilder::ball(const glm::vec3& center, float radius, int segments) {
  const std::uint32_t first = static_cast<std::uint32_t>(primitive_.vertices.size());
  const int rows = segments / 2 + 1, columns = segments + 1;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const float down = 0.5f * kTurn * fraction(row, rows - 1), around = kTurn * fraction(column, segments);
      const glm::vec3 normal(std::sin(down) * std::sin(around), std::cos(down),
                             std::sin(down) * std::cos(around));
      vertex(center + radius * normal, normal, {fraction(column, segments), fraction(row, rows - 1)});
    }
  gridTriangles(first, columns, rows, true);
}

void MeshBuilder::tube(std::span<const glm::vec3> points, float radius, int sides, bool closed) {
  assert(points.size() >= 2);
  const std::uint32_t first = static_cast<std::uint32_t>(primitive_.vertices.size());
  const int count = static_cast<int>(points.size()), rows = count + (closed ? 1 : 0);
  const auto at = [&](int i) { return points[static_cast<std::size_t>((i + count) % count)]; };
  glm::vec3 across(0.0f);
  for (int row = 0; row < rows; ++row) {
    const glm::vec3 before = closed || row > 0 ? at(row - 1) : at(0);
    const glm::vec3 after = closed || row + 1 < count ? at(row + 1) : at(count - 1);
    const glm::vec3 along = glm::normalize(after - before);
    // The frame of the last point, straightened: it does not twist.
    if (row == 0) across = std::abs(along.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    across = glm::normalize(across - along * glm::dot(along, across));
    const glm::vec3 third = glm::cross(along, across);
    for (int side = 0; side <= sides; ++side) {
      const float angle = kTurn * fraction(side, sides);
      const glm::vec3 normal = std::cos(angle) * across - std::sin(angle) * third;
      vertex(at(row) + radius * normal, normal, {fraction(side, sides), static_cast<float>(row)});
    }
  }
  gridTriangles(first, sides + 1, rows);
}

void MeshBuilder::ring(const glm::vec3& center, float ringRadius, float radius, int segments, int sides) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < segments; ++i) {
    const float angle = kTurn * fraction(i, segments);
    points.push_back(center + ringRadius * glm::vec3(std::cos(angle), std::sin(angle), 0.0f));
  }
  tube(points, radius, sides, true);
}

void MeshBuilder::lathe(const glm::vec3& center, std::span<const glm::vec2> profile, int segments) {
  assert(profile.size() >= 2);
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) { // a sharp edge at every point of the profile
    const std::uint32_t first = static_cast<std::uint32_t>(primitive_.vertices.size());
    const glm::vec2 step = profile[i + 1] - profile[i];
    const glm::vec2 outward = glm::normalize(glm::vec2(-step.y, step.x));
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column <= segments; ++column) {
        const glm::vec2 point = profile[i + static_cast<std::size_t>(row)];
        const float angle = kTurn * fraction(column, segments), c = std::cos(angle), s = std::sin(angle);
        vertex(center + glm::vec3(c * point.x, s * point.x, point.y),
               {c * outward.x, s * outward.x, outward.y},
               {fraction(column, segments), static_cast<float>(row)});
      }
    gridTriangles(first, segments + 1, 2);
  }
}

void MeshBuilder::sheet(std::span<const glm::vec3> points, int columns) {
  const int rows = static_cast<int>(points.size()) / columns;
  const std::uint32_t first = static_cast<std::uint32_t>(primitive_.vertices.size());
  const auto at = [&](int row, int column) {
    return points[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const glm::vec3 right = at(row, std::min(column + 1, columns - 1)) - at(row, std::max(column - 1, 0));
      const glm::vec3 down = at(std::min(row + 1, rows - 1), column) - at(std::max(row - 1, 0), column);
      vertex(at(row, column), glm::normalize(glm::cross(down, right)),
             {fraction(column, columns - 1), fraction(row, rows - 1)});
    }
  gridTriangles(first, columns, rows);
}

Primitive MeshBuilder::build(int material) {
  primitive_.material = material;
  makeTangents(primitive_);
  updateBounds(primitive_);
  return std::exchange(primitive_, {});
}

} // namespace taa
