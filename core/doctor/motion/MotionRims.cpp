#include "core/doctor/motion/MotionRims.h"

#include "core/base/Say.h"
#include "core/doctor/Mending.h"
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

/// Pixels of an object, and of what is beside it, in a row across its rim, that have to be there.
constexpr int kRimReach = 2;
constexpr float kRimStepPx = 0.5f;  ///< motions of the two sides differ by more
constexpr float kRimStepLog = 0.2f; ///< likewise logarithms of depths
/// Of the step: a value is that of the nearer side.
constexpr float kRimNearShare = 0.25f;
constexpr std::size_t kEnoughRims = 150;
constexpr double kRimRight = 0.05, kRimExplained = 0.8;
/// Without jitter there are so many times as many foreign pixels as its length says, at least and at most.
constexpr double kLeastUnjittered = 0.6, kMostUnjittered = 1.5;

/// A pixel at a rim, and those farther inside and outside.
struct RimPixel {
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
  for (int i = 0; i <= kRimReach; ++i) {
    const glm::ivec2 at = pixel + i * step;
    if (!isInPlane(frame, at) || idAt(frame, at) != idAt(frame, pixel)) return false;
  }
  return true;
}

/// Counts a rim pixel by how far its value is from that inside and that outside, and these from each other.
void countRim(RimCounts& counts, const DoctorFrame& frame, const RimPixel& rim, const glm::vec3& distances,
              float leastStep) {
  const float toInside = distances.x, toOutside = distances.y, step = distances.z;
  if (!(step > leastStep)) return; // NaN, too
  const bool isForeign = toOutside <= kRimNearShare * step && toInside > (1.0f - kRimNearShare) * step;
  ++counts.pixels;
  const float outwardPx = glm::dot(frame.jitterPx, glm::vec2(glm::sign(rim.outside - rim.own)));
  counts.unjittered += static_cast<double>(std::max(0.0f, outwardPx));
  if (isForeign) ++counts.foreign;
  if (isForeign && outwardPx > 0.0f) ++counts.outward;
  for (std::size_t i = 0; i < kRimReadings; ++i) {
    const glm::ivec2 texel = rimReadings()[i].texel(rim.own);
    if (!isInPlane(frame, texel) || idAt(frame, texel) != idAt(frame, rim.outside)) continue;
    ++counts.expected[i];
    if (isForeign) ++counts.met[i];
  }
}

std::optional<glm::vec2> rimMotion(const DoctorFrame& frame, const glm::ivec2& pixel) {
  const glm::vec2 motion = frame.motionAt(pixel.x, pixel.y);
  if (!isMotion(motion)) return {};
  return motion;
}

void addMotionRim(RimCounts& counts, const DoctorFrame& frame, const RimPixel& rim) {
  const auto own = rimMotion(frame, rim.own), in = rimMotion(frame, rim.inside),
             beyond = rimMotion(frame, rim.outside);
  if (!own || !in || !beyond) return;
  countRim(counts, frame, rim,
           {glm::distance(*own, *in), glm::distance(*own, *beyond), glm::distance(*in, *beyond)}, kRimStepPx);
}

void addDepthRim(RimCounts& counts, const DoctorFrame& frame, const RimPixel& rim) {
  // The sky, at 0, is as far as anything that is drawn can be.
  const auto log = [&](const glm::ivec2& at) {
    return std::log(std::max(*frame.depth.at(at.x, at.y), 1e-6f));
  };
  const float own = log(rim.own), in = log(rim.inside), beyond = log(rim.outside);
  countRim(counts, frame, rim, {std::abs(own - in), std::abs(own - beyond), std::abs(in - beyond)},
           kRimStepLog);
}

std::string rimReason(const RimCounts& counts) {
  const RimReading* reading = counts.reading();
  if (counts.verdict() == RimVerdict::Unjittered || !reading)
    return say<"At %1 of %2 pixels at the rims of objects the value is that of what is beside them, wherever "
               "jitter moves the rim outward.">(counts.foreign, counts.pixels);
  return say<"At %1 of %2 pixels at the rims of objects the value is that of what is beside them: it is read "
             "in squares of %3 × %3 px, %4, %5 px beside.">(counts.foreign, counts.pixels, reading->side,
                                                            -reading->shift.x, -reading->shift.y);
}

Finding rimFinding(Fault fault, const RimCounts& counts, std::string change) {
  Finding out = faultFinding(fault);
  out.isWholePicture = true;
  out.reason = rimReason(counts);
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

/// What rims would show, and do not: there are too few, or they are wrong in a way that nothing explains.
void tellOpenRims(RimVerdict depth, RimVerdict motion, Diagnosis& out) {
  const auto isOpen = [](RimVerdict verdict) {
    return verdict == RimVerdict::TooFew || verdict == RimVerdict::Unclear;
  };
  Undecided open{say<"Motion and depth at rims">(),
                 say<"too few rims of objects can be told from what is beside them">(),
                 say<"Capture object numbers, too, and let objects move before what is behind them.">(),
                 {}};
  if (isOpen(depth)) open.faults = {Fault::DepthCoarse, Fault::DepthNotJittered};
  if (isOpen(motion)) open.faults.insert(open.faults.end(), {Fault::MotionShifted, Fault::MotionCoarse});
  if (depth == RimVerdict::Unclear || motion == RimVerdict::Unclear) {
    open.reason = say<"values there are neither those of the object nor those that another reading has">();
    open.isMisfit = true;
  }
  if (!open.faults.empty()) out.parts.leaveOpen(std::move(open));
}

} // namespace

