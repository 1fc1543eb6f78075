// The line around pixels, edge by edge.
#include "core/doctor/Outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace taa::doctor {
namespace {

bool holds(const std::vector<OutlineEdge>& edges, const OutlineEdge& edge) {
  return std::find(edges.begin(), edges.end(), edge) != edges.end();
}

int lengthOf(const std::vector<OutlineEdge>& edges) {
  int length = 0;
  for (const OutlineEdge& edge : edges) length += edge.to.x - edge.from.x + edge.to.y - edge.from.y;
  return length;
}

} // namespace

TEST(Outline, OfARectangleIsItsFourSides) {
  const std::vector<OutlineEdge> edges = outlineOf({{2, 3, 7}, {3, 3, 7}, {4, 3, 7}});
  EXPECT_EQ(edges.size(), 4u);
  EXPECT_TRUE(holds(edges, {{3, 2}, {7, 2}}));
  EXPECT_TRUE(holds(edges, {{3, 5}, {7, 5}}));
  EXPECT_TRUE(holds(edges, {{3, 2}, {3, 5}}));
  EXPECT_TRUE(holds(edges, {{7, 2}, {7, 5}}));
}

TEST(Outline, GoesAroundHoles) {
  const std::vector<OutlineEdge> edges = outlineOf({{0, 0, 3}, {1, 0, 1}, {1, 2, 3}, {2, 0, 3}});
  EXPECT_EQ(edges.size(), 8u);
  EXPECT_TRUE(holds(edges, {{1, 1}, {2, 1}}));
  EXPECT_TRUE(holds(edges, {{1, 2}, {2, 2}}));
  EXPECT_TRUE(holds(edges, {{1, 1}, {1, 2}}));
  EXPECT_EQ(lengthOf(edges), 12 + 4);
}

TEST(Outline, KeepsPartsApart) {
  const std::vector<OutlineEdge> edges = outlineOf({{0, 0, 2}, {5, 0, 2}});
  EXPECT_EQ(edges.size(), 8u) << "rows between them are empty";
  EXPECT_EQ(lengthOf(edges), 2 * 6);
  EXPECT_TRUE(outlineOf({}).empty());
}

TEST(Outline, LiesBetweenPixelsThatAreInAndOthers) {
  std::set<std::pair<int, int>> pixels;
  std::vector<PixelRun> runs;
  std::minstd_rand random(7);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x)
      if (random() % 2 == 0) {
        pixels.insert({x, y});
        runs.push_back({y, x, x + 1});
      }
  int between = 0;
  for (int y = 0; y <= 12; ++y)
    for (int x = 0; x <= 12; ++x) {
      const bool here = pixels.contains({x, y});
      between +=
          (here != pixels.contains({x - 1, y}) ? 1 : 0) + (here != pixels.contains({x, y - 1}) ? 1 : 0);
    }
  EXPECT_EQ(lengthOf(outlineOf(runs)), between);
}

TEST(Outline, HasRunsOfPixelsInAnyOrder) {
  const std::vector<PixelRun> runs = runsOf({{4, 2}, {1, 1}, {2, 1}, {3, 2}, {1, 1}, {5, 1}});
  EXPECT_EQ(runs, (std::vector<PixelRun>{{1, 1, 3}, {1, 5, 6}, {2, 3, 5}}));
  EXPECT_TRUE(runsOf({}).empty());
}

} // namespace taa::doctor
