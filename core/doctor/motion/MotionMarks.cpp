#include "core/doctor/motion/MotionMarks.h"

#include "core/base/Say.h"
#include "core/doctor/Correction.h"
#include "core/doctor/motion/MotionCorrection.h"
#include "core/doctor/motion/MotionFindings.h"
#include "core/settings/Faults.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

constexpr std::size_t kEnoughMarks = 150, kEnoughMarkedPairs = 3;
constexpr double kNearlyAllMarks = 0.9;
/// Of luma, in the mean: what rests fits to so much.
constexpr double kRestingError = 0.008;
/// px, in the mean: what moves by more is not marked for a motion of 0.
constexpr double kMarkedRestsPx = 0.05;

bool isNearlyAll(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) >= kNearlyAllMarks * static_cast<double>(whole);
}

Finding markFinding(Fault fault, std::string reason, std::string change) {
  Finding out = faultFinding(fault);
  out.reason = std::move(reason);
  out.change = std::move(change);
  return out;
}

/// Said to have no previous position, and what was there before, at rest in the world, fits it.
bool isMarkedAndKept(const RegionEvidence& evidence) {
  return evidence.markedPairs >= kEnoughMarkedPairs && evidence.markedTextured >= kEnoughMarks &&
         isNearlyAll(evidence.marked, evidence.seen) &&
         evidence.markedError <= kRestingError * static_cast<double>(evidence.markedTextured);
}

} // namespace

bool isUnwrittenMark(const RegionEvidence& evidence) {
  return evidence.seen >= kEnoughMarks * kEnoughMarkedPairs && isNearlyAll(evidence.marks, evidence.seen);
}

bool isKeptAsMissing(const RegionEvidence& evidence) {
  return isMarkedAndKept(evidence) &&
         evidence.markedPx <= kMarkedRestsPx * static_cast<double>(evidence.markedTextured);
}

void tellMarks(const MotionEvidence& evidence, const std::vector<Region>& regions,
               const CaptureInfo& captureInfo, double allPixels, Diagnosis& out) {
  Finding unwritten = markFinding(
      Fault::MotionUnwritten,
      say<"Motion there is longer than the picture, and the same, in every frame: it is a mark, and no "
          "motion.">(),
      say<"State the value that means \"not written\", and what it stands for: rebuild motion from depth and "
          "matrices there, or write it.">());
  Finding missing = markFinding(
      Fault::ZeroTakenAsMissing,
      say<"It is said to have no previous position in every frame, and what was there before fits it.">(),
      say<"Take motion of 0 for motion: mark what has no previous position by another value.">());
  bool rests = false;
  std::size_t moving = 0;
  for (std::size_t i = 0; i < regions.size() && i < evidence.regions().size(); ++i) {
    const RegionEvidence& region = evidence.regions()[i];
    rests = rests || region.zero >= kEnoughMarks;
    if (isUnwrittenMark(region))
      unwritten.regions.push_back(placeOf(regions[i], captureInfo, allPixels));
    else if (isKeptAsMissing(region))
      missing.regions.push_back(placeOf(regions[i], captureInfo, allPixels));
    else if (isMarkedAndKept(region))
      ++moving;
  }
  if (moving > 0)
    out.parts.leaveOpen(
        {moving == 1 ? say<"Motion of a part without previous position">()
                     : say<"Motion of %1 parts without previous position">(moving),
         say<"it is said to have none in every frame, and what was there before fits it, at another place: a "
             "camera that sees it nowhere, or a mark, makes that">(),
         say<"Write its motion, and look again.">(),
         {}});
  if (missing.regions.empty() && !rests)
    out.parts.leaveOpen({say<"Zero motion">(),
                         say<"nothing has it: whether it is taken for none does not show">(),
                         say<"Capture some frames in which the camera rests.">(),
                         {Fault::ZeroTakenAsMissing}});
  for (Finding* finding : {&unwritten, &missing})
    if (!finding->regions.empty()) {
      std::ranges::stable_sort(finding->regions, std::greater(), &RegionPlace::share);
      correctBy(motionCorrection({MotionKind::OfCamera}), *finding);
      out.findings.push_back(std::move(*finding));
    }
}

} // namespace taa::doctor
