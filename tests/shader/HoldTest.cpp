// What rectification takes back: locks of thin features and luma that comes and goes
// (manual 11.7, 17.3, 17.4).
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"

#include <algorithm>
#include <vector>

using taa::Image;
using taa::IntermediateId;
using taa::Settings;
using taa::Switch;
using taa::test::Exposed;
using taa::test::FrameShape;

namespace {

constexpr int kWidth = 16, kHeight = 8;
constexpr int kLine = 7; // column of the thin line
constexpr int kRow = 4;

FrameShape shape() {
  return {kWidth, kHeight, taa::Precision::Full, taa::Precision::Full};
}

/// Gray `ground` at rest with columns of `line` from kLine on. No history.
taa::twin::Inputs lines(float ground, float line, int columns = 1) {
  taa::twin::Inputs frame = taa::test::flatFrame(shape(), ground);
  for (int y = 0; y < kHeight; ++y)
    for (int x = kLine; x < kLine + columns; ++x)
      for (int channel = 0; channel < 3; ++channel) frame.color.at(x, y)[channel] = line;
  return frame;
}

/// The picture of `to` becomes that of `from`; the history stays.
void show(taa::twin::Inputs& to, const taa::twin::Inputs& from) {
  to.color = from.color;
}

Settings locking() {
  Settings settings = taa::test::bareSettings();
  settings.neighborhood.box = taa::BoxKind::MinMax;
  settings.rectify.method = taa::RectifyMethod::Clamp;
  settings.rectify.locks = Switch::On;
  settings.rectify.lockFrames = 16.0f;
  settings.weight.alpha = 0.0f; // history is all that shows
  settings.weight.minimum = 0.0f;
  return settings;
}

float valueOf(const Exposed& seen, IntermediateId id, int x) {
  return *seen.at(id).at(x, kRow);
}

} // namespace

class HoldTest : public taa::test::ResolveTest {
 protected:
  static float exposed(const taa::twin::Inputs& frame, const Settings& settings, IntermediateId id,
                       int x = kLine) {
    return valueOf(expose(frame, shape(), settings), id, x);
  }
  /// A line that was seen in two frames: locked.
  static taa::twin::Inputs locked(const Settings& settings) {
    taa::twin::Inputs frame = lines(1.0f, 1.5f);
    for (int n = 0; n < 2; ++n) advance(frame, shape(), settings);
    return frame;
  }
};

// Techniques: 17.3.
TEST_F(HoldTest, ASecondSightLocksAThinLineAndNothingElse) {
  taa::twin::Inputs frame = lines(1.0f, 1.5f);
  advance(frame, shape(), locking());
  const Exposed seen = expose(frame, shape(), locking());
  for (int x = 0; x < kWidth; ++x) {
    EXPECT_EQ(valueOf(seen, IntermediateId::lockLife, x), x == kLine ? 2.0f : 0.0f) << x;
    EXPECT_EQ(valueOf(seen, IntermediateId::lock, x), x == kLine ? 1.0f : 0.0f) << x;
  }
}

TEST_F(HoldTest, LinesOfTwoPixelsAndFaintOnesAreNotThin) {
  for (const taa::twin::Inputs& picture : {lines(1.0f, 1.5f, 2), lines(1.0f, 1.33f)}) {
    taa::twin::Inputs frame = picture;
    advance(frame, shape(), locking());
    EXPECT_EQ(exposed(frame, locking(), IntermediateId::lockLife), 0.0f);
  }
  taa::twin::Inputs frame = lines(1.5f, 1.0f); // a dark one is
  advance(frame, shape(), locking());
  EXPECT_EQ(exposed(frame, locking(), IntermediateId::lockLife), 2.0f);
}

