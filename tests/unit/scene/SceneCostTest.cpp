// Tests of what a scene asks for: counted by hand, the same from a file's counts as from the scene it
// becomes, and refused beyond a budget.
#include "core/scene/SceneCost.h"

#include "core/base/Error.h"
#include "core/scene/Scene.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/Paths.h"
#include "tests/support/frames/GltfSample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::GltfSample;

/// The sentence a file is refused with, without "cannot open FILE: "; "" where it opens.
std::string refusalWithin(const fs::path& file, const SceneBudget& budget) {
  try {
    openScene(file.string(), {}, {}, budget);
    return "";
  } catch (const Error& error) {
    const std::string text = error.what(), start = "cannot open " + file.string() + ": ";
    EXPECT_TRUE(text.starts_with(start)) << text;
    return text.substr(std::min(text.size(), start.size()));
  }
}

/// A mesh of triangles and instances of it, without a byte of data: accessors without a view are zeros.
json asksFor(std::uint64_t triangles, std::uint64_t instances) {
  const json attributes = {{"TRANSLATION", 1}};
  return {
      {"asset", {{"version", "2.0"}}},
      {"extensionsUsed", {"EXT_mesh_gpu_instancing"}},
      {"nodes", {{{"mesh", 0}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}}}},
      {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
      {"accessors",
       {{{"componentType", 5126}, {"type", "VEC3"}, {"count", 3 * triangles}},
        {{"componentType", 5126}, {"type", "VEC3"}, {"count", instances}}}}};
}

TEST(SceneCost, OfTenBillionTrianglesInAKilobyteIsToldBeforeAnyIsMade) {
  const std::string bytes = asksFor(100'000, 100'000).dump();
  ASSERT_LT(bytes.size(), 1024u);
  const fs::path file = test::writeTemporary("greedy.gltf", bytes);
  const std::clock_t start = std::clock();
  EXPECT_EQ(refusalWithin(file, {}),
            "nodes[0].extensions.EXT_mesh_gpu_instancing: the scene draws 10000000000 triangles and may draw "
            "20000000; --scene-triangles 10000 lets it");
  // To make the vertices alone takes longer.
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 0.2);
}

