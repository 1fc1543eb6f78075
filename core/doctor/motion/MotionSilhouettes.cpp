#include "core/doctor/motion/MotionSilhouettes.h"

#include "core/base/Say.h"
#include "core/doctor/Correction.h"
#include "core/settings/Faults.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

/// Pixels of an object, and of what is beside it, in a row across its silhouette, that have to be there.
constexpr int kSilhouetteReach = 2;
constexpr float kSilhouetteStepPx = 0.5f;  ///< motions of the two sides differ by more
constexpr float kSilhouetteStepLog = 0.2f; ///< likewise logarithms of depths
/// Of the step: a value is that of the nearer side.
constexpr float kSilhouetteNearShare = 0.25f;
constexpr std::size_t kEnoughSilhouettes = 150;
constexpr double kSilhouetteRight = 0.05, kSilhouetteExplained = 0.8;
/// Without jitter there are so many times as many foreign pixels as its length says, at least and at most.
constexpr double kLeastUnjittered = 0.6, kMostUnjittered = 1.5;

/// A pixel at a silhouette, and those farther inside and outside.
struct SilhouettePixel {
  glm::ivec2 own{0}, inside{0}, outside{0};
};

std::uint32_t idAt(const DoctorFrame& frame, const glm::ivec2& pixel) {
  return frame.objectId[static_cast<std::size_t>(pixel.y) * frame.luma.width + pixel.x];
}

bool isInPlane(const DoctorFrame& frame, const glm::ivec2& pixel) {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x < frame.luma.width && pixel.y < frame.luma.height;
}

/// Whether `pixel` and those after it along `step` are of one object, and within the picture.
bool isOneObject(const DoctorFrame& frame, const glm::ivec2& pixel, const glm::ivec2& step) {
  for (int i = 0; i <= kSilhouetteReach; ++i) {
    const glm::ivec2 at = pixel + i * step;
    if (!isInPlane(frame, at) || idAt(frame, at) != idAt(frame, pixel)) return false;
  }
  return true;
}

/// Counts a silhouette pixel by how far its value is from that inside and that outside, and these from each
/// other.
void countSilhouette(SilhouetteCounts& counts, const DoctorFrame& frame, const SilhouettePixel& silhouette,
                     const glm::vec3& distances, float leastStep) {
  const float toInside = distances.x, toOutside = distances.y, step = distances.z;
  if (!(step > leastStep)) return; // NaN, too
  const bool isForeign =
      toOutside <= kSilhouetteNearShare * step && toInside > (1.0f - kSilhouetteNearShare) * step;
  ++counts.pixels;
  const float outwardPx = glm::dot(frame.jitterPx, glm::vec2(glm::sign(silhouette.outside - silhouette.own)));
  counts.unjittered += static_cast<double>(std::max(0.0f, outwardPx));
  if (isForeign) ++counts.foreign;
  if (isForeign && outwardPx > 0.0f) ++counts.outward;
  for (std::size_t i = 0; i < kSilhouetteReadings; ++i) {
    const glm::ivec2 texel = silhouetteReadings()[i].texel(silhouette.own);
    if (!isInPlane(frame, texel) || idAt(frame, texel) != idAt(frame, silhouette.outside)) continue;
    ++counts.expected[i];
    if (isForeign) ++counts.met[i];
  }
}

std::optional<glm::vec2> silhouetteMotion(const DoctorFrame& frame, const glm::ivec2& pixel) {
  const glm::vec2 motion = frame.motionAt(pixel.x, pixel.y);
  if (!isMotion(motion)) return {};
  return motion;
}

void addMotionSilhouette(SilhouetteCounts& counts, const DoctorFrame& frame,
                         const SilhouettePixel& silhouette) {
  const auto own = silhouetteMotion(frame, silhouette.own), in = silhouetteMotion(frame, silhouette.inside),
             beyond = silhouetteMotion(frame, silhouette.outside);
  if (!own || !in || !beyond) return;
  countSilhouette(counts, frame, silhouette,
                  {glm::distance(*own, *in), glm::distance(*own, *beyond), glm::distance(*in, *beyond)},
                  kSilhouetteStepPx);
}

void addDepthSilhouette(SilhouetteCounts& counts, const DoctorFrame& frame,
                        const SilhouettePixel& silhouette) {
  // The sky, at 0, is as far as anything that is drawn can be.
  const auto log = [&](const glm::ivec2& at) {
    return std::log(std::max(*frame.depth.at(at.x, at.y), 1e-6f));
  };
  const float own = log(silhouette.own), in = log(silhouette.inside), beyond = log(silhouette.outside);
  countSilhouette(counts, frame, silhouette,
                  {std::abs(own - in), std::abs(own - beyond), std::abs(in - beyond)}, kSilhouetteStepLog);
}

