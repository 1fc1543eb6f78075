// Pictures that are fetched where they are read.
#include "core/taa/twin/Texels.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

using taa::twin::Texels;

TEST(Texels, AreFetchedOnceInTilesOfTheirSide) {
  std::vector<std::array<int, 4>> fetched; // x, y, width, height
  const auto fetch = [&fetched](int x, int y, int width, int height) {
    fetched.push_back({x, y, width, height});
    taa::Image part(width, height, 1);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        *part.at(column, row) = static_cast<float>(100 * (y + row) + x + column);
    return part;
  };
  const Texels texels(10, 7, 1, fetch, 4);
  EXPECT_EQ(texels.texel(9, 6).x, 609.0f);
  EXPECT_EQ(texels.texel(8, 4).x, 408.0f);
  EXPECT_EQ(texels.texel(3, 1).x, 103.0f);
  EXPECT_EQ(fetched, (std::vector<std::array<int, 4>>{{8, 4, 2, 3}, {0, 0, 4, 4}}));
}
