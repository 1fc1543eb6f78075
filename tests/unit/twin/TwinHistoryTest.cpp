// History filters of the CPU twin (invariants 26, 28 to 30).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace taa::twin {
namespace {

constexpr HistorySettings kBilinear{HistoryFilter::Bilinear, Switch::Off, Precision::Full};
constexpr HistorySettings kCatmullRom{HistoryFilter::CatmullRom5, Switch::Off, Precision::Full};
constexpr HistorySettings kDeringed{HistoryFilter::CatmullRom5, Switch::On, Precision::Full};

Inputs withHistory(int width, int height, const glm::vec3& color) {
  Inputs inputs = test::constantInputs(width, height, glm::vec3(0.0f));
  test::setHistory(inputs, color, 4.0f);
  return inputs;
}

TEST(TwinHistory, CubicWeightsAreCatmullRoms) {
  EXPECT_EQ(catmullRomWeights(0.0f), (std::array<float, 4>{0.0f, 1.0f, 0.0f, 0.0f}));
  EXPECT_EQ(catmullRomWeights(0.5f), (std::array<float, 4>{-0.0625f, 0.5625f, 0.5625f, -0.0625f}));
  for (int i = 0; i <= 64; ++i) { // multiples of 1/64: every product is exact
    const float f = static_cast<float>(i) / 64.0f;
    const std::array<float, 4> w = catmullRomWeights(f);
    const std::array<float, 4> mirrored = catmullRomWeights(1.0f - f);
    EXPECT_EQ(w[0] + w[1] + w[2] + w[3], 1.0f);
    EXPECT_EQ(-w[0] + w[2] + 2.0f * w[3], f);
    EXPECT_EQ(w[0] + w[2] + 4.0f * w[3], f * f);
    EXPECT_GE(w[1] + w[2], 1.0f);
    EXPECT_LE(w[1] + w[2], 1.125f);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(w[k], mirrored[3 - k]);
  }
}

// Manual 6.4c: Σw = 1, so a constant stays without a division, and a ramp is off by half of what its share
// of the corners is.
// Techniques: 6.4c.
TEST(TwinHistory, CornersFromTheirNeighborsKeepConstantsAndRampsNearly) {
  const HistorySettings settings{HistoryFilter::CatmullRom5Corners, Switch::Off, Precision::Full};
  const Inputs constant = withHistory(8, 8, glm::vec3(0.7f));
  Inputs ramp = withHistory(8, 8, glm::vec3(0.0f));
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      test::setColor(ramp.historyColor, x, y, glm::vec3(static_cast<float>(x) + 0.5f, 0.0f, 0.0f));
  float worst = 0.0f;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const float fx = static_cast<float>(i) / 64.0f, fy = static_cast<float>(j) / 64.0f;
      const glm::vec2 q(3.5f + fx, 3.5f + fy);
      ASSERT_EQ(sampleHistory(constant, settings, q, {3, 3}).color, glm::vec3(0.7f));
      const std::array<float, 4> wx = catmullRomWeights(fx), wy = catmullRomWeights(fy);
      const float expected = q.x + 0.5f * (wy[0] + wy[3]) * (wx[2] / (wx[1] + wx[2]) - fx);
      const float read = sampleHistory(ramp, settings, q, {3, 3}).color.x;
      ASSERT_NEAR(read, expected, 2e-6f) << fx << ", " << fy; // a few roundings of 4
      worst = std::max(worst, std::fabs(read - q.x));
    }
  }
  EXPECT_NEAR(worst, 0.00278f, 1e-5f) << "less than half of the 0.00608 without the corners (invariant 28)";
}

TEST(TwinHistory, FiveTapsOfTheCubicAreCatmullRomsAtOneHalf) {
  Inputs inputs = withHistory(8, 8, glm::vec3(0.0f));
  for (int k = 0; k < 64; ++k)
    test::setColor(inputs.historyColor, k % 8, k / 8, glm::vec3(static_cast<float>((k * 37) % 64) / 64.0f));
  HistorySettings cubic{HistoryFilter::Cubic5, Switch::Off, Precision::Full};
  float difference = 0.0f;
  for (int i = 0; i < 64; ++i) {
    const glm::vec2 q(3.5f + static_cast<float>(i) / 64.0f, 3.5f + static_cast<float>((i * 29) % 64) / 64.0f);
    cubic.sharpness = 0.5f;
    const float expected = sampleHistory(inputs, kCatmullRom, q, {3, 3}).color.x;
    EXPECT_NEAR(sampleHistory(inputs, cubic, q, {3, 3}).color.x, expected, 1e-6f);
    cubic.sharpness = 0.35f;
    difference = std::max(difference, std::fabs(sampleHistory(inputs, cubic, q, {3, 3}).color.x - expected));
  }
  EXPECT_GT(difference, 0.01f);
}