TEST(SceneCost, IsNotTooLargeToBeCounted) {
  EXPECT_EQ(cappedProduct(std::uint64_t(1) << 40, std::uint64_t(1) << 40),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(cappedProduct(std::uint64_t(1) << 40, 3), std::uint64_t(3) << 40);
  EXPECT_EQ(cappedProduct(7, 0), 0u);
  EXPECT_EQ(cappedSum(std::numeric_limits<std::uint64_t>::max() - 1, 2),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(cappedSum(2, 3), 5u);
}

TEST(SceneCost, BeyondTheBudgetSaysWhatBudgetLetsItIn) {
  const fs::path file = test::writeTemporary("needs.gltf", asksFor(1001, 1000).dump());
  const SceneBudget tight{.triangles = 1'000'000, .bytes = 5};
  try {
    openScene(file.string(), {}, {}, tight);
    FAIL();
  } catch (const BudgetError& error) {
    EXPECT_EQ(error.needed().triangles, 2'000'000u) << "1,001,000, in millions as the option has it";
    EXPECT_EQ(error.needed().bytes, std::uint64_t(1) << 20);
    EXPECT_EQ(refusalWithin(file, error.needed()), "");
  }
  const SceneBudget wide = budgetFor({.triangles = 7, .bytes = 7}, {});
  EXPECT_EQ(wide.triangles, SceneBudget().triangles) << "none is made smaller";
  EXPECT_EQ(wide.bytes, SceneBudget().bytes);
}

TEST(SceneCost, OfWhatTheBudgetJustAllowsIsAccepted) {
  const fs::path file = test::writeTemporary("hundred.gltf", asksFor(10, 10).dump());
  EXPECT_EQ(refusalWithin(file, {.triangles = 100}), "");
  EXPECT_EQ(refusalWithin(file, {.triangles = 99}),
            "nodes[0].extensions.EXT_mesh_gpu_instancing: the scene draws 100 triangles and may draw 99; "
            "--scene-triangles 1 lets it");
}

TEST(SceneCost, NamesTheNodeThatAsksForMost) {
  json file = asksFor(10, 10);
  file["nodes"].insert(file["nodes"].begin(), json{{"mesh", 0}});
  EXPECT_EQ(refusalWithin(test::writeTemporary("two.gltf", file.dump()), {.triangles = 109}),
            "nodes[1].extensions.EXT_mesh_gpu_instancing: the scene draws 110 triangles and may draw 109; "
            "--scene-triangles 1 lets it");
}

TEST(SceneCost, CountsWhatTheSceneLeavesOutForNothing) {
  json file = asksFor(10, 10);
  file["nodes"].push_back({{"mesh", 0}});
  file["scenes"] = {{{"nodes", {1}}}};
  EXPECT_EQ(refusalWithin(test::writeTemporary("left.gltf", file.dump()), {.triangles = 10}), "");
}

// Where the sentence names a mesh, the file's counts said so: the same budget less a byte or a triangle.
TEST(SceneCost, OfAFileIsThatOfItsScene) {
  for (const int mode : {0, 1, 2, 3, 4, 5, 6})
    for (const bool hasNormals : {false, true}) {
      json file = asksFor(3, 2);
      json& primitive = file["meshes"][0]["primitives"][0];
      primitive["mode"] = mode;
      if (hasNormals) primitive["attributes"]["NORMAL"] = 0;
      primitive["attributes"]["JOINTS_0"] = 2;
      primitive["attributes"]["WEIGHTS_0"] = 3;
      primitive["attributes"]["_VELOCITY"] = 0;
      primitive["targets"] = {{{"POSITION", 0}}, {{"NORMAL", 0}}};
      file["accessors"].push_back({{"componentType", 5121}, {"type", "VEC4"}, {"count", 9}});
      file["accessors"].push_back({{"componentType", 5126}, {"type", "VEC4"}, {"count", 9}});
      const fs::path path = test::writeTemporary("counts.gltf", file.dump());
      const SceneCost cost = costOf(openScene(path.string()));
      const std::string what = "mode " + std::to_string(mode) + (hasNormals ? ", normals" : "");
      const SceneBudget just{cost.triangles, cost.bytes};
      EXPECT_EQ(refusalWithin(path, just), "") << what;
      EXPECT_TRUE(refusalWithin(path, {just.triangles - 1, just.bytes}).starts_with("nodes[0].")) << what;
      EXPECT_TRUE(refusalWithin(path, {just.triangles, just.bytes - 1}).starts_with("meshes[0]: ")) << what;
    }
}

TEST(SceneCost, IsCountedFromTheScenesData) {
  Scene scene;
  scene.images.push_back({"picture", 4, 2, std::vector<std::uint8_t>(32)});
  scene.materials.resize(2);
  scene.materials[0].baseColorTexture.image = 0;
  scene.materials[1].normalTexture.image = 0; // as numbers: a texture of its own
  Primitive primitive;
  primitive.vertices.resize(4);
  primitive.indices = {0, 1, 2, 1, 3, 2};
  scene.meshes.push_back({"quad", {primitive, primitive}});
  for (int i = 0; i < 3; ++i) scene.nodes.emplace_back().mesh = i == 0 ? -1 : 0;
  const SceneCost cost = costOf(scene);
  EXPECT_EQ(cost.objects, 4u);
  EXPECT_EQ(cost.triangles, 8u);
  EXPECT_EQ(cost.vertices, 8u);
  // 18 floats a vertex; levels of 4 × 2, 2 × 1 and 1 × 1 texels, twice.
  EXPECT_EQ(cost.bytes, 2u * (4u * 72u + 6u * 4u) + 2u * 4u * (8u + 2u + 1u));
  EXPECT_EQ(costRefusal(cost, {8, cost.bytes}), "");
  EXPECT_EQ(costRefusal(cost, {8, cost.bytes - 1}),
            "the scene takes 1 MiB of buffers and textures and may take 0; --scene-memory 1 lets it");
}

} // namespace
} // namespace taa
