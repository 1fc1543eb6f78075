// What is drawn: vertices, what moves them other than with their node, and bounds, as data.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace taa {

/// An axis-aligned box, world or model space as the owner says; empty until something is added.
struct Bounds {
  glm::vec3 min{std::numeric_limits<float>::max()};
  glm::vec3 max{std::numeric_limits<float>::lowest()};
  bool isEmpty() const { return min.x > max.x; }
  glm::vec3 center() const { return 0.5f * (min + max); }
  float radius() const { return isEmpty() ? 0.0f : 0.5f * glm::length(max - min); }
  void add(const glm::vec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
};

/// Interleaved as the vertex buffer holds it.
struct Vertex {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f, 0.0f, 1.0f};
  glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f}; ///< w: sign of the bitangent
  glm::vec2 uv0{0.0f}, uv1{0.0f};
  glm::vec4 color{1.0f}; ///< linear
};

enum class Topology : std::uint8_t {
  Triangles,
  Lines,
  Points
}; ///< strips, fans and loops are unrolled by the loader

/// Four of the joints that move a vertex, and how much.
struct Influence {
  glm::vec4 joints{0.0f};  ///< into Skin::joints, whole numbers
  glm::vec4 weights{0.0f}; ///< their sum over all sets of a vertex is 1
};

/// What a morph target of weight 1 adds to a vertex.
struct MorphDelta {
  glm::vec3 position{0.0f}, normal{0.0f}, tangent{0.0f};
};

/// Positions baked for each vertex, frame after frame, as Alembic has them (manual 3.6).
struct VertexCache {
  struct Entry {
    glm::vec3 position{0.0f}, normal{0.0f};
    glm::vec3 velocity{0.0f}; ///< model units a second
  };
  int frames = 0;               ///< 0: none; they repeat
  double framesPerSecond = 0.0; ///< 0: always the first
  std::vector<Entry> entries;   ///< frames × vertices
};

struct Primitive {
  Topology topology = Topology::Triangles;
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;           ///< always given
  int material = 0;                             ///< into Scene::materials, always valid
  Bounds bounds;                                ///< model space, undeformed
  int influenceSets = 0;                        ///< 0 to 2; 0: no skin moves it
  std::vector<Influence> influences;            ///< influenceSets for each vertex
  std::vector<std::vector<MorphDelta>> targets; ///< one delta a vertex each
  VertexCache cache;
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
};

} // namespace taa
