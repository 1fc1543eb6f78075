// Planes of another size: the nearest value, by the places of pixels' centers.
#include "core/capture/decode/Nearest.h"

#include <gtest/gtest.h>

#include <vector>

namespace taa::capture {

// The center of the first of three pixels lies in the second of nine, not in the first.
TEST(Nearest, APixelTakesTheValueAtItsCenter) {
  const std::vector<int> nine = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(resized(nine, {9, 1}, {3, 1}, 1), (std::vector<int>{1, 4, 7}));
  EXPECT_EQ(resized(nine, {3, 3}, {1, 1}, 1), (std::vector<int>{4}));
  EXPECT_EQ(resized(nine, {3, 3}, {3, 3}, 1), nine);
}

TEST(Nearest, ALargerPictureRepeatsValues) {
  EXPECT_EQ(resized<int>({1, 2, 3, 4}, {2, 2}, {4, 2}, 1), (std::vector<int>{1, 1, 2, 2, 3, 3, 4, 4}));
  // The middle of five lies in the middle of three; the next to it, at 2.1 of 3, in the last.
  EXPECT_EQ(resized<int>({1, 2, 3}, {3, 1}, {5, 1}, 1), (std::vector<int>{1, 1, 2, 3, 3}));
  EXPECT_EQ(resized<int>({1, 2, 3, 4}, {2, 1}, {1, 1}, 2), (std::vector<int>{3, 4}))
      << "channels stay together";
}

} // namespace taa::capture
