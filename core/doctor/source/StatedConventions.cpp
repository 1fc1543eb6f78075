#include "core/doctor/source/StatedConventions.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/decode/Cameras.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/decode/Motion.h"
#include "core/capture/decode/ScreenUnits.h"
#include "core/capture/import/DepthValues.h"
#include "core/capture/planes/Planes.h"
#include "core/doctor/depth/DepthCheck.h"
#include "core/doctor/jitter/JitterCheck.h"
#include "core/settings/Faults.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

using capture::Manifest;
using capture::PlaneKind;

Finding statedFinding(std::string id, std::string name, std::string reason, std::string symptom,
                      std::string change) {
  Finding out;
  out.id = std::move(id);
  out.name = std::move(name);
  out.isWholePicture = true;
  out.reason = std::move(reason);
  out.symptom = std::move(symptom);
  out.change = std::move(change);
  return out;
}

/// As stored, of the first frame from the middle on that has it, as nothing moves in the first one; empty:
/// none has.
Image storedPlane(const std::filesystem::path& folder, const Manifest& manifest, PlaneKind kind) {
  for (std::size_t i = manifest.frames.size() / 2; i < manifest.frames.size(); ++i) {
    const capture::CapturedFrame& frame = manifest.frames[i];
    if (manifest.planes.contains(kind) || frame.planes.contains(kind))
      return capture::readPlane(folder, manifest, frame, kind).image;
  }
  return {};
}

// Distances.

/// Distances are stated, and nearly everything would lie before the near plane: it is a depth buffer.
std::optional<Finding> correctKind(const std::filesystem::path& folder, Manifest& manifest) {
  constexpr double kNearlyAllBefore = 0.98;
  capture::DepthConventions& depth = manifest.conventions.depth;
  const auto camera = capture::statedCameras(manifest, 0).now;
  if (depth.kind == capture::DepthKind::Window || !camera) return {};
  const Image stored = storedPlane(folder, manifest, PlaneKind::Depth);
  const capture::DepthValues values = capture::depthValuesOf(stored);
  if (!values.isKnown || values.lowest < 0.0 || values.highest > 1.0) return {};
  const double metersPerValue = depth.scale * manifest.conventions.matrices.metersPerUnit;
  std::size_t known = 0, before = 0;
  for (const float value : stored.pixels) {
    const double distance = metersPerValue * static_cast<double>(value);
    if (!(distance > 0.0) || depth.nothing == value) continue;
    ++known;
    if (distance < camera->nearPlane) ++before;
  }
  if (known == 0 || static_cast<double>(before) < kNearlyAllBefore * static_cast<double>(known)) return {};
  const capture::DepthConventions guessed = capture::depthFrom(values);
  depth.kind = capture::DepthKind::Window;
  depth.reversed = guessed.reversed;
  depth.range = guessed.range;
  depth.nothing = guessed.nothing;
  Finding out = depthKindFinding();
  out.reason =
      say<"It is said to be a distance, and nearly everything would lie before the near plane of the "
          "matrices, %1 m: what is stored goes from %2 to %3.">(
          shortNumber(camera->nearPlane), shortNumber(values.lowest), shortNumber(values.highest));
  return out;
}

// Jitter in projections.

/// Where the middle of the picture lies by each projection as it is stored, px of content, x right, y down;
/// empty where a frame has none.
std::vector<glm::dvec2> projectedCentroids(const Manifest& manifest) {
  Manifest asStored = manifest;
  asStored.conventions.matrices.jittered = false;
  std::vector<glm::dvec2> out;
  for (std::size_t i = 0; i < manifest.frames.size(); ++i) {
    const auto camera = capture::statedCameras(asStored, i).now;
    if (!camera) return {};
    const glm::dmat4& clip = camera->camera.clipFromView;
    const glm::dvec2 ndc = camera->camera.orthographic ? glm::dvec2(clip[3]) : -glm::dvec2(clip[2]);
    out.push_back(glm::dvec2(0.5, -0.5) * ndc * glm::dvec2(manifest.sizePx));
  }
  return out;
}

/// px; the most that one is away from the first.
double spreadOf(const std::vector<glm::dvec2>& places) {
  double most = 0.0;
  for (const glm::dvec2& place : places) most = std::max(most, glm::distance(place, places.front()));
  return most;
}

/// Jitter of frames as stated, px of content.
std::vector<glm::dvec2> jitterOfFrames(const Manifest& manifest) {
  std::vector<glm::dvec2> out;
  for (std::size_t i = 0; i < manifest.frames.size(); ++i) out.push_back(capture::decodeJitter(manifest, i));
  return out;
}

