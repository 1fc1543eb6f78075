// Verdicts over histories that are wrong on a known mask.
#include "core/verdict/parts/VerdictMaps.h"

#include "core/probe/SurfaceSteps.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

using taa::HistoryVerdict;
using taa::Image;
using taa::TreatedHistory;

namespace {

constexpr int kWide = 12, kHigh = 7;

Image gray(const std::function<float(int x, int y)>& value, int channels = 3) {
  Image image(kWide, kHigh, channels);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      for (int channel = 0; channel < channels; ++channel) image.at(x, y)[channel] = value(x, y);
  return image;
}

bool isPoisoned(int x, int y) {
  return (x + 2 * y) % 5 == 0;
}

/// As it should be but where it is poisoned; nothing was done.
TreatedHistory poisoned() {
  const Image raw = gray([](int x, int y) { return isPoisoned(x, y) ? 0.8f : 0.2f; });
  return {raw, raw, gray([](int, int) { return 0.2f; }), Image(kWide, kHigh, 1)};
}

void expectMap(const Image& map, HistoryVerdict inMask, HistoryVerdict outside) {
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      EXPECT_EQ(static_cast<HistoryVerdict>(*map.at(x, y)), isPoisoned(x, y) ? inMask : outside)
          << x << ", " << y;
}

} // namespace

TEST(VerdictMap, OfPoisonedHistoryIsAHistoryLetThroughExactlyThere) {
  expectMap(taa::verdictMap(poisoned()), HistoryVerdict::LetThrough, HistoryVerdict::RightlyKept);
}

TEST(VerdictMap, OfPoisonThatWasPulledAwayIsAHistoryRemoved) {
  TreatedHistory history = poisoned();
  history.rectified = gray([](int, int) { return 0.25f; });
  // 0.05 more than the history beside it is more than two steps, too.
  expectMap(taa::verdictMap(history), HistoryVerdict::Removed, HistoryVerdict::ThrownAway);
  history.rectified = history.reference;
  expectMap(taa::verdictMap(history), HistoryVerdict::Removed, HistoryVerdict::RightlyKept);
}

TEST(VerdictMap, CountsRejectionAsDone) {
  TreatedHistory history = poisoned();
  for (float& reason : history.rejectReason.pixels) reason = 4.0f;
  expectMap(taa::verdictMap(history), HistoryVerdict::Removed, HistoryVerdict::ThrownAway);
  for (float& reason : history.rejectReason.pixels) reason = 1.0f;
  expectMap(taa::verdictMap(history), HistoryVerdict::RightlyKept, HistoryVerdict::RightlyKept);
}

TEST(VerdictMap, LooksAtWhatIsShown) {
  // On the straight part of sRGB: 12.92 times as large; above white nothing is seen.
  constexpr float kStep = 1.0f / 255.0f / 12.92f;
  const auto verdictOf = [](float raw, float reference) {
    const Image history = gray([raw](int, int) { return raw; });
    const Image map = taa::verdictMap(
        {history, history, gray([reference](int, int) { return reference; }), Image(kWide, kHigh, 1)});
    return static_cast<HistoryVerdict>(map.pixels[0]);
  };
  EXPECT_EQ(verdictOf(7.9f * kStep, 0.0f), HistoryVerdict::RightlyKept);
  EXPECT_EQ(verdictOf(8.1f * kStep, 0.0f), HistoryVerdict::LetThrough);
  EXPECT_EQ(verdictOf(0.0f, 8.1f * kStep), HistoryVerdict::LetThrough);
  EXPECT_EQ(verdictOf(9.0f, 1.0f), HistoryVerdict::RightlyKept);
}

TEST(VerdictMap, LooksAtEachChannel) {
  TreatedHistory history = poisoned();
  history.raw = history.rectified = history.reference;
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      if (isPoisoned(x, y)) history.raw.at(x, y)[2] = history.rectified.at(x, y)[2] = 0.0f;
  expectMap(taa::verdictMap(history), HistoryVerdict::LetThrough, HistoryVerdict::RightlyKept);
}

TEST(GeometryVerdict, ComparesReasonsWithWhatWasSeen) {
  const Image positions = [] {
    Image image(kWide, kHigh, 2);
    for (int y = 0; y < kHigh; ++y)
      for (int x = 0; x < kWide; ++x) {
        image.at(x, y)[0] = static_cast<float>(x) + 0.5f;
        image.at(x, y)[1] = static_cast<float>(y) + 0.5f;
      }
    return image;
  }();
  Image steps(kWide, kHigh, taa::kStepChannels);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      if (isPoisoned(x, y)) steps.at(x, y)[0] = std::numeric_limits<float>::quiet_NaN();
  const Image kept(kWide, kHigh, 1), rejected = gray([](int, int) { return 6.0f; }, 1);
  const Image none = gray([](int, int) { return 1.0f; }, 1);
  expectMap(taa::geometryVerdict(kept, positions, steps), HistoryVerdict::LetThrough,
            HistoryVerdict::RightlyKept);
  expectMap(taa::geometryVerdict(rejected, positions, steps), HistoryVerdict::Removed,
            HistoryVerdict::ThrownAway);
  expectMap(taa::geometryVerdict(none, positions, steps), HistoryVerdict::RightlyKept,
            HistoryVerdict::RightlyKept);
  expectMap(taa::geometryVerdict(kept, positions, {}), HistoryVerdict::RightlyKept,
            HistoryVerdict::RightlyKept);
}

TEST(GeometryVerdict, NeedsRejectionWhereHistoryIsReadBesideTheSurface) {
  Image positions(1, 1, 2), steps(1, 1, taa::kStepChannels);
  const auto verdictOf = [&](float x, float step) {
    positions.at(0, 0)[0] = x;
    positions.at(0, 0)[1] = 0.5f;
    steps.at(0, 0)[0] = step;
    return static_cast<HistoryVerdict>(taa::geometryVerdict(Image(1, 1, 1), positions, steps).pixels[0]);
  };
  EXPECT_EQ(verdictOf(0.5f, 0.25f), HistoryVerdict::RightlyKept);
  EXPECT_EQ(verdictOf(0.5f, 2.0f), HistoryVerdict::LetThrough) << "it came from the left";
  EXPECT_EQ(verdictOf(-1.5f, 2.0f), HistoryVerdict::RightlyKept) << "and is read there";
  steps.at(0, 0)[3] = 1.0f;
  EXPECT_EQ(verdictOf(-1.5f, 2.0f), HistoryVerdict::LetThrough) << "where something else was in front";
}
