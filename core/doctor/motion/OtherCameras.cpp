#include "core/doctor/motion/OtherCameras.h"

#include "core/base/Median.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace taa::doctor {

namespace {

constexpr double kCameraSamples = 800.0;
constexpr std::size_t kLeastCameraSamples = 100;
// px, in the middle of all samples: motion that is the camera's, and a fit that explains it.
constexpr double kCamerasOwnPx = 0.02, kCameraFitPx = 0.05;
constexpr int kCameraFitSteps = 12;

/// A pixel by where it was in front of the previous camera, and where motion says that it was.
struct CameraSample {
  glm::dvec4 previousView{0.0};
  glm::dvec2 givenNdc{0.0};
};

struct CameraSamples {
  std::vector<CameraSample> pixels;
  glm::dmat4 clipFromView{1.0};
  glm::dvec2 pxPerNdc{1.0};
};

/// `isNear`: without what is infinitely far away, which no camera's way moves.
CameraSamples samplesOf(const DoctorFrame& frame, bool isNear) {
  const glm::ivec2 size = frame.sizePx();
  CameraSamples out{{}, frame.cameras->clipFromView, glm::dvec2(0.5, -0.5) * glm::dvec2(size)};
  const glm::dmat4 previousViewFromClip =
      glm::inverse(out.clipFromView) * glm::dmat4(*frame.previousClipFromClip);
  const int step =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(size.x) * size.y / kCameraSamples)));
  for (int y = step / 2; y < size.y; y += step)
    for (int x = step / 2; x < size.x; x += step) {
      const glm::vec2 given = frame.motionAt(x, y);
      const double depth = static_cast<double>(*frame.depth.at(x, y));
      if (!isMotion(given) || (isNear && !(depth > 0.0))) continue;
      const glm::dvec2 ndc =
          (glm::dvec2(x, y) + 0.5 - glm::dvec2(frame.depthJitterPx)) / out.pxPerNdc + glm::dvec2(-1.0, 1.0);
      out.pixels.push_back(
          {previousViewFromClip * glm::dvec4(ndc, depth, 1.0), ndc - glm::dvec2(given) / out.pxPerNdc});
    }
  return out;
}

/// What a pixel's motion lacks, px, if the previous camera's view is changed; NaN behind it.
glm::dvec2 missPx(const CameraSamples& samples, const CameraSample& pixel, const glm::dmat4& change) {
  const glm::dvec4 clip = samples.clipFromView * (change * pixel.previousView);
  if (!(clip.w > 0.0)) return glm::dvec2(std::numeric_limits<double>::quiet_NaN());
  return (pixel.givenNdc - glm::dvec2(clip) / clip.w) * samples.pxPerNdc;
}

double medianMissPx(const CameraSamples& samples, const glm::dmat4& change) {
  std::vector<double> misses;
  for (const CameraSample& pixel : samples.pixels)
    if (const double miss = glm::length(missPx(samples, pixel, change)); std::isfinite(miss))
      misses.push_back(miss);
  return misses.size() < kLeastCameraSamples ? std::numeric_limits<double>::infinity() : median(misses);
}

glm::dmat4 turnedBy(const glm::dvec3& angles) {
  const double angle = glm::length(angles);
  return angle > 0.0 ? glm::rotate(glm::dmat4(1.0), angle, angles / angle) : glm::dmat4(1.0);
}

glm::dmat4 movedBy(const glm::dvec3& way) {
  return glm::translate(glm::dmat4(1.0), way);
}

/// One step of Gauss and Newton, in which what misses by much counts for little (Cauchy's weights).
glm::dvec3 fitStep(const CameraSamples& samples, const glm::dvec3& at,
                   glm::dmat4 (*changeOf)(const glm::dvec3&), double scalePx) {
  constexpr double kSlopeStep = 1e-4;
  const glm::dmat4 change = changeOf(at);
  std::array<glm::dmat4, 3> beside;
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 moved = at;
    moved[i] += kSlopeStep;
    beside[static_cast<std::size_t>(i)] = changeOf(moved);
  }
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  for (const CameraSample& pixel : samples.pixels) {
    const glm::dvec2 miss = missPx(samples, pixel, change);
    const double share = glm::length(miss) / scalePx;
    if (!std::isfinite(share)) continue;
    std::array<glm::dvec2, 3> slopes;
    for (std::size_t i = 0; i < 3; ++i) slopes[i] = (missPx(samples, pixel, beside[i]) - miss) / kSlopeStep;
    const double weight = 1.0 / (1.0 + share * share);
    for (int i = 0; i < 3; ++i) {
      const glm::dvec2 slope = slopes[static_cast<std::size_t>(i)];
      right[i] -= weight * glm::dot(slope, miss);
      for (int j = 0; j < 3; ++j)
        normal[i][j] += weight * glm::dot(slope, slopes[static_cast<std::size_t>(j)]);
    }
  }
  for (int i = 0; i < 3; ++i) normal[i][i] *= 1.0 + 1e-9;
  const glm::dvec3 step = glm::inverse(normal) * right;
  return std::isfinite(glm::dot(step, step)) ? step : glm::dvec3(0.0);
}

std::optional<glm::dvec3> fittedChange(const CameraSamples& samples,
                                       glm::dmat4 (*changeOf)(const glm::dvec3&)) {
  glm::dvec3 at(0.0);
  for (int i = 0; i < kCameraFitSteps; ++i)
    at += fitStep(samples, at, changeOf, std::max(1e-3, 1.5 * medianMissPx(samples, changeOf(at))));
  if (!(medianMissPx(samples, changeOf(at)) <= kCameraFitPx)) return {};
  return at;
}

