// The neighborhood's box and the ways into it, measured on what the resolve exposes (invariants 34 to 40).
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

using taa::BoxKind;
using taa::Image;
using taa::RectifyMethod;
using taa::Settings;
using taa::Switch;
using taa::test::Exposed;
using taa::test::FrameShape;
using Id = taa::IntermediateId;

namespace {

const FrameShape kShape{48, 32, taa::Precision::Full, taa::Precision::Full};

// Scene-linear RGB is box space then, so that rectified colors compare with the box directly.
Settings linearRgb(RectifyMethod method, BoxKind box = BoxKind::Intersection) {
  Settings settings = taa::test::bareSettings();
  settings.rectify.method = method;
  settings.neighborhood.box = box;
  return settings;
}

void eachChannel(const std::function<void(int x, int y, int channel)>& visit) {
  for (int y = 0; y < kShape.height; ++y)
    for (int x = 0; x < kShape.width; ++x)
      for (int channel = 0; channel < 3; ++channel) visit(x, y, channel);
}

double distance(const float* a, const float* b) {
  double sum = 0.0;
  for (int channel = 0; channel < 3; ++channel)
    sum += std::pow(static_cast<double>(a[channel]) - static_cast<double>(b[channel]), 2.0);
  return std::sqrt(sum);
}

bool isInside(const float* color, const float* lo, const float* hi, float slack) {
  for (int channel = 0; channel < 3; ++channel) {
    const float room = slack * std::max(1.0f, std::abs(color[channel]));
    if (color[channel] < lo[channel] - room || color[channel] > hi[channel] + room) return false;
  }
  return true;
}

} // namespace

class BoxTest : public taa::test::ResolveTest {
 protected:
  // Colors within a few stops, a history unlike them: some of it inside the box, most outside.
  static taa::twin::Inputs frame(std::uint32_t seed) {
    taa::twin::Inputs made = taa::test::randomFrame(kShape, seed, false);
    std::ranges::fill(made.motion.pixels, 0.0f);
    for (Image* image : {&made.color, &made.historyColor})
      for (float& value : image->pixels) value = 4.0f * value / (1.0f + value);
    return made;
  }

  static Exposed exposed(const Settings& settings, std::uint32_t seed = 5) {
    return expose(frame(seed), kShape, settings);
  }

  // Black but for `bright` pixels of 1 in the middle's neighborhood, row-major; the middle pixel is (16, 16).
  static Exposed aroundTheMiddle(const std::vector<int>& bright, const Settings& settings) {
    taa::twin::Inputs made = taa::test::flatFrame(kShape, 0.0f);
    for (const int k : bright)
      for (int channel = 0; channel < 3; ++channel) made.color.at(15 + k % 3, 15 + k / 3)[channel] = 1.0f;
    return expose(made, kShape, settings);
  }
};

// Invariant 35.
TEST_F(BoxTest, KindsLieWithinOneAnother) {
  const Exposed minMax = exposed(linearRgb(RectifyMethod::None, BoxKind::MinMax));
  const Exposed both = exposed(linearRgb(RectifyMethod::None, BoxKind::Intersection));
  const Exposed variance = exposed(linearRgb(RectifyMethod::None, BoxKind::Variance));
  EXPECT_EQ(taa::test::difference(minMax.at(Id::boxMin), minMax.at(Id::neighborhoodMin)), "");
  EXPECT_EQ(taa::test::difference(minMax.at(Id::boxMax), minMax.at(Id::neighborhoodMax)), "");
  eachChannel([&](int x, int y, int channel) {
    const auto value = [&](const Exposed& from, Id id) { return from.at(id).at(x, y)[channel]; };
    EXPECT_GE(value(both, Id::boxMin), value(minMax, Id::boxMin));
    EXPECT_LE(value(both, Id::boxMax), value(minMax, Id::boxMax));
    EXPECT_GE(value(both, Id::boxMin), value(variance, Id::boxMin));
    EXPECT_LE(value(both, Id::boxMax), value(variance, Id::boxMax));
    EXPECT_LE(value(both, Id::boxMin), value(both, Id::neighborhoodMean));
    EXPECT_GE(value(both, Id::boxMax), value(both, Id::neighborhoodMean));
  });
}

