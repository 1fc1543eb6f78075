// The resolve as a whole: constants stay, bad values go, averages are averages (invariants D to G).
#include "tests/support/frames/ResolveTest.h"

#include "core/base/Half.h"
#include "tests/support/CompareImages.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

using taa::Image;
using taa::IntermediateId;
using taa::Precision;
using taa::Settings;
using taa::test::bareSettings;
using taa::test::difference;
using taa::test::Exposed;
using taa::test::FrameShape;
using taa::test::ResolveTest;
using taa::test::Variant;

namespace {

FrameShape full(int width = 33, int height = 17) {
  return {width, height, Precision::Full, Precision::Full};
}

Image colorsOf(const Image& rgba) {
  Image rgb(rgba.width, rgba.height, 3);
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) std::copy_n(rgba.at(x, y), 3, rgb.at(x, y));
  return rgb;
}

Image filled(const FrameShape& shape, int channels, float value) {
  Image image(shape.width, shape.height, channels);
  std::ranges::fill(image.pixels, value);
  return image;
}

void setMotion(taa::twin::Inputs& frame, float x, float y) {
  for (int row = 0; row < frame.height(); ++row)
    for (int column = 0; column < frame.width(); ++column) {
      frame.motion.at(column, row)[0] = x;
      frame.motion.at(column, row)[1] = y;
    }
}

// Whether a history of that precision can hold the level at all.
bool canStore(Precision precision, float level) {
  const bool isUnorm = precision == Precision::Unorm8 || precision == Precision::Unorm10;
  return !isUnorm || level == 0.0f || level == 1.0f;
}

// α = max(1/(N+1), least); nothing else that changes colors.
Settings averaging(float least) {
  Settings settings = bareSettings();
  settings.weight.source = taa::AlphaSource::HistoryLength;
  settings.weight.minimum = least;
  return settings;
}

Settings constantAlpha(float alpha) {
  Settings settings = bareSettings();
  settings.weight.alpha = alpha;
  return settings;
}

} // namespace

// Invariant 60.
TEST_F(ResolveTest, KeepsAConstantImageThroughEveryOption) {
  for (const Variant& variant : taa::test::presetsAndChoices()) {
    const FrameShape shape = taa::test::shapeFor(variant.settings, {24, 16});
    for (const float level : {0.0f, 1e-4f, 1.0f, 1000.0f, 65504.0f}) {
      if (!canStore(variant.settings.history.precision, level)) continue;
      taa::twin::Inputs frame = taa::test::flatFrame(shape, taa::roundedToHalf(level));
      const Image expected = taa::test::flatFrame({24, 16}, taa::roundedToHalf(level)).color;
      for (int n = 0; n < 4; ++n) {
        frame.jitterPx = glm::vec2(0.3f - 0.2f * static_cast<float>(n), 0.45f);
        setMotion(frame, n % 2 ? 0.0f : 1.37f, -0.25f * static_cast<float>(n));
        advance(frame, shape, variant.settings);
        ASSERT_EQ(difference(frame.historyColor, expected), "")
            << "level " << level << ", frame " << n << ", " << variant.name;
      }
    }
  }
}

// Invariant 61.
TEST_F(ResolveTest, IsFiniteAndNotNegativeWhateverComesIn) {
  std::uint32_t seed = 40;
  for (const Variant& variant : taa::test::presetsAndChoices()) {
    const FrameShape shape = taa::test::shapeFor(variant.settings, {48, 32});
    taa::twin::Inputs frame = taa::test::randomFrame(shape, ++seed, true);
    for (float& value : frame.historyColor.pixels) // a history that never was resolved may hold anything
      if (std::fmod(value * 1e5f, 7.0f) < 1.0f) value = std::numeric_limits<float>::quiet_NaN();
    advance(frame, shape, variant.settings);
    for (const float value : frame.historyColor.pixels)
      ASSERT_TRUE(value >= 0.0f && value <= 65504.0f) << value << " with " << variant.name;
    for (int y = 0; y < shape.height; ++y)
      for (int x = 0; x < shape.width; ++x) {
        const float frames = frame.historySurface.at(x, y)[0];
        // As printed N is a variance, which is below 1.
        const bool isPrinted = variant.settings.blend.length == taa::LengthRule::VarianceAsPrinted;
        ASSERT_TRUE(frames >= (isPrinted ? 1e-9f : 1.0f) && frames < 1e9f)
            << frames << " with " << variant.name;
      }
  }
}

