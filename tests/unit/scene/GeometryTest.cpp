// Normals of morphed meshes against closed forms, and bounds of what is drawn.
#include "core/scene/Geometry.h"
#include "core/scene/Pose.h"
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

TEST(RestBounds, HoldEveryInstance) {
  Scene scene;
  scene.materials.resize(1);
  MeshBuilder mesh;
  mesh.ball({0, 0, 0}, 1.0f, 8);
  scene.meshes.resize(1);
  scene.meshes[0].primitives.push_back(mesh.build(0));
  scene.nodes.resize(1);
  scene.nodes[0].translation = {0, 5, 0};
  scene.nodes[0].mesh = 0;
  scene.nodes[0].firstInstance = 0;
  scene.nodes[0].instanceCount = 2;
  const glm::quat upright(1, 0, 0, 0);
  scene.instances = {instanceTransform({-3, 0, 0}, upright, glm::vec3(1)),
                     instanceTransform({4, 0, 0}, upright, glm::vec3(2))};
  const Bounds ball = scene.meshes[0].primitives[0].bounds, bounds = restBounds(scene);
  EXPECT_EQ(bounds.min.x, ball.min.x - 3);
  EXPECT_EQ(bounds.max, 2.0f * ball.max + glm::vec3(4, 5, 0));
}

} // namespace
} // namespace taa
