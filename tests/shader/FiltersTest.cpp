// The filters of history and of the current frame, measured on what the resolve exposes (invariants 26 to
// 33).
#include "core/taa/TaaPass.h"
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

using taa::HistoryFilter;
using taa::Image;
using taa::IntermediateId;
using taa::Settings;
using taa::Switch;
using taa::test::FrameShape;

namespace {

const FrameShape kShape{32, 12, taa::Precision::Full, taa::Precision::Full};

Settings filtered(HistoryFilter filter, Switch dering = Switch::Off) {
  Settings settings = taa::test::bareSettings();
  settings.history.filter = filter;
  settings.history.dering = dering;
  return settings;
}

using Picture = std::function<double(int x, int y)>;

Image gray(const Picture& picture) {
  Image image(kShape.width, kShape.height, 4);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        image.at(x, y)[channel] = static_cast<float>(picture(x, y));
  return image;
}

} // namespace

class FiltersTest : public taa::test::ResolveTest {
 protected:
  // History raw of a still scene that moves so that every pixel reads history (fx, fy) to its right and
  // below.
  static Image historyAt(const Picture& picture, float fx, float fy, const Settings& settings) {
    taa::twin::Inputs frame = taa::test::flatFrame(kShape, 0.0f);
    frame.historyColor = gray(picture);
    frame.historySurface = Image(kShape.width, kShape.height, 2);
    for (int y = 0; y < kShape.height; ++y)
      for (int x = 0; x < kShape.width; ++x) {
        frame.motion.at(x, y)[0] = -fx;
        frame.motion.at(x, y)[1] = -fy;
      }
    return expose(frame, kShape, settings).at(IntermediateId::historyRaw);
  }

  static Image currentOf(const Picture& picture, glm::vec2 jitterPx, float variance) {
    taa::twin::Inputs frame = taa::test::flatFrame(kShape, 0.0f);
    frame.color = gray(picture);
    frame.jitterPx = jitterPx;
    Settings settings = taa::test::bareSettings();
    settings.current.filter = taa::CurrentFilter::Gaussian;
    settings.current.variance = variance;
    return expose(frame, kShape, settings).at(IntermediateId::currentFiltered);
  }
};

TEST_F(FiltersTest, ReadHistoryUnchangedAtWholePixels) {
  const Picture picture = [](int x, int y) { return std::fmod(x * 7.31 + y * 3.17, 5.0); };
  const Image source = gray(picture);
  for (const HistoryFilter filter : {HistoryFilter::Bilinear, HistoryFilter::CatmullRom5}) {
    const Image read = historyAt(picture, 3.0f, 2.0f, filtered(filter));
    for (int y = 0; y < kShape.height - 2; ++y)
      for (int x = 0; x < kShape.width - 3; ++x)
        ASSERT_EQ(read.at(x, y)[0], source.at(x + 3, y + 2)[0]) << x << ", " << y;
  }
}

// Invariant 26: at f = ½ the weights are (−1, 9, 9, −1)/16; 16 on a pedestal of 16 shows them without
// rounding.
TEST_F(FiltersTest, CatmullRomHasItsWeightsHalfwayBetweenPixels) {
  const auto impulse = [](int x, int) { return x == 16 ? 32.0 : 16.0; };
  const Image read = historyAt(impulse, 0.5f, 0.0f, filtered(HistoryFilter::CatmullRom5));
  const std::map<int, float> expected{{13, 16.0f}, {14, 15.0f}, {15, 25.0f},
                                      {16, 25.0f}, {17, 15.0f}, {18, 16.0f}};
  for (const auto& [x, value] : expected) EXPECT_NEAR(read.at(x, 5)[0], value, 4e-6f) << x;
}

TEST_F(FiltersTest, CatmullRomReproducesParabolas) {
  const auto parabola = [](double x, int) { return 0.01 * x * x; };
  for (const float f : {0.125f, 0.25f, 0.5f, 0.8125f}) {
    const Image read = historyAt(parabola, f, 0.0f, filtered(HistoryFilter::CatmullRom5));
    for (int x = 2; x < kShape.width - 4; ++x)
      EXPECT_NEAR(read.at(x, 5)[0], parabola(x + static_cast<double>(f), 0), 2e-5) << x << " + " << f;
  }
}

// Invariant 28: without its corners the filter is off by 0.0061 px of a ramp at most.
TEST_F(FiltersTest, CatmullRomWithoutCornersKeepsARampWithinItsBound) {
  const auto ramp = [](int x, int) { return 1.0 * x; };
  double worst = 0.0;
  for (float fx = 0.0f; fx < 1.0f; fx += 0.0625f)
    for (float fy = 0.0f; fy < 1.0f; fy += 0.125f) {
      const Image read = historyAt(ramp, fx, fy, filtered(HistoryFilter::CatmullRom5));
      worst = std::max(worst,
                       std::abs(static_cast<double>(read.at(12, 5)[0]) - (12.0 + static_cast<double>(fx))));
    }
  EXPECT_LT(worst, 0.00609);
  EXPECT_GT(worst, 0.0055) << "corners are left out";
}

