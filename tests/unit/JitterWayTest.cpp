// Jitter across the way the camera moves (manual J10).
#include "core/render/JitterWay.h"

#include "core/render/FrameClock.h"
#include "core/render/FrameRequest.h"
#include "core/render/Jitter.h"
#include "core/render/View.h"
#include "core/scene/builtin/SceneSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

namespace taa {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi; // of a turn
constexpr double kFloats = 2e-6;                    // what camera matrices of floats leave of an angle

/// A camera flown over `frames` frames, from a pose by frame.
FrameRequest flown(int frames, const std::function<CameraPose(int)>& pose) {
  CameraTrack track{"t", 0, {}};
  for (int frame = 0; frame < frames; ++frame) track.poses.push_back(pose(frame));
  FrameRequest request{.camera = "still", .jitter = {}, .inputs = {}};
  request.jitter.sequence = JitterSequence::Perpendicular;
  request.track = std::make_shared<const CameraTrack>(track);
  return request;
}

CameraPose turned(float yaw, float pitch) {
  return {.yaw = yaw, .pitch = pitch};
}

/// Angle of a way above the one to the right, radians.
double above(const glm::dvec2& way) {
  return std::atan2(-way.y, way.x);
}

TEST(JitterWay, PutsThePointsOverEachOtherWhereTheCameraPansToTheRight) {
  const Scene scene;
  const FrameRequest request =
      flown(20, [](int frame) { return turned(0.5f * static_cast<float>(frame), 0.0f); });
  for (int frame = 0; frame < 20; ++frame) {
    const glm::vec2 jitter = frameInfo(scene, request, frame).jitterPx;
    EXPECT_NEAR(jitter.x, 0.0f, kFloats);
    EXPECT_NEAR(jitter.y, frame % 2 == 0 ? 0.25f : -0.25f, kFloats) << "index 1 comes first";
  }
}

// Techniques: J10.
TEST(JitterWay, TurnsByAFifthOfTheAngleInEachFrame) {
  const Scene scene;
  // Up for 60 frames, then to the right.
  const FrameRequest request = flown(90, [](int frame) {
    return turned(0.5f * static_cast<float>(std::max(frame - 60, 0)),
                  -30.0f + 0.5f * static_cast<float>(std::min(frame, 60)));
  });
  EXPECT_EQ(jitterWay(scene, request, 0), kFirstWay);
  for (int frame = 1; frame <= 60; ++frame)
    EXPECT_NEAR(above(jitterWay(scene, request, frame)), kQuarter * (1.0 - std::pow(0.8, frame)), kFloats);
  const glm::vec2 jitter = frameInfo(scene, request, 60).jitterPx;
  EXPECT_NEAR(std::abs(jitter.x), 0.25f, kFloats);
  EXPECT_NEAR(jitter.y, 0.0f, kFloats);
  for (int frame = 61; frame < 90; ++frame)
    EXPECT_NEAR(above(jitterWay(scene, request, frame)), kQuarter * std::pow(0.8, frame - 60), kFloats);
}

TEST(JitterWay, FollowsAWayThatIsNeitherByItsDirection) {
  const Scene scene;
  // The camera moves to the left and down by 3 and 4, which at 1 m is its axis' way too.
  const FrameRequest request = flown(80, [](int frame) {
    const auto step = 0.001f * static_cast<float>(frame);
    return CameraPose{.position = {-3.0f * step, -4.0f * step, 0.0f}};
  });
  const glm::dvec2 way = jitterWay(scene, request, 79);
  EXPECT_NEAR(way.x, -0.6, 1e-5); // positions of floats, a thousandth apart
  EXPECT_NEAR(way.y, 0.8, 1e-5);
  const glm::vec2 jitter = frameInfo(scene, request, 79).jitterPx;
  EXPECT_NEAR(0.6f * jitter.x, 0.8f * jitter.y, 1e-5f) << "across: 3·x + 4·y = 0 with y up";
}

TEST(JitterWay, RestsWhileTheCameraDoes) {
  const Scene scene;
  const FrameRequest request =
      flown(6, [](int frame) { return turned(0.0f, 0.5f * static_cast<float>(frame)); });
  const glm::dvec2 left = jitterWay(scene, request, 5);
  EXPECT_NE(left, kFirstWay);
  for (const int frame : {6, 40, 300}) EXPECT_EQ(jitterWay(scene, request, frame), left);
}

// What rounding leaves of the way across is none: its direction would be any.
TEST(JitterWay, IsThatOfTheStartForACameraThatGoesStraightAhead) {
  const Scene scene;
  for (const float from : {0.0f, 7.3f, 150.0f}) {
    const FrameRequest request = flown(30, [&](int frame) {
      CameraPose pose = turned(31.0f, -17.0f);
      pose.position = from + 0.1f * static_cast<float>(frame) * forwardOf(pose);
      return pose;
    });
    EXPECT_EQ(jitterWay(scene, request, 29), kFirstWay) << from;
  }
  const Scene fan = openScene("builtin:fan");
  const FrameRequest dolly{.camera = "dolly", .jitter = {}, .inputs = {}};
  EXPECT_EQ(jitterWay(fan, dolly, 50), kFirstWay);
}

TEST(JitterWay, BeginsAgainAtACut) {
  Scene scene;
  scene.shot.cuts = {10};
  const FrameRequest request =
      flown(20, [](int frame) { return turned(0.0f, 0.5f * static_cast<float>(frame)); });
  EXPECT_NE(jitterWay(scene, request, 9), kFirstWay);
  EXPECT_EQ(jitterWay(scene, request, 10), kFirstWay);
  EXPECT_NEAR(above(jitterWay(scene, request, 11)), 0.2 * kQuarter, kFloats);
}

// Half a turn goes from x to y, whatever the signs of zeros.
TEST(JitterWay, TurnsHalfATurnOneWay) {
  const glm::dvec2 expected(std::cos(0.2 * std::numbers::pi), std::sin(0.2 * std::numbers::pi));
  for (const double zero : {0.0, -0.0}) {
    const glm::dvec2 way = turnedTowards({1.0, zero}, {-1.0, zero});
    EXPECT_NEAR(way.x, expected.x, 1e-15);
    EXPECT_NEAR(way.y, expected.y, 1e-15);
  }
}

TEST(JitterWay, TheViewKnowsTheJitterOfTheFrameBefore) {
  const Scene scene = openScene("builtin:fan");
  FrameRequest request = flown(12, [](int frame) { return turned(0.0f, 0.5f * static_cast<float>(frame)); });
  for (int frame = 1; frame < 12; ++frame)
    EXPECT_EQ(glm::vec2(viewAt(scene, request, frame).block.previousJitter),
              viewAt(scene, request, frame - 1).info.jitterPx);
  request.jitter.scale = 0.0f;
  EXPECT_EQ(viewAt(scene, request, 7).info.jitterPx, glm::vec2(0.0f));
}

} // namespace
} // namespace taa
