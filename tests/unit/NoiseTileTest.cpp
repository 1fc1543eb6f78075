// The tile of blue noise: every rank once, and no low frequencies.
#include "core/render/passes/NoiseTile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <set>

namespace taa {
namespace {

TEST(NoiseTile, HoldsEachRankOnce) {
  const Image tile = blueNoiseTile();
  std::set<float> values(tile.pixels.begin(), tile.pixels.end());
  ASSERT_EQ(values.size(), 1024u);
  EXPECT_EQ(*values.begin(), 0.5f / 1024.0f);
  EXPECT_EQ(*values.rbegin(), 1023.5f / 1024.0f);
  EXPECT_EQ(tile.pixels, blueNoiseTile().pixels);
}

/// Mean power of the waves whose length in cycles a tile lies in a range; white noise has 1/12 everywhere.
double power(const Image& tile, double from, double to) {
  double sum = 0.0;
  int count = 0;
  for (int v = -16; v < 16; ++v)
    for (int u = -16; u < 16; ++u) {
      const double frequency = std::hypot(u, v);
      if (frequency < from || frequency >= to) continue;
      std::complex<double> amplitude;
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
          amplitude +=
              (tile.at(x, y)[0] - 0.5) * std::polar(1.0, 2.0 * std::numbers::pi * (u * x + v * y) / 32.0);
      sum += std::norm(amplitude) / 1024.0;
      ++count;
    }
  return sum / count;
}

// Techniques: 20.2.
TEST(NoiseTile, HasItsPowerInHighFrequencies) {
  const Image tile = blueNoiseTile();
  EXPECT_LT(power(tile, 0.0, 4.0), 0.05 / 12.0);
  EXPECT_GT(power(tile, 12.0, 17.0), 1.0 / 12.0);
  // The same spread in time: moved on by the golden ratio, every 256 frames fill [0, 1) evenly (invariant
  // 64).
  std::set<double> values;
  for (int n = 0; n < 256; ++n) values.insert(std::fmod(tile.at(3, 5)[0] + 0.61803398875 * n, 1.0));
  int k = 0;
  for (const double value : values)
    EXPECT_NEAR(value, (k++ + 0.5) / 256.0, 1.6 / 256.0); // the three-gap theorem
}

} // namespace
} // namespace taa