std::optional<glm::mat4> changedCamera(const DoctorFrame& frame, const std::optional<glm::dvec3>& at,
                                       glm::dmat4 (*changeOf)(const glm::dvec3&)) {
  if (!at) return {};
  const glm::dmat4& clipFromView = frame.cameras->clipFromView;
  return glm::mat4(clipFromView * changeOf(*at) * glm::inverse(clipFromView) *
                   glm::dmat4(*frame.previousClipFromClip));
}

/// `moved`: by which the previous view is, m. Nothing where that is not along the camera's way.
std::optional<double> wayShareOf(const UnjitteredCameras& cameras, const glm::dvec3& moved) {
  constexpr double kAlong = 0.1, kLeastWay = 1e-6;
  const glm::dvec4 eye = cameras.previousViewFromWorld * glm::inverse(cameras.viewFromWorld)[3];
  const glm::dvec3 way(eye); // from where the previous camera stood to where this one does
  const double square = glm::dot(way, way);
  if (!(square > kLeastWay * kLeastWay)) return {};
  const double lacking = -glm::dot(moved, way) / square;
  if (glm::length(moved + lacking * way) > kAlong * glm::length(moved)) return {};
  return 1.0 - lacking;
}

/// Of the three planes of the world through its origin the one that fits best.
glm::mat4 mirroredCamera(const UnjitteredCameras& cameras, const CameraSamples& samples) {
  const glm::dmat4 viewFromClip = glm::inverse(cameras.clipFromView);
  const glm::dmat4 worldFromPreviousView = glm::inverse(cameras.previousViewFromWorld);
  glm::dmat4 best(1.0);
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 1; axis <= 3; ++axis) { // y first: floors and water mirror
    glm::dvec3 scale(1.0);
    scale[axis % 3] = -1.0;
    const glm::dmat4 change =
        cameras.previousViewFromWorld * glm::scale(glm::dmat4(1.0), scale) * worldFromPreviousView;
    const double miss = medianMissPx(samples, change);
    if (axis > 1 && !(miss < least)) continue;
    least = miss;
    best = change;
  }
  return glm::mat4(cameras.clipFromView * best * cameras.previousViewFromWorld *
                   glm::inverse(cameras.viewFromWorld) * viewFromClip);
}

/// A view from a place, in the world, with the rotation of another one.
glm::dmat4 viewAt(const glm::dmat4& rotated, const glm::dmat4& placed) {
  const glm::dmat3 rotation(rotated);
  const glm::dvec3 place(glm::inverse(placed)[3]);
  glm::dmat4 out(rotation);
  out[3] = glm::dvec4(-(rotation * place), 1.0);
  return out;
}

/// That of the frame before, which is another one where the camera zooms.
glm::dmat4 previousProjection(const DoctorFrame& frame) {
  const UnjitteredCameras& cameras = *frame.cameras;
  return glm::dmat4(*frame.previousClipFromClip) * cameras.clipFromView * cameras.viewFromWorld *
         glm::inverse(cameras.previousViewFromWorld);
}

bool isZoomed(const glm::dmat4& projection, const glm::dmat4& previous) {
  constexpr double kSame = 1e-3;
  return std::abs(previous[0][0] / projection[0][0] - 1.0) > kSame ||
         std::abs(previous[1][1] / projection[1][1] - 1.0) > kSame;
}

glm::mat4 previousClip(const UnjitteredCameras& cameras, const glm::dmat4& projection,
                       const glm::dmat4& previousView) {
  return glm::mat4(projection * previousView * glm::inverse(cameras.viewFromWorld) *
                   glm::inverse(cameras.clipFromView));
}

} // namespace

OtherCameras otherCameras(const DoctorFrame& frame) {
  OtherCameras out;
  if (!frame.cameras || !frame.previousClipFromClip || frame.depth.empty() || frame.motionPx.empty())
    return out;
  const CameraSamples samples = samplesOf(frame, false), near = samplesOf(frame, true);
  const auto isOwn = [](const CameraSamples& of) {
    return medianMissPx(of, glm::dmat4(1.0)) <= kCamerasOwnPx;
  };
  const bool hasNear = near.pixels.size() >= kLeastCameraSamples;
  if (isOwn(samples) && (!hasNear || isOwn(near))) return out;
  const UnjitteredCameras& cameras = *frame.cameras;
  out.identity = glm::mat4(glm::inverse(cameras.clipFromView * cameras.viewFromWorld));
  const glm::dmat4 previous = previousProjection(frame);
  if (isZoomed(cameras.clipFromView, previous))
    out.unzoomed = previousClip(cameras, cameras.clipFromView, cameras.previousViewFromWorld);
  out.unmoved = previousClip(cameras, previous, viewAt(cameras.previousViewFromWorld, cameras.viewFromWorld));
  out.unturned =
      previousClip(cameras, previous, viewAt(cameras.viewFromWorld, cameras.previousViewFromWorld));
  out.mirrored = mirroredCamera(cameras, samples);
  out.turned = changedCamera(frame, fittedChange(samples, turnedBy), turnedBy);
  const std::optional<glm::dvec3> moved = fittedChange(near, movedBy);
  out.beside = changedCamera(frame, moved, movedBy);
  if (!moved) return out;
  out.wayShare = wayShareOf(cameras, *moved);
  out.movedByM = glm::length(*moved);
  constexpr double kAside = 0.97;
  out.isMovedAside = std::abs(moved->x) >= kAside * out.movedByM;
  return out;
}

} // namespace taa::doctor
