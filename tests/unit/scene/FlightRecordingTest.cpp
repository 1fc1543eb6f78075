// The way of a flown camera by a clock that the test sets.
#include "core/scene/camera/FlightRecording.h"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace {

using taa::CameraPose;
using taa::FlightRecording;
using Clock = FlightRecording::Clock;

Clock::time_point at(double seconds) {
  return Clock::time_point(std::chrono::hours(1)) +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

Clock::duration lasting(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

CameraPose poseAtX(double x) {
  CameraPose pose;
  pose.position.x = static_cast<float>(x);
  return pose;
}

FlightRecording begun(int firstFrame, int lastFrame, double framesPerSecond = 60.0) {
  FlightRecording recording(firstFrame, lastFrame, poseAtX(0.0), at(0.0));
  recording.setRate(framesPerSecond, at(0.0));
  return recording;
}

} // namespace

// Two units a second, told 62.5 times a second, as a timer of 16 ms does.
TEST(FlightRecording, FourSecondsHaveAPoseForEachFrameOfTheShot) {
  FlightRecording recording = begun(10, 1000);
  for (int tick = 1; tick <= 250; ++tick)
    recording.moveTo(poseAtX(0.032 * tick), at(0.016 * tick), lasting(0.016));
  EXPECT_EQ(recording.frameCount(at(4.0)), 241);
  EXPECT_FALSE(recording.isFull(at(4.0)));
  const std::vector<CameraPose> poses = recording.poses(at(4.0));
  ASSERT_EQ(poses.size(), 241u);
  for (int frame = 0; frame <= 240; ++frame)
    EXPECT_NEAR(poses[static_cast<std::size_t>(frame)].position.x, 2.0 * frame / 60.0, 1e-5) << frame;
}

// A window that was busy tells of eight moves in four seconds: the frames between them lie on the way.
TEST(FlightRecording, FramesThatWereSkippedLieOnTheWay) {
  FlightRecording recording = begun(0, 1000);
  for (int told = 1; told <= 8; ++told) recording.moveTo(poseAtX(told), at(0.5 * told), lasting(0.5));
  const std::vector<CameraPose> poses = recording.poses(at(4.0));
  ASSERT_EQ(poses.size(), 241u);
  for (int frame = 0; frame <= 240; ++frame)
    EXPECT_NEAR(poses[static_cast<std::size_t>(frame)].position.x, frame / 30.0, 1e-5) << frame;
}

TEST(FlightRecording, WaitingIsKept) {
  FlightRecording recording = begun(0, 1000);
  recording.moveTo(poseAtX(1.0), at(0.5), lasting(0.5));  // frames 0 to 30
  recording.moveTo(poseAtX(3.0), at(2.0), lasting(0.25)); // frames 105 to 120
  const std::vector<CameraPose> poses = recording.poses(at(3.0));
  ASSERT_EQ(poses.size(), 181u);
  for (int frame = 30; frame <= 105; ++frame)
    EXPECT_EQ(poses[static_cast<std::size_t>(frame)], poseAtX(1.0)) << frame;
  EXPECT_FLOAT_EQ(poses[112].position.x, 1.0f + 2.0f * 7.0f / 15.0f);
  for (int frame = 120; frame <= 180; ++frame)
    EXPECT_EQ(poses[static_cast<std::size_t>(frame)], poseAtX(3.0)) << frame;
}

TEST(FlightRecording, EndsWithTheShot) {
  FlightRecording recording = begun(100, 159);
  recording.moveTo(poseAtX(2.0), at(2.0), lasting(2.0));
  EXPECT_FALSE(recording.isFull(at(0.9)));
  EXPECT_TRUE(recording.isFull(at(0.99)));
  const std::vector<CameraPose> poses = recording.poses(at(2.0));
  ASSERT_EQ(poses.size(), 60u);
  EXPECT_NEAR(poses.back().position.x, 59.0 / 60.0, 1e-5);
}

// From 60 frames a second to 15: a quarter of the speed.
TEST(FlightRecording, GoesByTheSpeedOfTheShotsClock) {
  FlightRecording recording = begun(0, 1000);
  recording.setRate(15.0, at(1.0));
  EXPECT_EQ(recording.frameCount(at(3.0)), 60 + 30 + 1);
  recording.moveTo(poseAtX(4.0), at(3.0), lasting(2.0));
  const std::vector<CameraPose> poses = recording.poses(at(3.0));
  EXPECT_EQ(poses[60], poseAtX(0.0));
  EXPECT_FLOAT_EQ(poses[75].position.x, 2.0f);
}

TEST(FlightRecording, TurnsTheShorterWay) {
  FlightRecording recording = begun(0, 1000);
  CameraPose left, right;
  left.yaw = 175.0f;
  right.yaw = -175.0f;
  recording.moveTo(left, at(0.0), {});
  recording.moveTo(right, at(1.0), lasting(1.0));
  EXPECT_FLOAT_EQ(recording.poses(at(1.0))[30].yaw, 180.0f);
  EXPECT_EQ(recording.poses(at(1.0)).back(), right);
}
