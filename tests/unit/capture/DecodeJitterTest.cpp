// Jitter of every engine, for content that moves a quarter of a pixel to the right and an eighth up.
#include "core/base/Error.h"
#include "core/capture/decode/DecodedFrame.h"
#include "tests/unit/capture/CaptureFixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace taa::capture {
namespace {

constexpr glm::ivec2 kSize(200, 100);

struct Stated {
  const char* engine;
  glm::dvec2 jitter;
};
const std::vector<Stated> kStated = {
    {"taa-inspector", {0.25, -0.125}},
    {"unreal", {0.25, -0.125}},
    {"unity", {0.25, 0.125}},                       // T(2j/W, 2j/H), y up
    {"godot", {2 * 0.25 / 200, -2 * 0.125 / 100}},  // NDC, y down
    {"bevy", {-0.25, 0.125}},                       // where it samples
    {"three", {-0.25, 0.125}},                      // likewise
    {"babylon", {2 * 0.25 / 200, 2 * 0.125 / 100}}, // NDC, y up
    {"fsr", {0.25, -0.125}},
    {"xess", {0.25, -0.125}},
    {"streamline", {0.25, -0.125}},
    {"metalfx", {-0.25, 0.125}}, // back to the reference frame
    {"blender", {-0.25, 0.125}}, // where it samples
};

} // namespace

TEST(DecodeJitter, TakesWhatEachEngineStates) {
  for (const Stated& stated : kStated) {
    Manifest manifest = manifestLike(stated.engine, kSize, 3);
    const std::size_t late = manifest.conventions.jitter.delay == 1 ? 0 : 1;
    manifest.frames[late].jitter = stated.jitter;
    const glm::dvec2 px = decodeJitter(manifest, 1);
    EXPECT_NEAR(px.x, 0.25, 1e-15) << stated.engine;
    EXPECT_NEAR(px.y, -0.125, 1e-15) << stated.engine;
  }
  EXPECT_EQ(kStated.size(), startingPoints().size());
}

TEST(DecodeJitter, ADelayMovesItToAnotherFrame) {
  Manifest manifest = manifestOf({}, kSize, 3);
  for (std::size_t i = 0; i < 3; ++i) manifest.frames[i].jitter.x = 0.1 * static_cast<double>(i + 1);
  const auto all = [&](int delay) {
    manifest.conventions.jitter.delay = delay;
    std::vector<double> x;
    for (std::size_t i = 0; i < 3; ++i) x.push_back(decodeJitter(manifest, i).x);
    return x;
  };
  const double a = 0.1, b = 0.1 * 2.0, c = 0.1 * 3.0;
  EXPECT_EQ(all(0), (std::vector<double>{a, b, c}));
  EXPECT_EQ(all(1), (std::vector<double>{0.0, a, b}));
  EXPECT_EQ(all(-1), (std::vector<double>{b, c, 0.0}));
}

TEST(DecodeJitter, ThatOfTheFrameBeforeIsKnownButWhereHistoryStarts) {
  Manifest manifest = manifestOf({}, kSize, 3);
  manifest.frames[0].jitter = {0.25, 0.5};
  manifest.frames[1].jitter = {-0.25, 0.125};
  DecodedFrame frame = decode(manifest, 1, planesOf(manifest));
  EXPECT_EQ(frame.jitterPx, glm::vec2(-0.25f, 0.125f));
  EXPECT_EQ(frame.previousJitterPx, glm::vec2(0.25f, 0.5f));
  manifest.frames[1].cut = true;
  frame = decode(manifest, 1, planesOf(manifest));
  EXPECT_EQ(frame.previousJitterPx, frame.jitterPx);
}

TEST(DecodeJitter, ANumberThatIsNoneIsAnError) {
  Manifest manifest = manifestOf({}, kSize);
  manifest.frames[1].jitter.y = std::nan("");
  EXPECT_THROW(static_cast<void>(decodeJitter(manifest, 1)), Error);
}

} // namespace taa::capture