// Invariant 29, and 6.9: deringing keeps the value within the taps.
TEST_F(FiltersTest, CatmullRomOvershootsAnEdgeUnlessDeringed) {
  const auto edge = [](int x, int) { return x <= 16 ? 1.0 : 0.0; };
  double highest = 0.0, highestDeringed = 0.0;
  for (float f = 0.0f; f < 1.0f; f += 0.03125f) {
    const Image ringing = historyAt(edge, f, 0.0f, filtered(HistoryFilter::CatmullRom5));
    const Image deringed = historyAt(edge, f, 0.0f, filtered(HistoryFilter::CatmullRom5, Switch::On));
    for (int x = 0; x < kShape.width; ++x) {
      highest = std::max(highest, static_cast<double>(ringing.at(x, 5)[0]));
      highestDeringed = std::max(highestDeringed, static_cast<double>(deringed.at(x, 5)[0]));
      EXPECT_GE(ringing.at(x, 5)[0], 0.0f) << "negative lobes are cut off";
    }
  }
  EXPECT_NEAR(highest, 1.0741, 0.0005);
  EXPECT_EQ(highestDeringed, 1.0);
}

TEST_F(FiltersTest, BilinearMixesFourPixels) {
  const Picture picture = [](int x, int y) { return x * x + 10.0 * y * y; };
  const Image read = historyAt(picture, 0.25f, 0.5f, filtered(HistoryFilter::Bilinear));
  const auto mixed = [&](int x, int y) { return 0.75 * picture(x, y) + 0.25 * picture(x + 1, y); };
  for (int y = 0; y < kShape.height - 1; ++y)
    for (int x = 0; x < kShape.width - 1; ++x)
      EXPECT_EQ(read.at(x, y)[0], static_cast<float>(0.5 * mixed(x, y) + 0.5 * mixed(x, y + 1)))
          << "all products are exact";
}

TEST_F(FiltersTest, ReadTheBorderBeyondThePicture) {
  const auto picture = [](int x, int) { return x == 0 ? 3.0 : x == kShape.width - 1 ? 5.0 : 1.0; };
  for (const HistoryFilter filter : {HistoryFilter::Bilinear, HistoryFilter::CatmullRom5}) {
    EXPECT_EQ(historyAt(picture, -40.25f, 0.25f, filtered(filter)).at(10, 5)[0], 3.0f);
    EXPECT_EQ(historyAt(picture, 40.25f, 0.25f, filtered(filter)).at(10, 5)[0], 5.0f);
  }
}

// Invariant 31.
TEST_F(FiltersTest, TheGaussianHasThePublishedWeightsWithoutJitter) {
  const std::array<float, 9> weights = taa::currentFilterWeights({}, glm::vec2(0.0f));
  double total = 0.0;
  for (const float weight : weights) total += static_cast<double>(weight);
  EXPECT_NEAR(weights[4] / total, 0.68748, 1e-5);
  EXPECT_NEAR(weights[1] / total, 0.07083, 1e-5);
  EXPECT_NEAR(weights[0] / total, 0.00730, 1e-5);
  const auto impulse = [](int x, int y) { return x == 16 && y == 5 ? 1.0 : 0.0; };
  const Image response = currentOf(impulse, glm::vec2(0.0f), 0.22f);
  EXPECT_NEAR(response.at(16, 5)[0], 0.68748, 1e-5);
  EXPECT_NEAR(response.at(15, 5)[0], 0.07083, 1e-5);
  EXPECT_NEAR(response.at(17, 6)[0], 0.00730, 1e-5);
}

TEST_F(FiltersTest, TheGaussianTurnsToTheSampleNearestThePixelsCenter) {
  // Content moved right by 0.4 px: the sample at the pixel's left lies 1.4 px away, that at its right 0.6 px.
  const std::array<float, 9> weights = taa::currentFilterWeights({}, glm::vec2(0.4f, 0.0f));
  EXPECT_FLOAT_EQ(weights[3], static_cast<float>(std::exp(-1.4 * 1.4 / 0.44)));
  EXPECT_FLOAT_EQ(weights[5], static_cast<float>(std::exp(-0.6 * 0.6 / 0.44)));
  const taa::CurrentSettings center{taa::CurrentFilter::Center, 0.22f};
  EXPECT_EQ(taa::currentFilterWeights(center, glm::vec2(0.4f)),
            (std::array<float, 9>{0, 0, 0, 0, 1, 0, 0, 0, 0}));
}

// Invariant 33: pixel p holds what lies at p − j; the filter brings the ramp back towards where it was.
TEST_F(FiltersTest, TheGaussianUndoesPartOfTheJitter) {
  for (const float j : {-0.4f, 0.25f, 0.5f}) {
    const auto ramp = [j](int x, int) { return 10.0 + x - static_cast<double>(j); };
    const Image read = currentOf(ramp, glm::vec2(j, 0.0f), 0.22f);
    EXPECT_LT(std::abs(read.at(16, 5)[0] - 26.0f), 0.75f * std::abs(j)) << j;
  }
}