// Manual §26, D13.
// Techniques: D13.
TEST(TwinHistory, AsHdrpPrintsItTheRightTapComesFromTheRowAbove) {
  HistorySettings cubic{HistoryFilter::Cubic5, Switch::Off, Precision::Full};
  HistorySettings printed = cubic;
  printed.filter = HistoryFilter::Cubic5AsPrinted;
  const glm::vec2 q(3.75f, 3.75f); // texel (3, 3) and a quarter: the corner is (5, 2)
  Inputs inputs = withHistory(8, 8, glm::vec3(1.0f));
  EXPECT_EQ(sampleHistory(inputs, printed, q, {3, 3}).color, glm::vec3(1.0f));
  test::setColor(inputs.historyColor, 5, 2, glm::vec3(2.0f));
  const std::array<float, 4> w = catmullRomWeights(0.25f);
  const float both = w[1] + w[2], corners = (w[0] + w[3]) * (w[0] + w[3]);
  EXPECT_EQ(sampleHistory(inputs, cubic, q, {3, 3}).color.x, 1.0f) << "corners are not read";
  EXPECT_NEAR(sampleHistory(inputs, printed, q, {3, 3}).color.x, 1.0f + w[3] * both / (1.0f - corners),
              1e-6f);
  Inputs columns = withHistory(8, 8, glm::vec3(0.0f));
  for (int k = 0; k < 64; ++k)
    test::setColor(columns.historyColor, k % 8, k / 8, glm::vec3(static_cast<float>(k % 8)));
  EXPECT_EQ(sampleHistory(columns, printed, q, {3, 3}).color, sampleHistory(columns, cubic, q, {3, 3}).color)
      << "rows alike: the wrong row does not show";
}

// Manual 6.8.
// Techniques: 6.8.
TEST(TwinHistory, ReadsOneTapWhereDepthHasAnEdge) {
  Inputs inputs = withHistory(12, 8, glm::vec3(0.0f));
  for (int k = 0; k < 96; ++k)
    test::setColor(inputs.historyColor, k % 12, k / 12, glm::vec3(static_cast<float>((k * 37) % 96)));
  const HistorySettings always = kCatmullRom;
  HistorySettings settings = kCatmullRom;
  settings.bilinearAtEdges = Switch::On;
  settings.edgeDepth = 0.1f;
  const auto isEdge = [&](int x) { return sampleHistory(inputs, settings, {3.7f, 3.3f}, {x, 4}).isEdge; };
  const auto setLeft = [&inputs](float depth) {
    for (int k = 0; k < 96; ++k) inputs.depth.at(k % 12, k / 12)[0] = k % 12 < 6 ? depth : 0.1f; // right: 1 m
  };
  for (const float left : {0.2f, 0.112f, 0.05f, 0.0f}) { // 0.5 m, 0.89 m, 2 m, the sky
    setLeft(left);
    for (int x = 0; x < 12; ++x) EXPECT_EQ(isEdge(x), x == 5 || x == 6) << left << ", " << x;
  }
  EXPECT_EQ(sampleHistory(inputs, settings, {3.7f, 3.3f}, {5, 4}).color,
            bilinearHistory(inputs, {3.7f, 3.3f}));
  EXPECT_EQ(sampleHistory(inputs, settings, {3.7f, 3.3f}, {4, 4}).color,
            sampleHistory(inputs, always, {3.7f, 3.3f}, {4, 4}).color);
  setLeft(0.11f); // 0.909 m: 9 % of the farthest
  for (int x = 0; x < 12; ++x) EXPECT_FALSE(isEdge(x)) << x;
  for (float& depth : inputs.depth.pixels) depth = 0.0f;
  EXPECT_FALSE(isEdge(5)) << "sky beside sky";
}

TEST(TwinHistory, BilinearMixesTheFourTexelsAround) {
  Inputs inputs = withHistory(2, 2, glm::vec3(0.0f));
  test::setColor(inputs.historyColor, 1, 0, glm::vec3(4.0f));
  test::setColor(inputs.historyColor, 0, 1, glm::vec3(8.0f));
  test::setColor(inputs.historyColor, 1, 1, glm::vec3(16.0f));
  EXPECT_EQ(bilinearHistory(inputs, {0.5f, 0.5f}).x, 0.0f);
  EXPECT_EQ(bilinearHistory(inputs, {1.0f, 0.5f}).x, 2.0f);
  EXPECT_EQ(bilinearHistory(inputs, {1.0f, 1.0f}).x, 7.0f);
  EXPECT_EQ(bilinearHistory(inputs, {0.75f, 1.25f}).x, 7.75f); // ¼ of 1, ¾ of 10
  EXPECT_EQ(bilinearHistory(inputs, {-5.0f, 9.0f}).x, 8.0f);   // clamped to the edge
}

