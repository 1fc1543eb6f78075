#include "core/scene/camera/FlightRecording.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace taa {

namespace {

/// On the straight way from one to the other; turns go the shorter way round.
CameraPose between(const CameraPose& from, const CameraPose& to, double part) {
  const auto share = static_cast<float>(part);
  CameraPose pose;
  pose.position = from.position + share * (to.position - from.position);
  pose.yaw = from.yaw + share * std::remainder(to.yaw - from.yaw, 360.0f);
  pose.pitch = from.pitch + share * (to.pitch - from.pitch);
  pose.fovY = from.fovY + share * (to.fovY - from.fovY);
  return pose;
}

} // namespace

FlightRecording::FlightRecording(int firstFrame, int lastFrame, const CameraPose& pose,
                                 Clock::time_point begins)
    : firstFrame_(firstFrame), lastFrame_(lastFrame), moves_{{0.0, 0.0, pose}}, since_(begins) {
  assert(firstFrame >= 0 && lastFrame >= firstFrame);
}

double FlightRecording::position(Clock::time_point time) const {
  const double seconds = std::chrono::duration<double>(time - since_).count();
  return positionSince_ + std::max(seconds, 0.0) * framesPerSecond_;
}

void FlightRecording::setRate(double framesPerSecond, Clock::time_point now) {
  positionSince_ = position(now);
  since_ = std::max(since_, now);
  framesPerSecond_ = framesPerSecond;
}

void FlightRecording::moveTo(const CameraPose& pose, Clock::time_point now, Clock::duration took) {
  const double to = std::max(position(now), moves_.back().to);
  const double frames = std::chrono::duration<double>(took).count() * framesPerSecond_;
  moves_.push_back({std::clamp(to - frames, moves_.back().to, to), to, pose});
}

CameraPose FlightRecording::poseAt(double position) const {
  const auto next = std::ranges::upper_bound(moves_, position, {}, [](const Move& move) { return move.to; });
  assert(next != moves_.begin()); // the first one ends at 0
  const CameraPose& before = std::prev(next)->pose;
  if (next == moves_.end() || position <= next->from) return before;
  return between(before, next->pose, (position - next->from) / (next->to - next->from));
}

int FlightRecording::frameCount(Clock::time_point now) const {
  const double most = lastFrame_ - firstFrame_;
  return static_cast<int>(std::lround(std::min(position(now), most))) + 1;
}

bool FlightRecording::isFull(Clock::time_point now) const {
  return position(now) >= lastFrame_ - firstFrame_;
}

std::vector<CameraPose> FlightRecording::poses(Clock::time_point now) const {
  std::vector<CameraPose> poses(static_cast<std::size_t>(frameCount(now)));
  for (std::size_t frame = 0; frame < poses.size(); ++frame)
    poses[frame] = poseAt(static_cast<double>(frame));
  if (!isFull(now)) poses.back() = poseAt(position(now));
  return poses;
}

} // namespace taa