/// Whether centroids move as jitter that is stated does, if it is multiplied so and of so many frames later,
/// besides a constant.
bool moveAlike(const std::vector<glm::dvec2>& centroids, const std::vector<glm::dvec2>& jitter,
               const glm::dvec2& sign, std::ptrdiff_t delay) {
  constexpr double kSamePx = 0.02;
  constexpr std::size_t kEnough = 3;
  const auto count = static_cast<std::ptrdiff_t>(centroids.size());
  std::vector<glm::dvec2> left;
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -delay); i < std::min(count, count - delay); ++i)
    left.push_back(centroids[static_cast<std::size_t>(i)] -
                   sign * jitter[static_cast<std::size_t>(i + delay)]);
  return left.size() >= kEnough && spreadOf(left) <= kSamePx;
}

/// The same whatever its sign or frame.
bool moveAlike(const std::vector<glm::dvec2>& centroids, const std::vector<glm::dvec2>& jitter) {
  for (const std::ptrdiff_t delay : {0, -1, 1})
    for (const double x : {1.0, -1.0})
      for (const double y : {1.0, -1.0})
        if (moveAlike(centroids, jitter, {x, y}, delay)) return true;
  return false;
}

/// The projections of all frames without what moves their centroids.
void restProjections(const std::vector<glm::dvec2>& centroids, Manifest& manifest) {
  glm::dvec2 mean(0.0);
  for (const glm::dvec2& middle : centroids) mean += middle / static_cast<double>(centroids.size());
  for (std::size_t i = 0; i < centroids.size(); ++i) {
    capture::CapturedFrame& frame = manifest.frames[i];
    frame.projection = capture::withoutJitter(manifest, *frame.projection, centroids[i] - mean);
    if (frame.previousProjection && i > 0)
      frame.previousProjection =
          capture::withoutJitter(manifest, *frame.previousProjection, centroids[i - 1] - mean);
  }
  manifest.conventions.matrices.jittered = false;
}

/// Projections are said to hold the jitter and do not, or the other way around.
std::optional<Finding> correctProjections(Manifest& manifest) {
  constexpr double kSameMiddlePx = 1e-3, kOtherMiddlePx = 0.1;
  const std::vector<glm::dvec2> centroids = projectedCentroids(manifest);
  if (centroids.empty()) return {};
  const std::vector<glm::dvec2> jitter = jitterOfFrames(manifest);
  const double movesPx = spreadOf(centroids);
  const bool isStated = manifest.conventions.matrices.jittered;
  if (spreadOf(jitter) < kOtherMiddlePx) return {};
  const std::string symptom = say<"Whatever is made of depth and matrices trembles, as motion of the sky.">();
  if (isStated && movesPx <= kSameMiddlePx) {
    manifest.conventions.matrices.jittered = false;
    return statedFinding("matricesNotJittered", say<"Matrices do not hold the jitter">(),
                         say<"Projections are said to hold the jitter, and are the same in all frames: taken "
                             "out of them it is put in.">(),
                         symptom, say<"State that matrices are without jitter.">());
  }
  const bool isRight = isStated && moveAlike(centroids, jitter, glm::dvec2(1.0), 0);
  if (isRight || movesPx < kOtherMiddlePx || !moveAlike(centroids, jitter)) return {};
  restProjections(centroids, manifest);
  if (isStated) return {};
  return statedFinding("matricesJittered", say<"Matrices hold the jitter">(),
                       say<"Projections are said to be without jitter, and move by %1 px with that which is "
                           "stated.">(shortNumber(movesPx)),
                       symptom, say<"State that matrices hold the jitter, or write those without it.">());
}

// Jitter.

