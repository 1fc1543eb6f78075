// Normals of morphed meshes against closed forms.
#include "core/scene/Geometry.h"
#include "core/scene/builtin/MeshBuilder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace taa {
namespace {

/// A fine ball about the origin with one morph target that moves each vertex to `moved` of it.
template <class Moved>
Primitive morphedBall(Moved moved) {
  MeshBuilder mesh;
  mesh.ball({0, 0, 0}, 1.0f, 64);
  Primitive ball = mesh.build(0);
  ball.targets.resize(1);
  for (const Vertex& vertex : ball.vertices)
    ball.targets[0].push_back({moved(vertex.position) - vertex.position, {}, {}});
  makeMorphNormals(ball);
  return ball;
}

TEST(MorphNormals, StayWhereAMeshIsOnlyScaledOrMoved) {
  const Primitive ball = morphedBall([](const glm::vec3& p) { return 2.0f * p + glm::vec3(5, 0, 0); });
  for (const MorphDelta& delta : ball.targets[0]) ASSERT_LT(glm::length(delta.normal), 1e-5f);
}

TEST(MorphNormals, AreThoseOfTheMovedSurface) {
  // An ellipsoid of half axes 2, 1, 1: its normals are those of (x/4, y, z).
  const Primitive ball = morphedBall([](const glm::vec3& p) { return glm::vec3(2.0f * p.x, p.y, p.z); });
  float worst = 0.0f, change = 0.0f;
  for (std::size_t i = 0; i < ball.vertices.size(); ++i) {
    const glm::vec3 p = ball.vertices[i].position;
    const glm::vec3 expected = glm::normalize(glm::vec3(0.5f * p.x, p.y, p.z));
    const glm::vec3 normal = ball.vertices[i].normal + ball.targets[0][i].normal;
    worst = std::max(worst, glm::distance(normal, expected));
    change = std::max(change, glm::length(ball.targets[0][i].normal));
  }
  EXPECT_LT(worst,
            0.03f); // a quarter of a facet of 1/64 of a turn at the seam, which has faces on one side only
  EXPECT_GT(change, 0.3f);
}

} // namespace
} // namespace taa
