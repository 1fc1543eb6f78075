// What counts as detail, on hand-made luma.
#include "core/doctor/frames/Detail.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace taa::doctor {

TEST(Detail, IsNotShading) {
  Image ramp(9, 9, 1);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x)
      *ramp.at(x, y) = 0.05f * static_cast<float>(x) + 0.02f * static_cast<float>(y);
  EXPECT_FALSE(hasDetail(ramp, 4, 4));
}

TEST(Detail, IsWhatStandsOutByTheLimit) {
  Image flat(9, 9, 1);
  // 25 pixels of which one is higher by h: it stands out by h · 24/25.
  *flat.at(4, 4) = 0.004f * 25.0f / 24.0f * 1.01f;
  EXPECT_TRUE(hasDetail(flat, 4, 4));
  *flat.at(4, 4) = 0.004f * 25.0f / 24.0f * 0.99f;
  EXPECT_FALSE(hasDetail(flat, 4, 4));
}

TEST(Detail, IsNotTheRimOfAPlainSurface) {
  Image halves(9, 9, 1);
  std::vector<RegionIndex> labels(81, 0);
  for (int y = 0; y < 9; ++y)
    for (int x = 5; x < 9; ++x) {
      *halves.at(x, y) = 0.5f;
      labels[static_cast<std::size_t>(9 * y + x)] = 1;
    }
  EXPECT_TRUE(hasDetail(halves, 4, 4));
  EXPECT_FALSE(hasDetail(halves, labels, 4, 4));
  EXPECT_FALSE(hasDetail(halves, labels, 5, 4));
  *halves.at(4, 4) = 0.1f;
  EXPECT_TRUE(hasDetail(halves, labels, 4, 4));
}

} // namespace taa::doctor