/// Jitter of so many pixels, or so small a part of one, is none, whatever pictures show: of another unit it
/// goes to half of one.
std::optional<Finding> correctJitterUnit(Manifest& manifest) {
  constexpr double kNoJittersPx = 4.0, kSmallPx = 0.02, kHalfPx = 0.5, kRoundedPx = 0.55, kNearlyPx = 0.2;
  using capture::ScreenUnit;
  ScreenUnit& unit = manifest.conventions.jitter.unit;
  const auto farthestPx = [](const Manifest& stated) {
    double farthest = 0.0;
    for (const glm::dvec2& jitter : jitterOfFrames(stated))
      farthest = std::max({farthest, std::abs(jitter.x), std::abs(jitter.y)});
    return farthest;
  };
  const double statedPx = farthestPx(manifest);
  const bool isJitters = statedPx > kSmallPx && statedPx < kNoJittersPx;
  if (isJitters || !(statedPx > 0.0)) return {};
  std::optional<ScreenUnit> best;
  double nearest = statedPx <= kSmallPx ? kNearlyPx : kHalfPx;
  for (const ScreenUnit other : {ScreenUnit::Pixels, ScreenUnit::Uv, ScreenUnit::Ndc}) {
    Manifest otherwise = manifest;
    otherwise.conventions.jitter.unit = other;
    const double px = farthestPx(otherwise), miss = std::abs(kHalfPx - px);
    if (px > kRoundedPx || miss >= nearest) continue;
    nearest = miss;
    best = other;
  }
  if (!best) return {};
  const auto perUnit = [&](ScreenUnit of) {
    return capture::pxPerUnit(of, capture::VerticalAxis::Down, manifest.sizePx);
  };
  const JitterTrial trial{JitterKind::OtherUnit, glm::vec2(perUnit(*best) / perUnit(unit))};
  unit = *best;
  Finding out = jitterFinding(trial);
  out.confidence = Confidence::Likely;
  out.reason =
      say<"Jitter that is stated goes to %1 px; it goes to %2 px, about half of one, like this: %3.">(
          shortNumber(statedPx), shortNumber(farthestPx(manifest)), jitterTrialText(trial));
  return out;
}

// Encoding of motion.

/// Whether all numbers but 0 lie around a half, farther from 0 and 1 than motion without sign would.
bool areAroundHalf(const Image& stored) {
  constexpr float kFromEnds = 0.05f;
  return std::ranges::all_of(stored.pixels, [](float value) {
    return value == 0.0f || (value >= kFromEnds && value <= 1.0f - kFromEnds);
  });
}

std::optional<Finding> correctEncoding(const std::filesystem::path& folder, Manifest& manifest) {
  constexpr double kUnrealStep = 1.0 / 65535.0;
  capture::MotionConventions& motion = manifest.conventions.motion;
  const bool isUnreal = motion.encoding == capture::MotionEncoding::Unreal;
  if (motion.encoding == capture::MotionEncoding::Offset) return {};
  const Image stored = storedPlane(folder, manifest, PlaneKind::Motion);
  if (stored.empty()) return {};
  const capture::MotionValues values = capture::motionValuesOf(stored);
  const bool isBelow0 = std::ranges::any_of(stored.pixels, [](float value) { return value < 0.0f; });
  if (isUnreal && (isBelow0 || values.largest > 1.0)) {
    motion.encoding = capture::MotionEncoding::Plain;
    if (motion.notWritten == 0.0) motion.notWritten.reset();
    return statedFinding(
        "motionNotEncoded", say<"Motion that is not encoded is decoded">(),
        say<"Motion is said to be in Unreal's 16 bits, which go from 0 to 1; what is stored "
            "goes %1.">(isBelow0 ? say<"below 0">() : say<"up to %1">(shortNumber(values.largest))),
        say<"History comes from outside of the picture.">(),
        say<"State that motion is stored plain, in the unit that it has.">());
  }
  const auto rests = [&](double value) {
    return value == 0.0 || std::abs(value - capture::kUnrealRest) <= 1.5 * kUnrealStep;
  };
  const bool isAtRest = rests(values.restX) && rests(values.restY) && values.restX + values.restY > 0.5;
  const bool isUnsigned = !isBelow0 && values.largest <= 1.0 && areAroundHalf(stored);
  if (isUnreal || !isUnsigned || !(isAtRest || manifest.like == "unreal")) return {};
  motion.encoding = capture::MotionEncoding::Unreal;
  Finding out = faultFinding(Fault::MotionEncoded);
  out.isWholePicture = true;
  out.reason =
      say<"What is stored, but for 0, lies around ½ and never below 0: that is Unreal's encoding in 16 "
          "bits.">();
  out.change = say<"State Unreal's encoding of motion.">();
  return out;
}

} // namespace

std::vector<Finding> correctContradicted(const std::filesystem::path& folder, Manifest& manifest) {
  std::vector<Finding> out;
  for (std::optional<Finding> finding : {correctKind(folder, manifest), correctJitterUnit(manifest),
                                         correctProjections(manifest), correctEncoding(folder, manifest)})
    if (finding) out.push_back(std::move(*finding));
  return out;
}

} // namespace taa::doctor
