// Boxes of deformed primitives hold every vertex, and little else.
#include "core/scene/DeformBounds.h"

#include "core/scene/Deform.h"
#include "core/scene/builtin/SceneSource.h"

#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <vector>

namespace taa {
namespace {

/// The box of a primitive at a node, as the renderer asks for it.
Bounds boxAt(const Scene& scene, std::size_t node, const Primitive& primitive, double time) {
  const Node& at = scene.nodes[node];
  const Pose pose = poseAt(scene, time);
  const Wind& wind = scene.materials[std::size_t(primitive.material)].wind;
  const DeformExtent extent = deformExtent(primitive, wind);
  std::vector<glm::mat4> joints;
  if (at.skin >= 0 && primitive.influenceSets > 0)
    joints = jointMatrices(scene, scene.skins[std::size_t(at.skin)], pose);
  std::span<const float> weights;
  if (at.firstWeight >= 0)
    weights = std::span(pose.morphWeights).subspan(std::size_t(at.firstWeight), primitive.targets.size());
  return deformedBounds({primitive, extent, wind, weights, joints}, time);
}

bool holds(const Bounds& box, const glm::vec3& point) {
  return glm::all(glm::lessThanEqual(box.min, point)) && glm::all(glm::greaterThanEqual(box.max, point));
}

/// Every deformed vertex of a scene at times all over the shot; how many there were.
int expectAllHeld(const Scene& scene) {
  int count = 0;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    if (scene.nodes[node].mesh < 0) continue;
    for (const Primitive& primitive : scene.meshes[std::size_t(scene.nodes[node].mesh)].primitives) {
      if (!isDeformed(scene, scene.nodes[node], primitive)) continue;
      for (double time = 0.0; time < 4.0; time += 0.23) {
        const Pose pose = poseAt(scene, time);
        const Deformer deformer(scene, int(node), primitive, pose, time);
        const bool isSkinned = scene.nodes[node].skin >= 0 && primitive.influenceSets > 0;
        const glm::mat4 boxFromWorld = isSkinned ? glm::mat4(1.0f) : glm::inverse(pose.worldFromNode[node]);
        Bounds box = boxAt(scene, node, primitive, time);
        EXPECT_FALSE(box.isEmpty());
        box.min -= 1e-4f; // the way to the world and back
        box.max += 1e-4f;
        for (std::size_t vertex = 0; vertex < primitive.vertices.size(); vertex += 7, ++count) {
          const glm::vec3 point(boxFromWorld * glm::vec4(deformer.position(vertex), 1.0f));
          if (!holds(box, point)) {
            ADD_FAILURE() << scene.nodes[node].name << " at " << time << " s: vertex " << vertex
                          << " is outside";
            break;
          }
        }
      }
    }
  }
  return count;
}

TEST(DeformBounds, HoldTheVerticesOfTheBuiltInScenes) {
  EXPECT_GT(expectAllHeld(openScene("builtin:gallery")), 1000); // skin, morph targets, wind and cache
  EXPECT_GT(expectAllHeld(openScene("builtin:foliage")), 1000);
  EXPECT_GT(expectAllHeld(openScene("builtin:glass")), 100);
}

/// Two vertices at x = 0 and 1, with nothing that deforms them.
Primitive twoPoints() {
  Primitive primitive;
  primitive.vertices.resize(2);
  primitive.vertices[1].position = {1, 0, 0};
  primitive.vertices[0].uv1 = {0, 0.5f};
  primitive.bounds.add({0, 0, 0});
  primitive.bounds.add({1, 0, 0});
  return primitive;
}

Bounds boxOf(const Primitive& primitive, const Wind& wind, std::span<const float> weights,
             std::span<const glm::mat4> joints, double time = 0.0) {
  const DeformExtent extent = deformExtent(primitive, wind);
  return deformedBounds({primitive, extent, wind, weights, joints}, time);
}

void expectNear(const Bounds& box, const glm::vec3& min, const glm::vec3& max) {
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.min[axis], min[axis], 1e-3f) << axis;
    EXPECT_NEAR(box.max[axis], max[axis], 1e-3f) << axis;
  }
}

TEST(DeformBounds, AddMorphTargetsByTheirWeights) {
  Primitive primitive = twoPoints();
  primitive.targets = {{{{0, 2, 0}, {}, {}}, {{0, 1, 0}, {}, {}}}, {{{0, 0, 4}, {}, {}}, {}}};
  expectNear(boxOf(primitive, {}, std::array{0.5f, -0.25f}, {}), {0, 0.5f, -1}, {1, 1, 0});
  expectNear(boxOf(primitive, {}, std::array{0.0f, 0.0f}, {}), {0, 0, 0}, {1, 0, 0});
}

TEST(DeformBounds, ReachAsFarAsTheWind) {
  Wind wind;
  wind.amplitude = -2.0f;
  wind.direction = {0, 3, -1};
  expectNear(boxOf(twoPoints(), wind, {}, {}), {0, -3, -1}, {1, 3, 1}); // bends by ½ at most
}

TEST(DeformBounds, AreThoseOfTheFrameOfTheCache) {
  Primitive primitive = twoPoints();
  primitive.cache.frames = 2;
  primitive.cache.framesPerSecond = 1.0;
  primitive.cache.entries.resize(4);
  primitive.cache.entries[2].position = {5, 5, 5};
  primitive.cache.entries[3].position = {6, 5, 5};
  expectNear(boxOf(primitive, {}, {}, {}, 1.0), {5, 5, 5}, {6, 5, 5});
  expectNear(boxOf(primitive, {}, {}, {}, 2.0), {0, 0, 0}, {0, 0, 0});
}

/// The first vertex follows joint 0, the second joint 2, and nothing joint 1.
Primitive skinnedPoints() {
  Primitive primitive = twoPoints();
  primitive.influenceSets = 1;
  primitive.influences = {{{0, 1, 0, 0}, {1, 0, 0, 0}}, {{2, 0, 0, 0}, {1, 0, 0, 0}}};
  return primitive;
}

TEST(DeformBounds, FollowTheJointsThatMoveVertices) {
  glm::mat4 far(1.0f), up(1.0f);
  far[3] = {1000, 1000, 1000, 1};
  up[3] = {0, 7, 0, 1};
  expectNear(boxOf(skinnedPoints(), {}, {}, std::array{glm::mat4(1.0f), far, up}), {0, 0, 0}, {1, 7, 0});
}

TEST(DeformBounds, SayNothingOfASkinThatPushesVerticesAway) {
  Primitive primitive = skinnedPoints();
  primitive.influences[0].weights = {2, -1, 0, 0};
  const std::array joints{glm::mat4(1.0f), glm::mat4(1.0f), glm::mat4(1.0f)};
  EXPECT_TRUE(boxOf(primitive, {}, {}, joints).isEmpty());
}

TEST(DeformBounds, MorphBeforeTheSkinTurns) {
  Primitive primitive = skinnedPoints();
  primitive.targets = {{{{0, 0, 2}, {}, {}}, {{0, 0, 2}, {}, {}}}};
  glm::mat4 turn(1.0f); // z to y
  turn[1] = {0, 0, -1, 0};
  turn[2] = {0, 1, 0, 0};
  const std::array joints{turn, turn, turn};
  expectNear(boxOf(primitive, {}, std::array{1.0f}, joints), {0, 2, 0}, {1, 2, 0});
}

} // namespace
} // namespace taa
