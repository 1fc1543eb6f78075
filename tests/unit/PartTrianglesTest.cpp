// Of a part those triangles are drawn that hold the center of one of its pixels, on the side that is drawn.
#include "core/render/passes/PartTriangles.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace taa {
namespace {

constexpr float kSizePx = 64.0f;
const gl::Rect kPart{16, 20, 8, 1};
const Wind kStill{};

/// From px, rows going down, to clip space.
glm::mat4 clipFromPx() {
  glm::mat4 matrix(0.0f);
  matrix[0][0] = 2.0f / kSizePx;
  matrix[1][1] = -2.0f / kSizePx;
  matrix[3] = {-1.0f, 1.0f, 0.5f, 1.0f};
  return matrix;
}

/// A triangle of 0.2 × 0.4 px at the center of each pixel of row 20; as the camera sees them clockwise.
Primitive rowOfSmall(bool isClockwise) {
  Primitive primitive;
  for (int x = 0; x < int(kSizePx); ++x) {
    const glm::vec3 center(float(x) + 0.5f, 20.5f, 0.0f);
    const float below = isClockwise ? 0.4f : -0.4f;
    for (const glm::vec3 corner :
         {center + glm::vec3(-0.1f, 0, 0), center + glm::vec3(0.1f, 0, 0), center + glm::vec3(0, below, 0)}) {
      primitive.indices.push_back(static_cast<std::uint32_t>(primitive.vertices.size()));
      primitive.vertices.push_back({.position = corner, .uv1 = {0.0f, 1.0f}});
      primitive.bounds.add(corner);
    }
  }
  return primitive;
}

PartSides sidesOfPart() {
  View view;
  view.block.sizePx = {kSizePx, kSizePx};
  view.part = kPart;
  return {clipSides(view), glm::vec4(0.0f), kPart, {kSizePx, kSizePx}};
}

PlacedPrimitive placedAs(const Primitive& primitive, const Wind& wind) {
  PlacedPrimitive placed{{0, 0}, primitive, wind};
  placed.clipFromVertex = clipFromPx();
  return placed;
}

/// Columns of the triangles that are drawn.
std::vector<int> columnsOf(const PartTriangles& triangles) {
  std::vector<int> columns;
  for (std::size_t at = 0; at < triangles.indices().size(); at += 3) {
    EXPECT_EQ(triangles.indices()[at] % 3, 0u);
    columns.push_back(static_cast<int>(triangles.indices()[at] / 3));
  }
  return columns;
}

std::vector<int> drawnOf(const PlacedPrimitive& placed, const glm::vec2& jitterPx) {
  PartTriangles triangles;
  EXPECT_EQ(triangles.add(placed, sidesOfPart()), std::optional<std::size_t>(0));
  triangles.select(jitterPx);
  EXPECT_EQ(triangles.range(0).count, triangles.indices().size());
  return columnsOf(triangles);
}

using Columns = std::vector<int>;
const Columns kAll{16, 17, 18, 19, 20, 21, 22, 23};

} // namespace

TEST(PartTriangles, AreThoseThatHoldACenterAtTheJitter) {
  const Primitive row = rowOfSmall(true);
  const PlacedPrimitive placed = placedAs(row, kStill);
  EXPECT_EQ(drawnOf(placed, {0.0f, 0.0f}), kAll);
  EXPECT_EQ(drawnOf(placed, {-0.09f, -0.05f}), kAll);
  EXPECT_EQ(drawnOf(placed, {0.25f, 0.0f}), Columns{});
  EXPECT_EQ(drawnOf(placed, {0.0f, 0.25f}), Columns{});
  EXPECT_EQ(drawnOf(placed, {1.0f, 0.0f}), (Columns{15, 16, 17, 18, 19, 20, 21, 22}));
}

// The box around the triangle holds the center of its pixel, the triangle does not.
TEST(PartTriangles, ThatLieBesideCentersAreLeftOut) {
  Primitive row = rowOfSmall(true);
  for (std::size_t vertex = 0; vertex < row.vertices.size(); vertex += 3) {
    const float left = row.vertices[vertex].position.x - 0.3f; // of the center by 0.4
    row.vertices[vertex].position = {left, 20.1f, 0.0f};
    row.vertices[vertex + 1].position = {left + 0.8f, 20.1f, 0.0f};
    row.vertices[vertex + 2].position = {left, 20.9f, 0.0f};
  }
  const PlacedPrimitive placed = placedAs(row, kStill);
  EXPECT_EQ(drawnOf(placed, {0.0f, 0.0f}), kAll) << "the long side runs through the center";
  EXPECT_EQ(drawnOf(placed, {0.2f, 0.2f}), kAll) << "it lies behind that";
  EXPECT_EQ(drawnOf(placed, {-0.02f, -0.02f}), kAll) << "GL may round it back";
  EXPECT_EQ(drawnOf(placed, {-0.2f, -0.2f}), Columns{});
  EXPECT_EQ(drawnOf(placed, {0.3f, -0.3f}), kAll) << "the long side moved along itself";
}

