// Of a primitive in groups only what lies wholly outside is left out.
#include "core/scene/TriangleGroups.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Triangles of one meter side by side along x, of which number n stands at place 37n mod `count`.
Primitive strip(int count) {
  Primitive primitive;
  for (int number = 0; number < count; ++number) {
    const auto x = static_cast<float>(37 * number % count);
    for (const glm::vec3 corner : {glm::vec3(x, 0, 0), glm::vec3(x + 1.0f, 0, 0), glm::vec3(x, 1, 0)}) {
      primitive.indices.push_back(static_cast<std::uint32_t>(primitive.vertices.size()));
      primitive.vertices.push_back({.position = corner, .uv1 = {0.0f, 1.0f}});
    }
  }
  return primitive;
}

/// x > `limit`.
HalfSpace rightOf(float limit) {
  return {{1, 0, 0, -limit}, {1, 0, 0, limit}};
}

Indices without(const Primitive& primitive, const Wind& wind, const std::vector<HalfSpace>& outside) {
  Indices indices;
  TriangleGroups(primitive, wind).append(primitive, outside, indices);
  return indices;
}

/// Those of triangles of a strip that begin left of `limit`.
Indices leftOf(const Primitive& primitive, float limit) {
  Indices indices;
  for (std::size_t first = 0; first < primitive.indices.size(); first += 3)
    if (primitive.vertices[primitive.indices[first]].position.x < limit)
      indices.insert(indices.end(), primitive.indices.begin() + std::ptrdiff_t(first),
                     primitive.indices.begin() + std::ptrdiff_t(first) + 3);
  return indices;
}

} // namespace

TEST(TriangleGroups, LeaveOutWhatLiesWhollyOutsideInTheOrderOfTheMesh) {
  const Primitive primitive = strip(128); // groups of 32: from 0, 32, 64 and 96 m on
  EXPECT_EQ(without(primitive, {}, {rightOf(40.0f)}), leftOf(primitive, 64.0f));
  EXPECT_EQ(without(primitive, {}, {rightOf(31.9f)}), leftOf(primitive, 32.0f));
  EXPECT_EQ(without(primitive, {}, {rightOf(200.0f), rightOf(90.0f)}), leftOf(primitive, 96.0f));
  EXPECT_EQ(without(primitive, {}, {rightOf(200.0f)}), primitive.indices);
  EXPECT_EQ(without(primitive, {}, {}), primitive.indices);
  EXPECT_EQ(without(primitive, {}, {rightOf(-1.0f)}), Indices{});
}

TEST(TriangleGroups, KeepWhatTheWindMayBlowInside) {
  const Primitive primitive = strip(128);
  const Wind wind{.amplitude = 0.5f, .waveNumber = 1.0f, .frequency = 1.0f, .direction = {-1, 0, 0}};
  EXPECT_EQ(without(primitive, {}, {rightOf(63.75f)}), leftOf(primitive, 64.0f));
  EXPECT_EQ(without(primitive, wind, {rightOf(63.75f)}), leftOf(primitive, 96.0f));
  EXPECT_EQ(without(primitive, wind, {rightOf(63.25f)}), leftOf(primitive, 64.0f));
}

// Sums of large numbers are off by what small ones are.
TEST(TriangleGroups, KeepWhatRoundingMayPutInside) {
  Primitive primitive = strip(128);
  for (Vertex& vertex : primitive.vertices) vertex.position.y += 1e6f;
  const HalfSpace steep{{1.0f, 1.0f, 0.0f, -1e6f - 63.0f}, {1.0f, 1.0f, 0.0f, 1e6f}};
  EXPECT_EQ(without(primitive, {}, {{steep.plane, {}}}), leftOf(primitive, 64.0f));
  EXPECT_EQ(without(primitive, {}, {steep}), leftOf(primitive, 96.0f));
}

TEST(TriangleGroups, KeepEveryTriangleThatReachesOut) {
  Primitive primitive;
  std::uint32_t random = 7;
  const auto next = [&random] {
    random = random * 1664525u + 1013904223u;
    return static_cast<float>(random >> 8u) / static_cast<float>(1u << 24u);
  };
  for (std::uint32_t triangle = 0; triangle < 2000; ++triangle) {
    const glm::vec3 place(next(), next(), next());
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      primitive.vertices.push_back({.position = place + 0.1f * glm::vec3(next(), next(), next())});
      primitive.indices.push_back(3 * triangle + corner);
    }
  }
  const std::vector<HalfSpace> outside{{{1, 0.5f, 0, -0.9f}, {1, 0.5f, 0, 0.9f}},
                                       {{0, -1, 0.25f, 0.1f}, {0, 1, 0.25f, 0.1f}}};
  const Indices kept = without(primitive, {}, outside);
  ASSERT_GE(kept.size(), 3u);
  EXPECT_LT(kept.size(), primitive.indices.size());
  std::size_t at = 0;
  for (std::size_t first = 0; first < primitive.indices.size(); first += 3) {
    const bool isNext = std::equal(primitive.indices.begin() + std::ptrdiff_t(first),
                                   primitive.indices.begin() + std::ptrdiff_t(first) + 3,
                                   kept.begin() + std::ptrdiff_t(std::min(at, kept.size() - 3)));
    if (isNext && at < kept.size()) {
      at += 3;
      continue;
    }
    const auto holds = [&](const HalfSpace& space) {
      for (std::size_t corner = 0; corner < 3; ++corner)
        if (glm::dot(space.plane,
                     glm::vec4(primitive.vertices[primitive.indices[first + corner]].position, 1.0f)) <= 0.0f)
          return false;
      return true;
    };
    EXPECT_TRUE(std::ranges::any_of(outside, holds)) << "triangle " << first / 3;
  }
  EXPECT_EQ(at, kept.size()) << "in the order of the mesh";
}

} // namespace taa
