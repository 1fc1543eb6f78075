// Geometric flicker (manual 13.9): thin lines that come and go before a wall at rest, in GLSL and on the
// CPU.
#include "tests/support/frames/Frames.h"
#include "tests/support/frames/ResolveTest.h"

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

using taa::Image;
using taa::IntermediateId;
using taa::Settings;
using taa::test::FrameShape;

namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr float kWall = 8.0f; // m

FrameShape shape() {
  return {kWidth, kHeight, taa::Precision::Full, taa::Precision::Full};
}

void setDepth(taa::twin::Inputs& frame, int x, int y, float depth) {
  *frame.depth.at(x, y) = 0.1f / depth;
  *frame.previousDepth.at(x, y) = depth;
}

/// Above and below, columns and rows that may hold a line, now or a frame ago or both; between, a block that
/// came and another one that went. History is dilated as frames are, by 3×3.
taa::twin::Inputs lines(unsigned seed) {
  std::mt19937 random(seed);
  taa::twin::Inputs frame = taa::test::flatFrame(shape(), 0.5f);
  for (float& value : frame.color.pixels) value = static_cast<float>(random() % 1024) / 512.0f;
  Image then(kWidth, kHeight, 1);
  const auto both = [&](int x, int y, bool isNow, bool wasThen, float depth) {
    if (isNow) setDepth(frame, x, y, depth);
    if (wasThen) *then.at(x, y) = depth;
  };
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) both(x, y, true, true, kWall);
  for (int x = 4; x < kWidth; x += 9)
    for (int y = 0; y < kHeight; ++y)
      if (y < 15 || y > 38) both(x, y, random() % 3 == 0, random() % 3 == 0, 2.0f);
  for (const int y : {5, 42})
    for (int x = 0; x < kWidth / 2; ++x) both(x, y, random() % 4 == 0, random() % 2 == 0, 3.0f);
  for (int y = 20; y < 34; ++y)
    for (int x = 6; x < 20; ++x) both(x, y, true, false, 4.0f), both(x + 30, y, false, true, 4.0f);
  frame.historyColor = Image(kWidth, kHeight, 4);
  for (float& value : frame.historyColor.pixels) value = static_cast<float>(random() % 1024) / 512.0f;
  frame.historySurface = Image(kWidth, kHeight, 2);
  frame.historyMotion = Image(kWidth, kHeight, 2);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      float nearest = kWall;
      for (int k = 0; k < 9; ++k)
        nearest = std::min(nearest, *then.at(std::clamp(x + k % 3 - 1, 0, kWidth - 1),
                                             std::clamp(y + k / 3 - 1, 0, kHeight - 1)));
      frame.historySurface.at(x, y)[0] = 4.0f;
      frame.historySurface.at(x, y)[1] = nearest;
      if (random() % 50 == 0) frame.historyMotion.at(x, y)[0] = 0.75f;
    }
  return frame;
}

} // namespace

class FlickerTest : public taa::test::ResolveTest {};

TEST_F(FlickerTest, IsWhatTheTwinSays) {
  for (const taa::DepthDirection direction : {taa::DepthDirection::Both, taa::DepthDirection::Nearer}) {
    Settings settings;
    settings.inputs.precision = settings.history.precision = taa::Precision::Full;
    settings.validate.depthDirection = direction;
    const taa::twin::Inputs frame = lines(7);
    const taa::test::Exposed exposed = expose(frame, shape(), settings);
    const Image& flicker = exposed.at(IntermediateId::geometricFlicker);
    EXPECT_GT(std::ranges::count(flicker.pixels, 1.0f), 20);
    EXPECT_GT(std::ranges::count(exposed.at(IntermediateId::rejectReason).pixels, 4.0f), 50);
    EXPECT_EQ(taa::test::differenceFromTwin(frame, settings, taa::test::resolveRows(exposed), isExact()), "");
  }
}

// Neither of the two blocks is a matter of jitter, however they came or went: all of them but their
// silhouettes, where a frame of the wall is in reach, starts anew. So no ghost lasts longer for what stood
// still before.
TEST_F(FlickerTest, IsNotWhatCameOrWentAsAWhole) {
  Settings settings;
  settings.inputs.precision = settings.history.precision = taa::Precision::Full;
  const taa::test::Exposed exposed = expose(lines(8), shape(), settings);
  for (int y = 22; y < 32; ++y)
    for (const int first : {8, 38})
      for (int x = first; x < first + 10; ++x) {
        EXPECT_EQ(*exposed.at(IntermediateId::geometricFlicker).at(x, y), 0.0f) << x << ' ' << y;
        EXPECT_EQ(*exposed.at(IntermediateId::rejectReason).at(x, y), 4.0f) << x << ' ' << y;
      }
}