TEST_F(BoxTest, HoldsTheFilteredColorWhenItShall) {
  Settings settings = linearRgb(RectifyMethod::None);
  settings.neighborhood.gamma = 0.1f;
  settings.current.filter = taa::CurrentFilter::Gaussian;
  const Exposed without = exposed(settings);
  settings.neighborhood.includeFiltered = Switch::On;
  const Exposed with = exposed(settings);
  int outside = 0;
  for (int y = 0; y < kShape.height; ++y)
    for (int x = 0; x < kShape.width; ++x) {
      const auto in = [&](const Exposed& from) {
        return isInside(from.at(Id::currentFiltered).at(x, y), from.at(Id::boxMin).at(x, y),
                        from.at(Id::boxMax).at(x, y), 0.0f);
      };
      EXPECT_TRUE(in(with)) << x << ", " << y;
      outside += in(without) ? 0 : 1;
    }
  EXPECT_GT(outside, 100) << "else the test shows nothing";
}

TEST_F(BoxTest, GrowsWithGamma) {
  Settings settings = linearRgb(RectifyMethod::None, BoxKind::Variance);
  Exposed smaller = exposed(settings);
  for (const float gamma : {1.25f, 2.0f, 4.0f}) {
    settings.neighborhood.gamma = gamma;
    Exposed larger = exposed(settings);
    eachChannel([&](int x, int y, int channel) {
      EXPECT_LE(larger.at(Id::boxMin).at(x, y)[channel], smaller.at(Id::boxMin).at(x, y)[channel]);
      EXPECT_GE(larger.at(Id::boxMax).at(x, y)[channel], smaller.at(Id::boxMax).at(x, y)[channel]);
    });
    smaller = std::move(larger);
  }
}

// Invariant 36: k bright of n.
TEST_F(BoxTest, HasTheMomentsOfAFewBrightPixels) {
  struct Case {
    std::vector<int> bright; // 4 is the pixel itself, 3 to 5 a line through it
    taa::NeighborhoodShape shape;
    double k, n, upper;
  };
  using enum taa::NeighborhoodShape;
  const Case cases[] = {{{4}, Cross, 1.0, 5.0, 0.6},
                        {{4}, Square3x3, 1.0, 9.0, 0.4254},
                        {{3, 4, 5}, Square3x3, 3.0, 9.0, 0.8047}};
  for (const Case& wanted : cases) {
    Settings settings = linearRgb(RectifyMethod::None, BoxKind::Variance);
    settings.neighborhood.shape = wanted.shape;
    const Exposed all = aroundTheMiddle(wanted.bright, settings);
    const auto middle = [&](Id id) { return static_cast<double>(all.at(id).at(16, 16)[0]); };
    EXPECT_NEAR(middle(Id::neighborhoodMean), wanted.k / wanted.n, 1e-6);
    EXPECT_NEAR(middle(Id::neighborhoodDeviation), std::sqrt(wanted.k * (wanted.n - wanted.k)) / wanted.n,
                1e-6);
    EXPECT_NEAR(middle(Id::boxMax), wanted.upper, 5e-5);
  }
}

// Invariant 37.
TEST_F(BoxTest, MeasuresSmallDeviationsOfBrightColors) {
  taa::twin::Inputs made = taa::test::flatFrame(kShape, 60000.0f);
  for (int y = 0; y < kShape.height; ++y)
    for (int x = 0; x < kShape.width; x += 3) made.color.at(x, y)[0] = 60001.0f; // one in three columns
  const Exposed all = expose(made, kShape, linearRgb(RectifyMethod::None));
  for (int x = 2; x < kShape.width - 2; ++x)
    EXPECT_NEAR(all.at(Id::neighborhoodDeviation).at(x, 9)[0], std::sqrt(2.0) / 3.0, 1e-5) << x;
}

// Invariant 34.
TEST_F(BoxTest, IsAPointWhereColorsAreEqual) {
  taa::twin::Inputs made = taa::test::flatFrame(kShape, 0.7f);
  made.historyColor = made.color;
  for (float& value : made.historyColor.pixels) value = value * 3.0f;
  made.historySurface = Image(kShape.width, kShape.height, 2);
  for (const auto& [method, shape] :
       {std::pair(RectifyMethod::Clamp, taa::NeighborhoodShape::Varying),
        std::pair(RectifyMethod::ClipToCenter, taa::NeighborhoodShape::Pairs),
        std::pair(RectifyMethod::ClipToFiltered, taa::NeighborhoodShape::Square3x3),
        std::pair(RectifyMethod::ClipToBoth, taa::NeighborhoodShape::Square3x3),
        std::pair(RectifyMethod::Select, taa::NeighborhoodShape::Square3x3)}) {
    Settings settings = linearRgb(method);
    settings.neighborhood.shape = shape;
    const Exposed all = expose(made, kShape, settings);
    eachChannel([&](int x, int y, int channel) {
      EXPECT_EQ(all.at(Id::neighborhoodDeviation).at(x, y)[channel], 0.0f);
      EXPECT_NEAR(all.at(Id::historyRectified).at(x, y)[channel], 0.7f, 1e-6f);
    });
  }
}