// Invariant 54.
// Techniques: 1.7.
TEST_F(ResolveTest, StartsWithTheFilteredColorAndOneFrame) {
  for (const Precision precision : {Precision::Half, Precision::Full}) {
    FrameShape shape;
    shape.history = precision;
    Settings settings;
    settings.history.precision = precision;
    taa::twin::Inputs frame = taa::test::randomFrame(shape, 50, true);
    frame.historyColor = {};
    frame.historySurface = {};
    const Exposed all = expose(frame, shape, settings);
    Image expected = all.at(IntermediateId::currentFiltered);
    if (precision == Precision::Half)
      for (float& value : expected.pixels) value = taa::roundedToHalf(value);
    EXPECT_EQ(difference(all.at(IntermediateId::resolved), expected), "");
    EXPECT_EQ(difference(all.at(IntermediateId::historyLength), filled(shape, 1, 1.0f)), "");
    EXPECT_EQ(difference(all.at(IntermediateId::rejectReason), filled(shape, 1, 1.0f)), "") << "no history";
  }
}

// Techniques: 1.7.
TEST_F(ResolveTest, ForgetsItsHistoryAtACut) {
  const FrameShape shape;
  taa::twin::Inputs frame = taa::test::randomFrame(shape, 51, true);
  taa::FrameInputs inputs = taa::test::upload(frame, shape);
  const taa::History poisoned = taa::test::uploadHistory(frame, shape);
  taa::History first, cut;
  pass().resolve(inputs, nullptr, {}, first);
  inputs.info.startsHistory = true;
  pass().resolve(inputs, &poisoned, {}, cut);
  EXPECT_EQ(difference(cut.color.download(), first.color.download()), "");
  EXPECT_EQ(difference(cut.surface.download(), first.surface.download()), "");
}

// Invariant 25.
// Techniques: 13.17.
TEST_F(ResolveTest, RestartsWhatComesFromOffTheScreenOrNowhere) {
  const FrameShape shape = full();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  struct Case {
    float x, y, reason;
  };
  for (const Case& wanted :
       {Case{40.0f, 0.0f, 3.0f}, Case{0.0f, -40.0f, 3.0f}, Case{nan, 0.0f, 3.0f}, Case{0.0f, infinity, 3.0f},
        Case{taa::kNoPreviousPosition, taa::kNoPreviousPosition, 2.0f}}) {
    taa::twin::Inputs frame = taa::test::stillFrame(shape, 52);
    frame.historyColor = filled(shape, 4, 1000.0f);
    frame.historySurface = filled(shape, 2, 5.0f);
    setMotion(frame, wanted.x, wanted.y);
    Settings settings;
    settings.history.precision = Precision::Full;
    const Exposed all = expose(frame, shape, settings);
    EXPECT_EQ(difference(all.at(IntermediateId::rejectReason), filled(shape, 1, wanted.reason)), "");
    EXPECT_EQ(difference(all.at(IntermediateId::resolved), all.at(IntermediateId::currentFiltered)), "");
    EXPECT_EQ(difference(all.at(IntermediateId::historyLength), filled(shape, 1, 1.0f)), "");
  }
}

// Invariant 48: α = 1/t is the arithmetic mean.
TEST_F(ResolveTest, AveragesAllFramesOfAStillCamera) {
  const FrameShape shape = full();
  taa::twin::Inputs frame = taa::test::stillFrame(shape, 60);
  std::vector<double> sums(frame.color.pixels.size(), 0.0);
  for (int t = 1; t <= 64; ++t) {
    const taa::twin::Inputs next = taa::test::stillFrame(shape, 60 + static_cast<std::uint32_t>(t));
    frame.color = next.color;
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += static_cast<double>(frame.color.pixels[i]);
    advance(frame, shape, averaging(0.0f));
    Image mean = frame.color;
    for (std::size_t i = 0; i < sums.size(); ++i) mean.pixels[i] = static_cast<float>(sums[i] / t);
    // Relative to the brightest sample averaged, 2^15: each step rounds at the size of what it holds.
    EXPECT_EQ(difference(frame.historyColor, mean, 0x1p-20f), "") << "after " << t;
    // N goes through 1/(α² + (1 − α)²/N), a few roundings a frame.
    EXPECT_NEAR(frame.historySurface.pixels[0], t, 1e-5 * t);
  }
}

// Invariant 44: the exponential average, unrolled.
TEST_F(ResolveTest, FollowsTheClosedFormOfConstantAlpha) {
  const FrameShape shape = full(9, 5);
  const double alpha = static_cast<double>(0.1f);
  taa::twin::Inputs frame = taa::test::stillFrame(shape, 200);
  std::vector<Image> samples;
  for (int n = 0; n < 12; ++n) {
    frame.color = taa::test::stillFrame(shape, 200 + static_cast<std::uint32_t>(n)).color;
    samples.push_back(frame.color);
    advance(frame, shape, constantAlpha(0.1f));
    Image expected = frame.color;
    for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
      double value = std::pow(1.0 - alpha, n) * static_cast<double>(samples[0].pixels[i]);
      for (int k = 0; k < n; ++k)
        value += alpha * std::pow(1.0 - alpha, k) * static_cast<double>(samples[n - k].pixels[i]);
      expected.pixels[i] = static_cast<float>(value);
    }
    EXPECT_EQ(difference(frame.historyColor, expected, 1e-6f), "") << "frame " << n; // 12 roundings
  }
}

