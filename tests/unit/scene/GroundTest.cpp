// A model that brings neither light nor camera stands on a ground, and its shadow with it.
#include "core/scene/builtin/Ground.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/frames/GltfSample.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <cstddef>

namespace taa {
namespace {

using test::GltfSample;

/// The sample without what lights it and what it is seen through.
GltfSample modelAlone() {
  GltfSample sample;
  sample.json["nodes"][2].erase("camera");
  sample.json["nodes"][2].erase("extensions");
  return sample;
}

bool contains(const Bounds& box, const glm::vec3& point) {
  return glm::all(glm::lessThanEqual(box.min, point)) && glm::all(glm::lessThanEqual(point, box.max));
}

TEST(Ground, IsUnderAModelAloneAndSaid) {
  const Scene scene = openScene(modelAlone().writeEmbedded("alone").string());
  ASSERT_FALSE(scene.nodes.empty());
  EXPECT_EQ(scene.nodes.back().name, kGroundName);
  EXPECT_EQ(scene.sky.shadows, SunShadows::Soft);
  EXPECT_TRUE(scene.sky.sunEnabled);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings.front(),
            "The file has neither light nor camera: a sun and a ground are added (object \"added ground\").");
}

TEST(Ground, IsNotUnderWhatBringsALightOrACamera) {
  const auto lastName = [](const GltfSample& sample) {
    const Scene scene = openScene(sample.writeEmbedded("brought").string());
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(scene.sky.shadows, SunShadows::None);
    return scene.nodes.back().name;
  };
  GltfSample lit, seen;
  lit.json["nodes"][2].erase("camera");
  seen.json["nodes"][2].erase("extensions");
  for (const GltfSample& sample : {lit, seen, GltfSample()}) EXPECT_NE(lastName(sample), kGroundName);
}

TEST(Ground, IsNotUnderNothing) {
  GltfSample nothing = modelAlone();
  for (auto& node : nothing.json["nodes"]) node.erase("mesh"), node.erase("skin");
  const Scene scene = openScene(nothing.writeEmbedded("nothing").string());
  EXPECT_NE(scene.nodes.back().name, kGroundName);
}

// By the geometry alone: from where the model is seen, and from any size and place of it.
TEST(Ground, LiesBelowTheModelFacesUpAndReachesPastItsShadow) {
  for (const float size : {0.01f, 1.0f, 500.0f}) {
    Scene scene;
    scene.bounds.add(size * glm::vec3(3.0f, -2.0f, 1.0f));
    scene.bounds.add(size * glm::vec3(4.0f, 1.0f, 2.5f));
    const Bounds model = scene.bounds;
    ASSERT_TRUE(isModelAlone(scene));
    addGround(scene);
    EXPECT_EQ(scene.bounds.min, model.min) << "cameras look at the model";
    EXPECT_EQ(scene.bounds.max, model.max);
    ASSERT_EQ(scene.meshes.size(), 1u);
    const Primitive& floor = scene.meshes.front().primitives.front();
    const float height = floor.vertices.front().position.y;
    EXPECT_LT(height, model.min.y);
    EXPECT_GT(height, model.min.y - 0.01f * size);
    for (std::size_t i = 0; i < floor.indices.size(); i += 3) {
      const auto corner = [&](std::size_t k) { return floor.vertices[floor.indices[i + k]].position; };
      const glm::vec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
      ASSERT_GT(normal.y, 0.0f);
      ASSERT_EQ(corner(0).y, height);
    }
    // The shadow of each corner of the model.
    const glm::vec3 toSun = glm::normalize(scene.sky.sunDirection);
    const float reach = floor.bounds.max.x - model.center().x;
    for (int i = 0; i < 8; ++i) {
      const glm::vec3 corner(i & 1 ? model.max.x : model.min.x, i & 2 ? model.max.y : model.min.y,
                             i & 4 ? model.max.z : model.min.z);
      const float way = (corner.y - height) / toSun.y;
      glm::vec3 shadow = corner - way * toSun;
      EXPECT_LT(glm::length(shadow - model.center()), reach);
      shadow.y = height + 1e-5f * size;
      Bounds wider = scene.sky.shadowed; // by rounding
      wider.add(wider.min - glm::vec3(1e-4f * size));
      wider.add(wider.max + glm::vec3(1e-4f * size));
      EXPECT_TRUE(contains(wider, shadow)) << size << ", corner " << i;
    }
  }
}

} // namespace
} // namespace taa