std::string silhouetteReason(const SilhouetteCounts& counts) {
  const SilhouetteReading* reading = counts.reading();
  if (counts.verdict() == SilhouetteVerdict::Unjittered || !reading)
    return say<"At %1 of %2 pixels at the rims of objects the value is that of what is beside them, wherever "
               "jitter moves the rim outward.">(counts.foreign, counts.pixels);
  return say<"At %1 of %2 pixels at the rims of objects the value is that of what is beside them: it is read "
             "in squares of %3 × %3 px, %4, %5 px beside.">(counts.foreign, counts.pixels, reading->side,
                                                            -reading->shift.x, -reading->shift.y);
}

Finding silhouetteFinding(Fault fault, const SilhouetteCounts& counts, std::string change) {
  Finding out = faultFinding(fault);
  out.isWholePicture = true;
  out.reason = silhouetteReason(counts);
  out.change = std::move(change);
  return out;
}

std::optional<int> coarseSide(const SharedTexels& plane, const SharedTexels& light) {
  const std::optional<int> side = plane.side();
  if (!side || light.side() == side) return {};
  return side;
}

std::string coarseDepthChange() {
  return say<"Write depth in the resolution that color is drawn in, or state the size it has.">();
}

std::string coarseMotionChange() {
  return say<"Write motion in the resolution that color is drawn in, or state the size it has.">();
}

Finding texelFinding(Fault fault, int side, std::string change) {
  Finding out = faultFinding(fault);
  out.isWholePicture = true;
  out.reason =
      say<"In squares of %1 × %1 pixels, from the first one on, all pixels have the very same value, "
          "and those beside them another; the picture is not made of such squares.">(side);
  out.change = std::move(change);
  return out;
}

/// What silhouettes would show, and do not: there are too few, or they are wrong in a way that nothing
/// explains.
void tellOpenSilhouettes(SilhouetteVerdict depth, SilhouetteVerdict motion, Diagnosis& out) {
  const auto isOpen = [](SilhouetteVerdict verdict) {
    return verdict == SilhouetteVerdict::TooFew || verdict == SilhouetteVerdict::Unclear;
  };
  Undecided open{say<"Motion and depth at rims">(),
                 say<"too few rims of objects can be told from what is beside them">(),
                 say<"Capture object numbers, too, and let objects move before what is behind them.">(),
                 {}};
  if (isOpen(depth)) open.faults = {Fault::DepthCoarse, Fault::DepthNotJittered};
  if (isOpen(motion)) open.faults.insert(open.faults.end(), {Fault::MotionShifted, Fault::MotionCoarse});
  if (depth == SilhouetteVerdict::Unclear || motion == SilhouetteVerdict::Unclear) {
    open.reason = say<"values there are neither those of the object nor those that another reading has">();
    open.isMisfit = true;
  }
  if (!open.faults.empty()) out.parts.leaveOpen(std::move(open));
}

} // namespace

const std::array<SilhouetteReading, kSilhouetteReadings>& silhouetteReadings() {
  static const std::array<SilhouetteReading, kSilhouetteReadings> kReadings{{{{1, 1}, 1},
                                                                             {{-1, -1}, 1},
                                                                             {{1, -1}, 1},
                                                                             {{-1, 1}, 1},
                                                                             {{1, 0}, 1},
                                                                             {{-1, 0}, 1},
                                                                             {{0, 1}, 1},
                                                                             {{0, -1}, 1},
                                                                             {{0, 0}, 2},
                                                                             {{1, 1}, 2},
                                                                             {{0, 0}, 3},
                                                                             {{0, 0}, 4}}};
  return kReadings;
}

const SilhouetteReading* SilhouetteCounts::reading() const {
  const SilhouetteReading* best = nullptr;
  std::size_t most = 0;
  for (std::size_t i = 0; i < kSilhouetteReadings; ++i) {
    const auto hits = static_cast<double>(met[i]);
    if (hits < kSilhouetteExplained * static_cast<double>(expected[i]) ||
        hits < kSilhouetteExplained * static_cast<double>(foreign) || met[i] <= most)
      continue;
    most = met[i];
    best = &silhouetteReadings()[i];
  }
  return best;
}

