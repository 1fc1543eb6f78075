// Camera paths of any scene: still, pan, orbit and dolly fitted to its bounds, and the cameras it brings.
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/Pose.h"
#include "core/scene/camera/CameraTrack.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

namespace {

constexpr float kFovY = 0.7853982f;   ///< radians: 45°
constexpr float kYaw = 0.42f;         ///< radians from +z to +x: a three-quarter view
constexpr float kPitch = 0.24f;       ///< radians above the horizon
constexpr float kMargin = 1.08f;      ///< room left around the bounds
constexpr float kPanAngle = 0.12f;    ///< radians to either side; in 4 s at 720p at most 2.7 px a frame
constexpr float kDollyNearest = 0.6f; ///< of the fitted distance
constexpr double kOrbitSeconds = 8.0; ///< shortest full turn; about 5 px a frame at 720p and 60 Hz
constexpr std::string_view kScenePrefix = "gltf:";

/// What the fitted paths look at; finite and of some size whatever the scene.
struct PathSubject {
  Bounds bounds;
  float radius = 1.0f;
};

bool isFinite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

PathSubject subjectOf(const Scene& scene) {
  const float radius = scene.bounds.radius();
  if (isFinite(scene.bounds.min) && isFinite(scene.bounds.max) && std::isfinite(radius) && radius > 0.0f &&
      isFinite(scene.bounds.center()))
    return {scene.bounds, radius};
  PathSubject subject; // empty, a single point, or not finite: look at a unit sphere where it is
  const bool isPoint = radius == 0.0f && !scene.bounds.isEmpty() && isFinite(scene.bounds.center());
  const glm::vec3 center = isPoint ? scene.bounds.center() : glm::vec3(0.0f);
  subject.bounds.add(center - glm::vec3(0.5f));
  subject.bounds.add(center + glm::vec3(0.5f));
  subject.radius = subject.bounds.radius();
  return subject;
}

/// Unit vector from the subject to an eye at `yaw` and `pitch`.
glm::vec3 outward(float yaw, float pitch) {
  return {std::cos(pitch) * std::sin(yaw), std::sin(pitch), std::cos(pitch) * std::cos(yaw)};
}

/// The smallest distance from the center at which all corners of the bounds are in the picture.
float fittedDistance(const PathSubject& subject, float yaw, float pitch, float aspect) {
  const float slopeY = std::tan(0.5f * kFovY) / kMargin, slopeX = slopeY * aspect;
  const glm::vec3 back = outward(yaw, pitch);
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
  const glm::vec3 up = glm::cross(back, right);
  const glm::vec3 half = 0.5f * (subject.bounds.max - subject.bounds.min);
  float distance = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 offset = half * glm::vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const float across =
        std::max(std::abs(glm::dot(offset, right)) / slopeX, std::abs(glm::dot(offset, up)) / slopeY);
    distance = std::max(distance, glm::dot(offset, back) + across);
  }
  return distance;
}

float orbitDistance(const PathSubject& subject, float aspect) {
  constexpr int kDirections = 16;
  float distance = 0.0f;
  for (int i = 0; i < kDirections; ++i)
    distance = std::max(
        distance, fittedDistance(subject, 6.2831853f * static_cast<float>(i) / kDirections, kPitch, aspect));
  return distance;
}

double shotSeconds(const Scene& scene) {
  const double seconds = scene.shot.cameraLoopFrames() / scene.shot.framesPerSecond;
  return std::isfinite(seconds) && seconds > 0.0 ? seconds : 4.0;
}

/// Angle of a loop of `period` seconds at `time`, 0 to 2π.
float loopAngle(double time, double period) {
  const double loops = time / period;
  return static_cast<float>(2.0 * std::numbers::pi * (loops - std::floor(loops)));
}

CameraState fittedCamera(const PathSubject& subject, const glm::vec3& eye, const glm::vec3& target,
                         float aspect) {
  CameraState camera;
  camera.nearPlane = kNearOfRadius * subject.radius;
  camera.viewFromWorld = glm::lookAt(eye, target, glm::vec3(0, 1, 0));
  camera.clipFromView = perspectiveReversed(kFovY, aspect, camera.nearPlane);
  return camera;
}

CameraState stillAt(const Scene& scene, double /*time*/, float aspect) {
  const PathSubject subject = subjectOf(scene);
  const glm::vec3 center = subject.bounds.center();
  const float distance = fittedDistance(subject, kYaw, kPitch, aspect);
  return fittedCamera(subject, center + distance * outward(kYaw, kPitch), center, aspect);
}

CameraState panAt(const Scene& scene, double time, float aspect) {
  const PathSubject subject = subjectOf(scene);
  const float distance = fittedDistance(subject, kYaw, kPitch, aspect);
  const glm::vec3 eye = subject.bounds.center() + distance * outward(kYaw, kPitch);
  const float turn = kPanAngle * std::sin(loopAngle(time, shotSeconds(scene)));
  return fittedCamera(subject, eye, eye - distance * outward(kYaw + turn, kPitch), aspect);
}

CameraState orbitAt(const Scene& scene, double time, float aspect) {
  const PathSubject subject = subjectOf(scene);
  const glm::vec3 center = subject.bounds.center();
  // A whole number of shots makes one turn, so that a long shot loops and a short one is not a blur.
  const double shot = shotSeconds(scene), period = shot * std::ceil(kOrbitSeconds / shot);
  const float yaw = kYaw + loopAngle(time, period);
  return fittedCamera(subject, center + orbitDistance(subject, aspect) * outward(yaw, kPitch), center,
                      aspect);
}