// Each holds more centers than are looked at one by one.
TEST(PartTriangles, ThatAreLargeAreDrawn) {
  Primitive row = rowOfSmall(true);
  for (std::size_t vertex = 0; vertex < row.vertices.size(); vertex += 3) {
    row.vertices[vertex].position = {8.0f, 16.0f, 0.0f};
    row.vertices[vertex + 1].position = {40.0f, 16.0f, 0.0f};
    row.vertices[vertex + 2].position = {8.0f, 48.0f, 0.0f};
  }
  EXPECT_EQ(drawnOf(placedAs(row, kStill), {}).size(), row.vertices.size() / 3);
}

// Of one selection nothing is left in the next.
TEST(PartTriangles, AreSelectedAnewForEachJitter) {
  const Primitive row = rowOfSmall(true);
  PartTriangles triangles;
  triangles.add(placedAs(row, kStill), sidesOfPart());
  for (const float shift : {0.5f, 0.0f}) {
    triangles.select({shift, 0.0f});
    EXPECT_EQ(columnsOf(triangles), shift == 0.0f ? kAll : Columns{});
  }
}

TEST(PartTriangles, LeaveOutTheSideThatIsCulled) {
  for (const bool isClockwise : {false, true}) {
    const Primitive row = rowOfSmall(isClockwise);
    PlacedPrimitive placed = placedAs(row, kStill);
    placed.culledClockwise = !isClockwise;
    EXPECT_EQ(drawnOf(placed, {}), kAll);
    placed.culledClockwise = isClockwise;
    PartTriangles triangles;
    triangles.add(placed, sidesOfPart());
    EXPECT_TRUE(triangles.isEmpty(0));
  }
}

// GL rounds corners: what is as thin as that may turn.
TEST(PartTriangles, KeepWhatRoundingMayTurn) {
  Primitive row = rowOfSmall(true);
  for (std::size_t vertex = 2; vertex < row.vertices.size(); vertex += 3)
    row.vertices[vertex].position.y = 20.51f;
  PlacedPrimitive placed = placedAs(row, kStill);
  placed.culledClockwise = true;
  EXPECT_EQ(drawnOf(placed, {}), kAll);
}

// Their corners' places are not known, but those of their groups.
TEST(PartTriangles, AreAllThatTheWindMoves) {
  const Primitive row = rowOfSmall(true);
  const Wind wind{.amplitude = 0.01f};
  const Columns drawn = drawnOf(placedAs(row, wind), {0.5f, 0.0f});
  ASSERT_EQ(drawn.size(), 32u); // the one group that reaches the part
  EXPECT_EQ(drawn.front(), 0);
}

TEST(PartTriangles, AreAllWhereOthersMoveThemOrTheyAreClipped) {
  Primitive row = rowOfSmall(true);
  PlacedPrimitive placed = placedAs(row, kStill);
  placed.movesWithJitter = false;
  const Columns around{13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26}; // the margin of the sides
  EXPECT_EQ(drawnOf(placed, {0.5f, 0.0f}), around);
  for (Vertex& vertex : row.vertices) vertex.position.z = 0.0f;
  placed.movesWithJitter = true;
  placed.clipFromVertex[3].z = 1.5f; // before the near plane
  EXPECT_EQ(drawnOf(placed, {0.5f, 0.0f}), around);
}

TEST(PartTriangles, OfFewAllAreDrawnOrNone) {
  Primitive row = rowOfSmall(true);
  row.indices.resize(3 * 17);
  PartTriangles triangles;
  EXPECT_FALSE(triangles.add(placedAs(row, kStill), sidesOfPart()).has_value()); // number 16 lies in the part
  row.indices.resize(3 * 13);
  EXPECT_TRUE(triangles.add(placedAs(row, kStill), sidesOfPart()).has_value());
  EXPECT_TRUE(triangles.isEmpty(0));
}

TEST(PartTriangles, LieWhereTheyAreDeformedTo) {
  Scene scene;
  scene.materials.emplace_back();
  Node& node = scene.nodes.emplace_back();
  node.mesh = node.firstWeight = 0;
  Primitive row = rowOfSmall(true);
  row.targets.assign(1, std::vector<MorphDelta>(row.vertices.size(), MorphDelta{.position = {20.0f, 0, 0}}));
  const Pose pose{{glm::mat4(1.0f)}, {0.5f}, 0.0};
  PlacedPrimitive placed = placedAs(row, scene.materials[0].wind);
  placed.deformer.emplace(scene, 0, row, pose, 0.0);
  EXPECT_EQ(drawnOf(placed, {}), (Columns{6, 7, 8, 9, 10, 11, 12, 13})); // by 10 px
}

} // namespace taa