// Manual 5.4: what lies beyond the picture is black, and what is read near the border is mixed with it.
// Techniques: 5.4.
TEST(TwinHistory, ABlackBorderDarkensWhatIsReadAcrossIt) {
  Inputs inputs = withHistory(4, 4, glm::vec3(1.0f));
  const auto read = [&](HistoryFilter filter, HistoryBorder border, const glm::vec2& position) {
    HistorySettings settings{filter, Switch::Off, Precision::Full};
    settings.border = border;
    return sampleHistory(inputs, settings, position, {0, 0}).color.x;
  };
  for (const HistoryFilter filter :
       {HistoryFilter::Point, HistoryFilter::Bilinear, HistoryFilter::CatmullRom5, HistoryFilter::CatmullRom9,
        HistoryFilter::CatmullRom16}) {
    EXPECT_EQ(read(filter, HistoryBorder::Edge, {0.25f, 2.5f}), 1.0f);
    EXPECT_EQ(read(filter, HistoryBorder::Black, {2.5f, 2.5f}), 1.0f) << "a texel's center";
    EXPECT_EQ(read(filter, HistoryBorder::Black, {-2.5f, 2.5f}), 0.0f) << "far outside";
  }
  EXPECT_EQ(read(HistoryFilter::Point, HistoryBorder::Black, {0.25f, 2.5f}), 1.0f);
  EXPECT_EQ(read(HistoryFilter::Bilinear, HistoryBorder::Black, {0.25f, 2.5f}), 0.75f);
  EXPECT_EQ(read(HistoryFilter::Bilinear, HistoryBorder::Black, {4.25f, 3.75f}), 0.25f * 0.75f);
  // At ¾ between the texels outside and inside; the weights of Catmull-Rom there of the two inside.
  const std::array<float, 4> w = catmullRomWeights(0.75f);
  EXPECT_NEAR(read(HistoryFilter::CatmullRom16, HistoryBorder::Black, {0.25f, 2.5f}), w[2] + w[3], 1e-6f);
}

// Bevy's slip (manual §26, D15): N of the pixel, whatever surface was there.
// Techniques: D15.
TEST(TwinHistory, AsBevyPrintsItNIsOfTheOwnPixel) {
  Inputs inputs = withHistory(8, 1, glm::vec3(0.5f));
  for (int x = 0; x < 8; ++x) inputs.historySurface.at(x, 0)[0] = static_cast<float>(x + 1);
  HistorySettings settings = kBilinear;
  EXPECT_EQ(sampleHistory(inputs, settings, {2.4f, 0.5f}, {6, 0}).historyLength, 3.0f);
  settings.length = LengthFrom::PixelAsPrinted;
  EXPECT_EQ(sampleHistory(inputs, settings, {2.4f, 0.5f}, {6, 0}).historyLength, 7.0f);
}

TEST(TwinHistory, BothFiltersReadATexelExactlyAtItsCenter) {
  Inputs inputs = withHistory(7, 7, glm::vec3(0.25f));
  test::setColor(inputs.historyColor, 3, 3, {1.0f, 2.0f, 3.0f});
  for (const HistorySettings& settings : {kBilinear, kCatmullRom, kDeringed}) {
    const HistorySample sample = sampleHistory(inputs, settings, {3.5f, 3.5f}, {3, 3});
    EXPECT_EQ(sample.color, glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(sample.historyLength, 4.0f);
  }
}

// Techniques: 6.4.
TEST(TwinHistory, NormalizedFiveTapsKeepConstantsExactlyAndRampsClosely) {
  Inputs constant = withHistory(8, 8, glm::vec3(0.7f));
  Inputs ramp = withHistory(8, 8, glm::vec3(0.0f));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      test::setColor(ramp.historyColor, x, y,
                     {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0.0f});
    }
  }
  float worst = 0.0f;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) {
      const glm::vec2 q(3.5f + static_cast<float>(i) / 100.0f, 3.5f + static_cast<float>(j) / 100.0f);
      ASSERT_EQ(sampleHistory(constant, kCatmullRom, q, {3, 3}).color, glm::vec3(0.7f));
      const glm::vec3 color = sampleHistory(ramp, kCatmullRom, q, {3, 3}).color;
      worst = std::max({worst, std::fabs(color.x - q.x), std::fabs(color.y - q.y)});
    }
  }
  EXPECT_NEAR(worst, 0.00608f, 1e-5f); // invariant 28, to the digits it gives
}