// Manual 8.7: columns 2k and 2k + 1 have the same samples, of columns 2k − 1 to 2k + 2.
TEST_F(BoxTest, PairsOfColumnsHaveTheSameBox) {
  taa::twin::Inputs made = taa::test::flatFrame(kShape, 0.0f);
  for (int y = 0; y < kShape.height; ++y)
    for (int x = 0; x < kShape.width; ++x) made.color.at(x, y)[0] = static_cast<float>(x);
  Settings settings = linearRgb(RectifyMethod::None, BoxKind::MinMax);
  settings.neighborhood.shape = taa::NeighborhoodShape::Pairs;
  const Exposed all = expose(made, kShape, settings);
  for (int x = 2; x < kShape.width - 2; ++x) {
    const int left = x - x % 2;
    EXPECT_EQ(all.at(Id::boxMin).at(x, 8)[0], static_cast<float>(left - 1)) << x;
    EXPECT_EQ(all.at(Id::boxMax).at(x, 8)[0], static_cast<float>(left + 2)) << x;
  }
}

// Manual 11.8.
TEST_F(BoxTest, SelectShowsOneOfTheNineBitForBit) {
  Settings settings; // balanced: the way through box space and back would change bits
  settings.rectify.method = RectifyMethod::Select;
  settings.validate.flicker = taa::Switch::Off; // which keeps history as it is
  const taa::twin::Inputs made = frame(5);
  const Exposed all = expose(made, kShape, settings);
  for (int y = 1; y < kShape.height - 1; ++y)
    for (int x = 1; x < kShape.width - 1; ++x) {
      const float* chosen = all.at(Id::historyRectified).at(x, y);
      int same = 0;
      for (int k = 0; k < 9; ++k)
        same += std::equal(chosen, chosen + 3, made.color.at(x + k % 3 - 1, y + k / 3 - 1));
      EXPECT_GE(same, 1) << x << ", " << y;
      const bool isKept = std::equal(chosen, chosen + 3, all.at(Id::historyRaw).at(x, y));
      EXPECT_EQ(*all.at(Id::clipAmount).at(x, y), isKept ? 0.0f : 1.0f); // black ones
    }
}

TEST_F(BoxTest, LeavesHistoryInsideUntouched) {
  for (const RectifyMethod method :
       {RectifyMethod::Clamp, RectifyMethod::ClipToCenter, RectifyMethod::ClipToFiltered}) {
    Settings settings; // balanced: the way through box space and back would change bits
    settings.rectify.method = method;
    settings.neighborhood.gamma = 4.0f;
    const Exposed all = exposed(settings);
    int kept = 0;
    for (int y = 0; y < kShape.height; ++y)
      for (int x = 0; x < kShape.width; ++x) {
        if (*all.at(Id::clipAmount).at(x, y) != 0.0f) continue;
        ++kept;
        for (int channel = 0; channel < 3; ++channel)
          EXPECT_EQ(all.at(Id::historyRectified).at(x, y)[channel], all.at(Id::historyRaw).at(x, y)[channel]);
      }
    EXPECT_GT(kept, 50) << "else the test shows nothing";
    EXPECT_LT(kept, kShape.width * kShape.height - 50);
  }
}

// Invariants 38 to 40.
TEST_F(BoxTest, EveryMethodEndsInTheBoxAndClampEndsNearest) {
  const Exposed clamped = exposed(linearRgb(RectifyMethod::Clamp));
  for (const RectifyMethod method :
       {RectifyMethod::Clamp, RectifyMethod::ClipToCenter, RectifyMethod::ClipToFiltered}) {
    const Exposed all = exposed(linearRgb(method));
    for (int y = 0; y < kShape.height; ++y)
      for (int x = 0; x < kShape.width; ++x) {
        const float* rectified = all.at(Id::historyRectified).at(x, y);
        const float* raw = all.at(Id::historyRaw).at(x, y);
        const float slack = method == RectifyMethod::Clamp ? 0.0f : 1e-5f;
        EXPECT_TRUE(isInside(rectified, all.at(Id::boxMin).at(x, y), all.at(Id::boxMax).at(x, y), slack));
        EXPECT_LE(distance(raw, clamped.at(Id::historyRectified).at(x, y)), distance(raw, rectified) + 1e-5);
        EXPECT_GE(*all.at(Id::clipAmount).at(x, y), 0.0f);
        EXPECT_LE(*all.at(Id::clipAmount).at(x, y), 1.0f + 1e-5f);
      }
  }
}

