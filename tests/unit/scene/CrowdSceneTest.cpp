// builtin:crowd is as large as it says.
#include "core/scene/ObjectClass.h"
#include "core/scene/builtin/SceneSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace taa {
namespace {

std::size_t triangleCount(const Mesh& mesh) {
  std::size_t count = 0;
  for (const Primitive& primitive : mesh.primitives) count += primitive.indices.size() / 3;
  return count;
}

TEST(CrowdScene, HasAMillionTrianglesOnFiveHundredObjectsOfAFewMeshes) {
  const Scene scene = openScene("builtin:crowd");
  std::map<int, std::size_t> uses;
  for (const Node& node : scene.nodes)
    if (node.mesh >= 0) ++uses[node.mesh];
  std::size_t objects = 0, stored = 0, drawn = 0;
  for (const auto& [mesh, count] : uses) {
    objects += count;
    stored += triangleCount(scene.meshes[std::size_t(mesh)]);
    drawn += count * triangleCount(scene.meshes[std::size_t(mesh)]);
  }
  EXPECT_GT(drawn, 1'000'000u);
  EXPECT_GE(objects, 500u);
  EXPECT_GE(uses.size(), 8u);
  EXPECT_LT(stored, 30'000u) << "meshes are shared";
}

TEST(CrowdScene, StandsAndMoves) {
  const std::vector<bool> moves = movingNodes(openScene("builtin:crowd"));
  EXPECT_GT(std::ranges::count(moves, true), 200);
  EXPECT_GT(std::ranges::count(moves, false), 200);
}

} // namespace
} // namespace taa