TEST(TwinHistory, OvershootsOnAStepUnlessDeringedAndNeverGoesBelowZero) {
  Inputs inputs = withHistory(8, 8, glm::vec3(0.0f));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 4; ++x) test::setColor(inputs.historyColor, x, y, glm::vec3(1.0f));
  }
  float highest = 0.0f;
  float lowest = 1.0f;
  for (int i = 0; i <= 3000; ++i) {
    const glm::vec2 q(1.5f + static_cast<float>(i) / 1000.0f, 3.5f); // rows are equal: one-dimensional
    const float plain = sampleHistory(inputs, kCatmullRom, q, {3, 3}).color.x;
    const float deringed = sampleHistory(inputs, kDeringed, q, {3, 3}).color.x;
    highest = std::max(highest, plain);
    lowest = std::min(lowest, plain);
    EXPECT_LE(deringed, 1.0f);
    EXPECT_GE(deringed, 0.0f);
  }
  EXPECT_NEAR(highest, 1.0741f, 1e-4f); // 1 + 2/27
  EXPECT_EQ(lowest, 0.0f);              // the undershoot of −2/27 is cut off
}

/// Spread, px², of a one-pixel bump of history after `frames` steps of half a pixel, nothing blended in.
double varianceAfter(int frames, HistoryFilter filter) {
  constexpr int kWidth = 64;       // a power of two: all arithmetic below is exact
  constexpr float kGround = 16.0f; // keeps negative lobes positive
  Inputs inputs = test::constantInputs(kWidth, 1, glm::vec3(kGround));
  for (int x = 0; x < kWidth; ++x) inputs.motion.at(x, 0)[0] = 0.5f;
  test::setHistory(inputs, glm::vec3(kGround), 1.0f);
  test::setColor(inputs.historyColor, 20, 0, glm::vec3(kGround + 1.0f));
  Settings settings = test::plainSettings();
  settings.history.filter = filter;
  settings.weight.alpha = 0.0f;
  for (int frame = 0; frame < frames; ++frame) test::advance(inputs, settings, 0, 0);
  double mass = 0.0;
  double mean = 0.0;
  double square = 0.0;
  for (int x = 0; x < kWidth; ++x) {
    const double bump = inputs.historyColor.at(x, 0)[0] - kGround;
    mass += bump;
    mean += bump * x;
    square += bump * x * x;
  }
  EXPECT_EQ(mass, 1.0);
  EXPECT_EQ(mean, 20.0 + 0.5 * frames);
  return square - mean * mean;
}

TEST(TwinHistory, BilinearAddsAQuarterSquarePixelPerHalfPixelStepAndCatmullRomNothing) {
  for (int frames = 1; frames <= 4; ++frames) {
    EXPECT_EQ(varianceAfter(frames, HistoryFilter::Bilinear), 0.25 * frames); // f(1 − f), invariant 30
    EXPECT_EQ(varianceAfter(frames, HistoryFilter::CatmullRom5), 0.0);
  }
}

TEST(TwinHistory, StoredGarbageBecomesBlackAndFarPositionsReadThePixelItself) {
  Inputs inputs = withHistory(4, 4, glm::vec3(0.5f));
  for (const float bad : {std::nanf(""), INFINITY, -INFINITY, -1.0f}) {
    for (int x = 0; x < 4; ++x) test::setColor(inputs.historyColor, x, 1, glm::vec3(bad));
    EXPECT_EQ(sampleHistory(inputs, kBilinear, {1.5f, 1.5f}, {1, 1}).color, glm::vec3(0.0f)) << bad;
    EXPECT_EQ(sampleHistory(inputs, kCatmullRom, {1.5f, 1.5f}, {1, 1}).color, glm::vec3(0.0f)) << bad;
  }
  EXPECT_EQ(sampleHistory(inputs, kBilinear, {2e6f, 0.5f}, {2, 3}).position, glm::vec2(2.5f, 3.5f));
  EXPECT_EQ(sampleHistory(inputs, kBilinear, {std::nanf(""), 0.5f}, {2, 3}).position, glm::vec2(2.5f, 3.5f));
}

TEST(TwinHistory, IsBlackAndEmptyWithoutHistory) {
  const Inputs inputs = test::constantInputs(4, 4, glm::vec3(1.0f));
  const HistorySample sample = sampleHistory(inputs, kDeringed, {1.5f, 1.5f}, {1, 1});
  EXPECT_EQ(sample.color, glm::vec3(0.0f));
  EXPECT_EQ(sample.historyLength, 0.0f);
}

} // namespace
} // namespace taa::twin
