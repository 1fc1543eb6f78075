// Faults of the resolve, from the formula of each: history that is not swapped, read with jitter, bounded by
// two corners, and a color that is no number.
#include "core/settings/Parameters.h"
#include "tests/support/frames/ResolveTest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace taa {
namespace {

constexpr test::FrameShape kShape{
    .width = 12, .height = 8, .inputs = Precision::Full, .history = Precision::Full};

class ResolveFaultsTest : public test::ResolveTest {
 protected:
  static Settings with(const char* assignment) {
    Settings settings = test::bareSettings();
    applyAssignment(settings, assignment);
    return settings;
  }
};

// With α = ½ a picture at rest is c₂ = ½(s₂ + h): h is the color of frame 0, not of frame 1.
TEST_F(ResolveFaultsTest, HistoryThatIsNotSwappedIsTwoFramesOld) {
  Settings settings = with("fault.notSwapped=on");
  settings.weight.alpha = 0.5f;
  const auto resolvedOn = [&](float color, const History* previous, const Settings& used) {
    const FrameInputs inputs = test::upload(test::flatFrame(kShape, color), kShape);
    History out;
    pass().resolve(inputs, previous, used, out);
    return out;
  };
  const History first = resolvedOn(1.0f, nullptr, settings);
  const History second = resolvedOn(3.0f, &first, settings);
  EXPECT_EQ(second.color.download().at(4, 4)[0], 2.0f) << "½(3 + 1)";
  const History third = resolvedOn(8.0f, &second, settings);
  EXPECT_EQ(third.color.download().at(4, 4)[0], 4.5f) << "½(8 + 1), not ½(8 + 2)";
  const History fourth = resolvedOn(8.0f, &third, settings);
  EXPECT_EQ(fourth.color.download().at(4, 4)[0], 5.0f) << "½(8 + 2)";
  const Settings healthy = with("weight.alpha=0.5");
  const History clean = resolvedOn(3.0f, &first, healthy);
  EXPECT_FALSE(clean.stale) << "without the fault nothing is kept";
  EXPECT_EQ(resolvedOn(8.0f, &clean, healthy).color.download().at(4, 4)[0], 5.0f);
}

TEST_F(ResolveFaultsTest, HistoryIsReadWithTheLastFramesJitter) {
  twin::Inputs frame = test::stillFrame(kShape, 3);
  frame.lastJitterPx = {0.25f, -0.375f};
  const auto positionWith = [&](const Settings& settings) {
    return test::ResolveTest::expose(frame, kShape, settings).at(IntermediateId::historyPosition);
  };
  const Image right = positionWith(test::bareSettings()),
              wrong = positionWith(with("fault.historyJitter=on"));
  for (int y = 0; y < kShape.height; ++y)
    for (int x = 0; x < kShape.width; ++x) {
      EXPECT_EQ(wrong.at(x, y)[0], right.at(x, y)[0] + 0.25f);
      EXPECT_EQ(wrong.at(x, y)[1], right.at(x, y)[1] - 0.375f);
    }
}

// YCoCg of the lowest and of the highest RGB: of red beside blue the lower corner is (0, 0, 0), the higher
// (½, 0, −½).
TEST_F(ResolveFaultsTest, BoxOfTwoCornersCanBeUpsideDown) {
  twin::Inputs frame = test::flatFrame(kShape, 0.0f);
  for (int y = 0; y < kShape.height; ++y)
    for (int x = 0; x < kShape.width; ++x) frame.color.at(x, y)[x % 2 == 0 ? 0 : 2] = 1.0f;
  Settings settings = with("fault.boxCorners=on");
  settings.space.color = ColorSpace::YCoCg;
  const test::Exposed exposed = expose(frame, kShape, settings);
  const float* low = exposed.at(IntermediateId::boxMin).at(5, 4);
  const float* high = exposed.at(IntermediateId::boxMax).at(5, 4);
  EXPECT_EQ(low[0], 0.0f);
  EXPECT_EQ(high[0], 0.5f);
  EXPECT_EQ(high[1], 0.0f) << "between −½ and ½ in truth";
  EXPECT_EQ(high[2], -0.5f);
  EXPECT_GT(low[2], high[2]);
}

TEST_F(ResolveFaultsTest, NanGrowsByATexelInEachFrame) {
  const Settings settings = with("fault.nan=on");
  twin::Inputs frame = test::flatFrame(kShape, 1.0f);
  frame.color.at(6, 4)[1] = std::numeric_limits<float>::quiet_NaN();
  test::ResolveTest::advance(frame, kShape, settings);
  frame.color.at(6, 4)[1] = 1.0f;
  for (int grown = 0; grown < 3; ++grown) {
    for (int y = 0; y < kShape.height; ++y)
      for (int x = 0; x < kShape.width; ++x)
        EXPECT_EQ(std::isnan(frame.historyColor.at(x, y)[0]),
                  std::max(std::abs(x - 6), std::abs(y - 4)) <= grown)
            << x << ", " << y;
    const auto isNextNan = [&](int x) {
      const twin::PixelRecord record = twin::resolvePixel(frame, settings, x, 4);
      return std::isnan(twin::at(record, IntermediateId::resolved).x);
    };
    EXPECT_TRUE(isNextNan(6) && isNextNan(5 - grown)) << "the twin knows it, too";
    EXPECT_FALSE(isNextNan(4 - grown));
    test::ResolveTest::advance(frame, kShape, settings);
  }
}

// The program's own resolve catches what is no number.
TEST_F(ResolveFaultsTest, NanIsCaughtWithoutTheFault) {
  twin::Inputs frame = test::flatFrame(kShape, 1.0f);
  frame.color.at(6, 4)[1] = std::numeric_limits<float>::quiet_NaN();
  test::ResolveTest::advance(frame, kShape, test::bareSettings());
  EXPECT_TRUE(std::ranges::none_of(frame.historyColor.pixels, [](float value) { return std::isnan(value); }));
}

} // namespace
} // namespace taa