// The line is missed from now on: life falls by 1/16 a frame, four times which is what is taken back.
// Techniques: 11.7, 17.3.
TEST_F(HoldTest, ALockHoldsHistoryAndFades) {
  taa::twin::Inputs frame = locked(locking());
  const Image history = frame.historyColor;
  show(frame, lines(1.0f, 1.0f));
  for (int missed = 1; missed <= 18; ++missed) {
    frame.historyColor = history; // each frame by itself
    const Exposed seen = expose(frame, shape(), locking());
    const float life = missed < 16 ? 2.0f - static_cast<float>(missed) / 16.0f : 1.0f;
    const float share = std::min(4.0f * (life - 1.0f), 1.0f);
    if (missed <= 16) {
      EXPECT_EQ(valueOf(seen, IntermediateId::lockLife, kLine), life) << missed;
    }
    EXPECT_EQ(valueOf(seen, IntermediateId::lock, kLine), share) << missed;
    EXPECT_EQ(valueOf(seen, IntermediateId::historyRectified, kLine), 1.0f + 0.5f * share) << missed;
    EXPECT_EQ(valueOf(seen, IntermediateId::clipAmount, kLine), 1.0f - share) << missed;
    advance(frame, shape(), locking());
  }
  Settings without = locking();
  without.rectify.locks = Switch::Off;
  frame.historyColor = history;
  EXPECT_EQ(exposed(frame, without, IntermediateId::historyRectified), 1.0f);
}

TEST_F(HoldTest, AChangeOfShadingKillsALock) {
  const taa::twin::Inputs before = locked(locking());
  const float mean = (3.0f * 1.5f + 6.0f) / 9.0f;
  for (const float share : {0.55f, 0.52f}) { // 0.9⁶ = 0.531
    taa::twin::Inputs frame = before;
    show(frame, lines(share * mean, share * mean));
    EXPECT_EQ(exposed(frame, locking(), IntermediateId::lock), share > 0.53f ? 1.0f : 0.0f);
  }
}

TEST_F(HoldTest, RejectionKillsALock) {
  taa::twin::Inputs frame = locked(locking());
  show(frame, lines(1.0f, 1.0f));
  Settings settings = locking();
  settings.validate.depth = Switch::On;
  EXPECT_EQ(exposed(frame, settings, IntermediateId::lock), 1.0f);
  std::ranges::fill(frame.previousDepth.pixels, 9.0f);
  EXPECT_EQ(exposed(frame, settings, IntermediateId::rejectReason), 4.0f);
  EXPECT_EQ(exposed(frame, settings, IntermediateId::lock), 0.0f);
}

TEST_F(HoldTest, ALockDoesNotLeaveThePicture) {
  for (const float speed : {7.0f, 9.0f}) { // 7.5 + 9 is beyond 16
    taa::twin::Inputs frame = locked(locking());
    const float life = frame.historyLock.at(kLine, kRow)[0];
    EXPECT_EQ(life, 2.0f - 1.0f / 16.0f);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) frame.motion.at(x, y)[0] = speed;
    // Everything came from the left, where the border continues; so it has no lock but what it gets now.
    const taa::twin::Inputs line = lines(1.0f, 1.5f);
    show(frame, line);
    advance(frame, shape(), locking());
    EXPECT_EQ(frame.historyLock.at(kLine, kRow)[0], speed < 8.0f ? 1.0f - 1.0f / 16.0f : 0.0f);
  }
}

namespace {

Settings withInstability() {
  Settings settings = locking();
  settings.rectify.locks = Switch::Off;
  settings.rectify.instability = Switch::On;
  return settings;
}

} // namespace

// Techniques: 17.4.
TEST_F(HoldTest, LumaThatComesAndGoesIsUnstable) {
  struct Case {
    std::vector<float> scales; // of the picture, frame by frame
    float instability;         // in the last one
    const char* why;
  };
  for (const Case& wanted : {Case{{1.0f, 1.5f, 1.0f, 1.5f, 1.0f}, 1.0f, "period two"},
                             Case{{1.0f, 1.5f, 1.8f, 1.0f}, 1.0f, "period three"},
                             Case{{1.0f, 1.2f, 1.4f, 1.6f, 1.8f}, 0.0f, "rises"},
                             Case{{1.0f, 1.0f, 1.0f, 1.0f, 1.5f}, 0.0f, "changes once"},
                             Case{{1.0f, 1.0f, 1.0f, 1.0f, 1.0f}, 0.0f, "stays"},
                             Case{{1.5f, 1.5f, 1.0f, 1.5f}, 1.0f, "comes back"},
                             Case{{1.5f, 1.0f, 1.5f}, 0.0f, "not known for long enough"}}) {
    taa::twin::Inputs frame = lines(wanted.scales[0], 0.0f);
    for (std::size_t n = 0; n < wanted.scales.size(); ++n) {
      show(frame, lines(0.2f * wanted.scales[n], 0.6f * wanted.scales[n]));
      if (n + 1 < wanted.scales.size()) advance(frame, shape(), withInstability());
    }
    const Exposed seen = expose(frame, shape(), withInstability());
    EXPECT_EQ(valueOf(seen, IntermediateId::instability, kLine), wanted.instability) << wanted.why;
    EXPECT_EQ(valueOf(seen, IntermediateId::instability, 1), 0.0f) << "no contrast there, " << wanted.why;
  }
}