SilhouetteVerdict SilhouetteCounts::verdict() const {
  if (pixels < kEnoughSilhouettes) return SilhouetteVerdict::TooFew;
  if (static_cast<double>(foreign) <= kSilhouetteRight * static_cast<double>(pixels))
    return SilhouetteVerdict::Right;
  const auto all = static_cast<double>(foreign);
  if (static_cast<double>(outward) >= kSilhouetteExplained * all && all >= kLeastUnjittered * unjittered &&
      all <= kMostUnjittered * unjittered)
    return SilhouetteVerdict::Unjittered;
  const SilhouetteReading* best = reading();
  if (!best) return SilhouetteVerdict::Unclear;
  return best->side > 1 ? SilhouetteVerdict::Coarse : SilhouetteVerdict::Shifted;
}

void SilhouetteEvidence::add(const DoctorFrame& frame) {
  if (frame.objectId.empty()) {
    motionTexels.add(frame.motionPx);
    depthTexels.add(frame.depth);
    lightTexels.add(frame.luma);
    return;
  }
  for (int y = 0; y < frame.luma.height; ++y)
    for (int x = 0; x < frame.luma.width; ++x)
      for (const glm::ivec2& step :
           {glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, -1), glm::ivec2(0, 1)}) {
        const SilhouettePixel silhouette{{x, y},
                                         glm::ivec2(x, y) - kSilhouetteReach * step,
                                         glm::ivec2(x, y) + (1 + kSilhouetteReach) * step};
        const glm::ivec2 beside = silhouette.own + step;
        if (!isInPlane(frame, beside) || idAt(frame, silhouette.own) == idAt(frame, beside) ||
            !isOneObject(frame, silhouette.own, -step) || !isOneObject(frame, beside, step))
          continue;
        if (!frame.motionPx.empty()) addMotionSilhouette(motion, frame, silhouette);
        // Depth that is drawn without jitter, as is said of it, has its silhouettes elsewhere.
        if (!frame.depth.empty() && frame.depthJitterPx == frame.jitterPx)
          addDepthSilhouette(depth, frame, silhouette);
      }
}

std::optional<int> SilhouetteEvidence::coarseDepth() const {
  return coarseSide(depthTexels, lightTexels);
}

std::optional<int> SilhouetteEvidence::coarseMotion() const {
  return coarseSide(motionTexels, lightTexels);
}

void tellSilhouettes(const SilhouetteEvidence& evidence, bool isMotionRight, Diagnosis& out) {
  const SilhouetteVerdict depth = evidence.depth.verdict(),
                          motion = isMotionRight ? evidence.motion.verdict() : SilhouetteVerdict::TooFew;
  const std::optional<int> depthSide = evidence.coarseDepth(), motionSide = evidence.coarseMotion();
  if (depth == SilhouetteVerdict::Coarse || depthSide)
    out.findings.push_back(depthSide
                               ? texelFinding(Fault::DepthCoarse, *depthSide, coarseDepthChange())
                               : silhouetteFinding(Fault::DepthCoarse, evidence.depth, coarseDepthChange()));
  if (depth == SilhouetteVerdict::Unjittered)
    out.findings.push_back(silhouetteFinding(
        Fault::DepthNotJittered, evidence.depth,
        say<"Draw depth with the jitter that color is drawn with, or state that it has none.">()));
  if (motion == SilhouetteVerdict::Shifted) {
    out.findings.push_back(silhouetteFinding(Fault::MotionShifted, evidence.motion,
                                             say<"Read motion at the center of the pixel's own texel.">()));
    const glm::ivec2 shift = evidence.motion.reading()->shift;
    if (shift.x == shift.y) // the only direction that the setting has
      correctBy({"fault.motionShift=" + std::to_string(-shift.x)}, out.findings.back());
  }
  if (motion == SilhouetteVerdict::Coarse || motionSide)
    out.findings.push_back(
        motionSide ? texelFinding(Fault::MotionCoarse, *motionSide, coarseMotionChange())
                   : silhouetteFinding(Fault::MotionCoarse, evidence.motion, coarseMotionChange()));
  if (depth == SilhouetteVerdict::Right && motion == SilhouetteVerdict::Right)
    out.parts.addRight(say<"Motion and depth at rims">(),
                       say<"Motion and depth lie on the objects that they are of.">());
  tellOpenSilhouettes(depthSide ? SilhouetteVerdict::Coarse : depth,
                      motionSide ? SilhouetteVerdict::Coarse : motion, out);
}

} // namespace taa::doctor