const std::array<RimReading, kRimReadings>& rimReadings() {
  static const std::array<RimReading, kRimReadings> kReadings{{{{1, 1}, 1},
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

const RimReading* RimCounts::reading() const {
  const RimReading* best = nullptr;
  std::size_t most = 0;
  for (std::size_t i = 0; i < kRimReadings; ++i) {
    const auto hits = static_cast<double>(met[i]);
    if (hits < kRimExplained * static_cast<double>(expected[i]) ||
        hits < kRimExplained * static_cast<double>(foreign) || met[i] <= most)
      continue;
    most = met[i];
    best = &rimReadings()[i];
  }
  return best;
}

RimVerdict RimCounts::verdict() const {
  if (pixels < kEnoughRims) return RimVerdict::TooFew;
  if (static_cast<double>(foreign) <= kRimRight * static_cast<double>(pixels)) return RimVerdict::Right;
  const auto all = static_cast<double>(foreign);
  if (static_cast<double>(outward) >= kRimExplained * all && all >= kLeastUnjittered * unjittered &&
      all <= kMostUnjittered * unjittered)
    return RimVerdict::Unjittered;
  const RimReading* best = reading();
  if (!best) return RimVerdict::Unclear;
  return best->side > 1 ? RimVerdict::Coarse : RimVerdict::Shifted;
}

void RimEvidence::add(const DoctorFrame& frame) {
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
        const RimPixel rim{
            {x, y}, glm::ivec2(x, y) - kRimReach * step, glm::ivec2(x, y) + (1 + kRimReach) * step};
        const glm::ivec2 beside = rim.own + step;
        if (!isInPlane(frame, beside) || idAt(frame, rim.own) == idAt(frame, beside) ||
            !isOneObject(frame, rim.own, -step) || !isOneObject(frame, beside, step))
          continue;
        if (!frame.motionPx.empty()) addMotionRim(motion, frame, rim);
        // Depth that is drawn without jitter, as is said of it, has its rims elsewhere.
        if (!frame.depth.empty() && frame.depthJitterPx == frame.jitterPx) addDepthRim(depth, frame, rim);
      }
}

std::optional<int> RimEvidence::coarseDepth() const {
  return coarseSide(depthTexels, lightTexels);
}

std::optional<int> RimEvidence::coarseMotion() const {
  return coarseSide(motionTexels, lightTexels);
}

void tellRims(const RimEvidence& evidence, bool isMotionRight, Diagnosis& out) {
  const RimVerdict depth = evidence.depth.verdict(),
                   motion = isMotionRight ? evidence.motion.verdict() : RimVerdict::TooFew;
  const std::optional<int> depthSide = evidence.coarseDepth(), motionSide = evidence.coarseMotion();
  if (depth == RimVerdict::Coarse || depthSide)
    out.findings.push_back(depthSide ? texelFinding(Fault::DepthCoarse, *depthSide, coarseDepthChange())
                                     : rimFinding(Fault::DepthCoarse, evidence.depth, coarseDepthChange()));
  if (depth == RimVerdict::Unjittered)
    out.findings.push_back(
        rimFinding(Fault::DepthNotJittered, evidence.depth,
                   say<"Draw depth with the jitter that color is drawn with, or state that it has none.">()));
  if (motion == RimVerdict::Shifted) {
    out.findings.push_back(rimFinding(Fault::MotionShifted, evidence.motion,
                                      say<"Read motion at the center of the pixel's own texel.">()));
    const glm::ivec2 shift = evidence.motion.reading()->shift;
    if (shift.x == shift.y) // the only direction that the setting has
      mendBy({"fault.motionShift=" + std::to_string(-shift.x)}, out.findings.back());
  }
  if (motion == RimVerdict::Coarse || motionSide)
    out.findings.push_back(motionSide
                               ? texelFinding(Fault::MotionCoarse, *motionSide, coarseMotionChange())
                               : rimFinding(Fault::MotionCoarse, evidence.motion, coarseMotionChange()));
  if (depth == RimVerdict::Right && motion == RimVerdict::Right)
    out.parts.addRight(say<"Motion and depth at rims">(),
                       say<"Motion and depth lie on the objects that they are of.">());
  tellOpenRims(depthSide ? RimVerdict::Coarse : depth, motionSide ? RimVerdict::Coarse : motion, out);
}

} // namespace taa::doctor