TEST_F(BoxTest, ClipsMoveHistoryStraightToTheirTarget) {
  for (const RectifyMethod method : {RectifyMethod::ClipToCenter, RectifyMethod::ClipToFiltered}) {
    const Exposed all = exposed(linearRgb(method));
    for (int y = 0; y < kShape.height; ++y)
      for (int x = 0; x < kShape.width; ++x) {
        const float amount = *all.at(Id::clipAmount).at(x, y);
        float farthest = 0.0f; // in units from the middle of the box to its wall
        for (int channel = 0; channel < 3; ++channel) {
          const float lo = all.at(Id::boxMin).at(x, y)[channel], hi = all.at(Id::boxMax).at(x, y)[channel];
          const float raw = all.at(Id::historyRaw).at(x, y)[channel];
          const float rectified = all.at(Id::historyRectified).at(x, y)[channel];
          const float filtered = all.at(Id::currentFiltered).at(x, y)[channel];
          const float target =
              method == RectifyMethod::ClipToCenter ? 0.5f * (lo + hi) : std::min(std::max(filtered, lo), hi);
          EXPECT_NEAR(rectified, raw + amount * (target - raw), 1e-5f) << "on the way from history to target";
          if (hi > lo) farthest = std::max(farthest, std::abs(2.0f * rectified - (lo + hi)) / (hi - lo));
        }
        if (amount > 0.0f && amount < 1.0f) {
          EXPECT_NEAR(farthest, 1.0f, 1e-3f) << "on the wall, " << x << ", " << y;
        }
      }
  }
}

TEST_F(BoxTest, RectifyingTwiceIsRectifyingOnce) {
  for (const RectifyMethod method :
       {RectifyMethod::Clamp, RectifyMethod::ClipToCenter, RectifyMethod::ClipToFiltered}) {
    taa::twin::Inputs made = frame(6);
    const Exposed once = expose(made, kShape, linearRgb(method));
    for (int y = 0; y < kShape.height; ++y)
      for (int x = 0; x < kShape.width; ++x)
        std::copy_n(once.at(Id::historyRectified).at(x, y), 3, made.historyColor.at(x, y));
    const Exposed twice = expose(made, kShape, linearRgb(method));
    EXPECT_EQ(taa::test::difference(twice.at(Id::historyRectified), once.at(Id::historyRectified), 1e-5f),
              "");
  }
}

// Invariant 42 as the resolve uses it: box space and back is the identity, highlights and black included.
TEST_F(BoxTest, ColorsComeBackFromTheSpaceOfTheBox) {
  for (const taa::ColorSpace color : {taa::ColorSpace::Rgb, taa::ColorSpace::YCoCg})
    for (const taa::ToneSpace tone : {taa::ToneSpace::Linear, taa::ToneSpace::ReinhardLuma}) {
      Settings settings = linearRgb(RectifyMethod::ClipToFiltered, BoxKind::MinMax);
      settings.space = {color, tone};
      taa::twin::Inputs made = taa::test::flatFrame(kShape, 0.0f);
      // One color in each 4×4 block: in their centroids the box is a point, and history comes back as that.
      for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
          for (int channel = 0; channel < 3; ++channel)
            made.color.at(x, y)[channel] =
                std::exp2(static_cast<float>((x / 4 * 5 + y / 4 * 3 + channel * 4) % 17 - 8));
      made.historyColor = Image(kShape.width, kShape.height, 4);
      made.historySurface = Image(kShape.width, kShape.height, 2);
      const Exposed all = expose(made, kShape, settings);
      for (int y = 1; y < kShape.height; y += 4)
        for (int x = 1; x < kShape.width; x += 4)
          for (int channel = 0; channel < 3; ++channel) {
            const float expected = made.color.at(x, y)[channel];
            const float brightest = 256.0f;
            // 1 − L cancels where L is near 1, so errors grow with brightness there.
            EXPECT_NEAR(all.at(Id::historyRectified).at(x, y)[channel], expected, brightest * 1e-4f);
          }
    }
}
