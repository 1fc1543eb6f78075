#include "app/views/FlightMath.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {
constexpr float kRadiiPerSecond = 0.3f;            ///< across the scene in some seconds
constexpr float kSlowest = 1e-3f, kFastest = 1e2f; ///< of firstSpeed()
constexpr double kNotchFactor = 1.25;
constexpr float kFarAway = 1e6f;
} // namespace

CameraPose moved(const CameraPose& pose, const FlightKeys& keys, float distance) {
  if (!keys.isAny()) return pose;
  const glm::vec3 way = static_cast<float>(keys.right) * rightOf(pose) +
                        static_cast<float>(keys.up) * glm::vec3(0.0f, 1.0f, 0.0f) +
                        static_cast<float>(keys.forward) * forwardOf(pose);
  const float length = glm::length(way);
  if (length < 1e-4f) return pose; // straight up against straight down
  CameraPose next = pose;
  next.position =
      glm::clamp(pose.position + way * (distance / length), glm::vec3(-kFarAway), glm::vec3(kFarAway));
  return next;
}

CameraPose turned(const CameraPose& pose, double dx, double dy, double height) {
  // In the middle of the picture a pixel is this many degrees.
  const double slope = 2.0 * std::tan(0.5 * glm::radians(static_cast<double>(pose.fovY)));
  const double degrees = glm::degrees(slope / std::max(height, 1.0));
  CameraPose next = pose;
  next.yaw = static_cast<float>(std::remainder(pose.yaw + dx * degrees, 360.0));
  next.pitch =
      static_cast<float>(std::clamp(pose.pitch - dy * degrees, -double(kMaxPitch), double(kMaxPitch)));
  return next;
}

float firstSpeed(float radius) {
  return kRadiiPerSecond * radius;
}

float changedSpeed(float speed, double notches, float radius) {
  const float wanted = speed * static_cast<float>(std::pow(kNotchFactor, notches));
  return std::clamp(wanted, kSlowest * firstSpeed(radius), kFastest * firstSpeed(radius));
}

} // namespace taa::app