CameraState dollyAt(const Scene& scene, double time, float aspect) {
  const PathSubject subject = subjectOf(scene);
  const glm::vec3 center = subject.bounds.center();
  const float swing = 0.5f + 0.5f * std::cos(loopAngle(time, shotSeconds(scene)));
  const float distance =
      fittedDistance(subject, kYaw, kPitch, aspect) * (kDollyNearest + (1.0f - kDollyNearest) * swing);
  return fittedCamera(subject, center + distance * outward(kYaw, kPitch), center, aspect);
}

struct FittedPath {
  std::string_view name;
  CameraState (*at)(const Scene&, double, float);
};
constexpr std::array<FittedPath, 4> kFittedPaths{
    {{"still", stillAt}, {"pan", panAt}, {"orbit", orbitAt}, {"dolly", dollyAt}}};

/// The view of a node, its scale ignored as glTF asks.
glm::mat4 viewFromNode(const glm::mat4& worldFromNode) {
  const glm::vec3 eye(worldFromNode[3]), back(worldFromNode[2]), up(worldFromNode[1]);
  const glm::vec3 right = glm::cross(up, back);
  const float backLength = glm::length(back), rightLength = glm::length(right);
  if (!isFinite(eye) || !std::isfinite(backLength) || !std::isfinite(rightLength) || backLength <= 0.0f ||
      rightLength <= 0.0f)
    return glm::mat4(1.0f); // a flattened node has no direction to look in
  const glm::vec3 z = back / backLength, x = right / rightLength, y = glm::cross(z, x);
  glm::mat4 view(1.0f);
  for (int column = 0; column < 3; ++column) view[column] = {x[column], y[column], z[column], 0.0f};
  view[3] = {-glm::dot(x, eye), -glm::dot(y, eye), -glm::dot(z, eye), 1.0f};
  return view;
}

CameraState sceneCameraAt(const Scene& scene, const SceneCamera& source, double time, float aspect) {
  CameraState camera;
  camera.orthographic = source.orthographic;
  camera.nearPlane = source.nearPlane;
  camera.viewFromWorld =
      viewFromNode(poseAt(scene, time).worldFromNode.at(static_cast<std::size_t>(source.node)));
  camera.clipFromView = source.orthographic
                            ? orthographicReversed(source.height, aspect, source.nearPlane, source.farPlane)
                            : perspectiveReversed(source.fovY, aspect, source.nearPlane);
  return camera;
}

/// The path of one of the scene's own cameras: its name, made up or told apart where need be.
std::string scenePathName(const Scene& scene, std::size_t index) {
  const auto plain = [&](std::size_t i) {
    return scene.cameras[i].name.empty() ? "camera" + std::to_string(i) : scene.cameras[i].name;
  };
  std::string name = plain(index);
  for (std::size_t earlier = 0; earlier < index; ++earlier)
    if (plain(earlier) == plain(index)) return std::string(kScenePrefix) + name + "#" + std::to_string(index);
  return std::string(kScenePrefix) + name;
}

} // namespace

std::vector<std::string> cameraNames(const Scene& scene) {
  std::vector<std::string> names;
  names.reserve(kFittedPaths.size() + scene.cameras.size());
  for (const FittedPath& path : kFittedPaths) names.emplace_back(path.name);
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) names.push_back(scenePathName(scene, i));
  return names;
}

CameraState cameraAt(const Scene& scene, const std::string& name, double time, float aspect) {
  const float usedAspect = std::isfinite(aspect) && aspect > 0.0f ? aspect : 1.0f;
  for (const FittedPath& path : kFittedPaths)
    if (path.name == name) return path.at(scene, time, usedAspect);
  for (std::size_t i = 0; i < scene.cameras.size(); ++i)
    if (scenePathName(scene, i) == name) return sceneCameraAt(scene, scene.cameras[i], time, usedAspect);
  std::string known;
  for (const std::string& other : cameraNames(scene)) known += (known.empty() ? "" : ", ") + shownText(other);
  if (scene.name.empty())
    throw Error(say<"there is no camera \"%1\" in this scene; choose one of: %2">(shownText(name), known));
  throw Error(say<"there is no camera \"%1\" in %2; choose one of: %3">(shownText(name),
                                                                        shownText(scene.name), known));
}

glm::mat4 perspectiveReversed(float fovY, float aspect, float nearPlane) {
  const float slope = std::tan(0.5f * fovY);
  glm::mat4 clip(0.0f);
  clip[0][0] = 1.0f / (aspect * slope);
  clip[1][1] = 1.0f / slope;
  clip[2][3] = -1.0f;
  clip[3][2] = nearPlane; // depth = near / distance: 1 at the near plane, 0 at infinity
  return clip;
}

glm::mat4 orthographicReversed(float height, float aspect, float nearPlane, float farPlane) {
  glm::mat4 clip(1.0f);
  clip[0][0] = 2.0f / (height * aspect);
  clip[1][1] = 2.0f / height;
  clip[2][2] = 1.0f / (farPlane - nearPlane);
  clip[3][2] = farPlane / (farPlane - nearPlane);
  return clip;
}

} // namespace taa