// Techniques: 17.4.
TEST_F(HoldTest, UnstableLumaKeepsItsHistory) {
  taa::twin::Inputs frame = lines(0.2f, 0.6f);
  for (const float scale : {1.0f, 1.5f, 1.0f, 1.5f, 1.0f}) {
    show(frame, lines(0.2f * scale, 0.6f * scale));
    advance(frame, shape(), withInstability());
  }
  for (float& value : frame.historyColor.pixels) value = 5.0f;
  show(frame, lines(0.3f, 0.9f));
  EXPECT_EQ(exposed(frame, withInstability(), IntermediateId::historyRectified), 5.0f);
  Settings without = withInstability();
  without.rectify.instability = Switch::Off;
  EXPECT_EQ(exposed(frame, without, IntermediateId::historyRectified), 0.9f);
}

// 11.7: 1 − √reactive of what a lock would take back.
TEST_F(HoldTest, WhatIsReactiveIsHeldLess) {
  taa::twin::Inputs frame = locked(locking());
  show(frame, lines(1.0f, 1.0f));
  frame.mask = Image(kWidth, kHeight, 2);
  const Exposed all = expose(frame, shape(), locking());
  EXPECT_EQ(valueOf(all, IntermediateId::historyRectified, kLine), 1.5f);
  for (std::size_t i = 0; i < frame.mask.pixels.size(); i += 2) frame.mask.pixels[i] = 1.0f;
  const Exposed none = expose(frame, shape(), locking());
  EXPECT_EQ(valueOf(none, IntermediateId::lock, kLine), 1.0f) << "the lock stays";
  EXPECT_EQ(valueOf(none, IntermediateId::historyRectified, kLine), 1.0f);
  for (std::size_t i = 0; i < frame.mask.pixels.size(); i += 2) frame.mask.pixels[i] = 64.0f / 255.0f;
  const Exposed half = expose(frame, shape(), locking());
  EXPECT_NEAR(valueOf(half, IntermediateId::historyRectified, kLine), 1.0f + 0.5f * (1.0f - 0.50098f), 1e-4f);
}

// 11.7: a tenth of what FSR2 accumulates is 0.1 / (0.74/12) frames.
// Techniques: 11.7.
TEST_F(HoldTest, ForgetsHistoryThatWasMoved) {
  taa::twin::Inputs frame = lines(1.0f, 1.0f);
  frame.historyColor = frame.color;
  frame.historySurface = Image(kWidth, kHeight, 2);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      frame.historySurface.at(x, y)[0] = 9.0f;
      if (x >= 8)
        for (int channel = 0; channel < 3; ++channel) frame.historyColor.at(x, y)[channel] = 2.0f;
    }
  Settings settings = taa::test::bareSettings();
  settings.rectify.method = taa::RectifyMethod::ClampForget;
  settings.weight.source = taa::AlphaSource::HistoryLength;
  settings.weight.minimum = 0.0f;
  const Exposed seen = expose(frame, shape(), settings);
  EXPECT_EQ(valueOf(seen, IntermediateId::historyKeptLength, 3), 9.0f);
  EXPECT_EQ(valueOf(seen, IntermediateId::alphaBase, 3), 0.1f);
  EXPECT_NEAR(valueOf(seen, IntermediateId::historyKeptLength, 12), 0.1 / (0.74 / 12.0), 1e-6);
  EXPECT_NEAR(valueOf(seen, IntermediateId::alphaBase, 12), 1.0 / (1.0 + 0.1 / (0.74 / 12.0)), 1e-6);
  EXPECT_EQ(valueOf(seen, IntermediateId::historyRectified, 12), 1.0f);
}