// Invariants 45 and 50.
TEST_F(ResolveTest, CountsTheSamplesAConstantAlphaAverages) {
  const FrameShape shape = full(5, 5);
  taa::twin::Inputs frame = taa::test::flatFrame(shape, 1.0f);
  const double alpha = 0.1;
  double before = 0.0;
  for (int n = 1; n <= 80; ++n) {
    advance(frame, shape, constantAlpha(0.1f));
    const double decayed = std::pow(1.0 - alpha, 2.0 * (n - 1));
    const double expected = 1.0 / (alpha * (1.0 - decayed) / (2.0 - alpha) + decayed);
    const auto frames = static_cast<double>(frame.historySurface.pixels[0]);
    EXPECT_NEAR(frames, expected, 1e-5 * expected) << "frame " << n;
    EXPECT_LE(frames, before + 1.0 + 1e-5) << "grows by one frame at most";
    before = frames;
  }
  EXPECT_NEAR(before, 19.0, 1e-4);
}

TEST_F(ResolveTest, CountsTheSamplesOfAnAverageWithAFloor) {
  const FrameShape shape = full(5, 5);
  taa::twin::Inputs frame = taa::test::flatFrame(shape, 1.0f);
  const std::map<int, double> expected{{1, 2.0},    {5, 6.0},    {8, 9.0},    {9, 10.0},
                                       {10, 10.99}, {15, 15.15}, {20, 17.45}, {30, 18.80}};
  for (int n = 0; n <= 30; ++n) {
    advance(frame, shape, averaging(0.1f));
    if (const auto found = expected.find(n); found != expected.end()) {
      EXPECT_NEAR(frame.historySurface.pixels[0], found->second, 0.006) << "frame " << n;
    }
  }
}

// Invariant 46.
TEST_F(ResolveTest, LosesAGhostAtTheRateOfAlpha) {
  const FrameShape shape = full(5, 5);
  taa::twin::Inputs frame = taa::test::flatFrame(shape, 0.0f);
  frame.historyColor = filled(shape, 4, 1.0f);
  frame.historySurface = filled(shape, 2, 5.0f);
  for (int n = 1; n <= 44; ++n) {
    advance(frame, shape, constantAlpha(0.1f));
    EXPECT_NEAR(frame.historyColor.pixels[0], std::pow(0.9, n), 1e-5);
  }
  EXPECT_LT(frame.historyColor.pixels[0], 0.01f) << "1 % after 44 frames";
}

// Invariants 55 and 56: a firefly of 100 on black.
TEST_F(ResolveTest, WeightsAFireflyDown) {
  const FrameShape shape = full(5, 5);
  taa::twin::Inputs frame = taa::test::flatFrame(shape, 100.0f);
  frame.historyColor = filled(shape, 4, 0.0f);
  frame.historySurface = filled(shape, 2, 5.0f);
  Settings settings = constantAlpha(0.1f);
  const Exposed plain = expose(frame, shape, settings);
  settings.blend.tone = taa::ToneWeight::Luma;
  const Exposed weighted = expose(frame, shape, settings);
  EXPECT_NEAR(plain.at(IntermediateId::resolved).pixels[0], 10.0, 1e-5);
  EXPECT_NEAR(weighted.at(IntermediateId::resolved).pixels[0], 0.10989, 1e-5);
  EXPECT_NEAR(weighted.at(IntermediateId::toneWeightCurrent).pixels[0], 1.0 / 101.0, 1e-8);
  EXPECT_EQ(weighted.at(IntermediateId::toneWeightHistory).pixels[0], 1.0f);
}

// Invariant 66.
// Techniques: 14.1.
TEST_F(ResolveTest, IsAPlainLerpWithEveryStageOff) {
  const FrameShape shape = full();
  taa::twin::Inputs frame = taa::test::stillFrame(shape, 70);
  frame.historyColor = taa::test::stillFrame(shape, 71).color;
  frame.historySurface = filled(shape, 2, 5.0f);
  const Exposed all = expose(frame, shape, constantAlpha(0.25f));
  Image expected = colorsOf(frame.historyColor);
  const Image current = colorsOf(frame.color);
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    const float step = 0.25f * (current.pixels[i] - expected.pixels[i]);
    expected.pixels[i] = expected.pixels[i] + step;
  }
  EXPECT_EQ(difference(all.at(IntermediateId::resolved), expected, isExact() ? 0.0f : 1e-6f), "");
}
