#include "core/doctor/motion/MotionJumps.h"

#include "core/base/Median.h"
#include "core/base/Say.h"
#include "core/doctor/Correction.h"
#include "core/doctor/motion/MotionCorrection.h"
#include "core/doctor/motion/MotionFindings.h"
#include "core/doctor/motion/MotionReturns.h"
#include "core/settings/Faults.h"

#include <cstddef>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

constexpr std::size_t kEnoughTraces = 5, kEnoughJumping = 60;
/// A jump is so many times as long as motion is in the middle, and so many px more.
constexpr double kJumpFactor = 3.0, kJumpPx = 2.0;
/// Motion given leaves so many times as much, and by so much of luma more, in the mean.
constexpr double kJumpLeaves = 2.0, kJumpLuma = 0.01;
/// Of the pixels of all regions that were measured: a jump of so many is one of the whole picture.
constexpr double kJumpWholeShare = 0.9;

bool isLong(const PairTrace& trace, double usualPx) {
  return trace.meanPx() >= kJumpFactor * usualPx + kJumpPx;
}

bool isRefuted(const PairTrace& trace) {
  const auto compared = static_cast<double>(trace.compared);
  return trace.compared >= kEnoughJumping && trace.given >= kJumpLeaves * trace.tried &&
         trace.given - trace.tried >= kJumpLuma * compared;
}

std::string jumpChange(bool isWhole) {
  if (isWhole)
    return say<"Set the previous matrix before it is used for the first time: to this frame's, or mark the "
               "frame as one without history.">();
  return returnChange();
}

/// In that frame alone.
std::vector<std::string> inFrame(int frame) {
  std::vector<std::string> out = motionCorrection({MotionKind::OfCamera});
  out.push_back("fault.firstFrame=" + std::to_string(frame));
  out.push_back("fault.lastFrame=" + std::to_string(frame));
  return out;
}

/// In one frame all motion is that of a matrix that was never set.
Finding identityFinding(int frame, const FrameNames& names) {
  Finding out = faultFinding(Fault::PreviousIdentity);
  out.isWholePicture = true;
  out.reason = say<"In frame %1 alone motion is what a previous matrix of 1 makes.">(names.of(frame));
  out.change = jumpChange(true);
  correctBy(inFrame(frame), out);
  return out;
}

} // namespace

std::optional<int> jumpOf(const RegionEvidence& evidence) {
  if (evidence.traces.size() < kEnoughTraces) return {};
  std::vector<double> lengths;
  for (const PairTrace& trace : evidence.traces) lengths.push_back(trace.meanPx());
  const double usualPx = median(lengths);
  const PairTrace* found = nullptr;
  for (const PairTrace& trace : evidence.traces) {
    if (!isLong(trace, usualPx)) continue;
    if (found) return {};
    found = &trace;
  }
  return found && isRefuted(*found) ? std::optional(found->frame) : std::nullopt;
}

Finding lateFinding() {
  Finding out = faultFinding(Fault::MotionLingers);
  out.isWholePicture = true;
  out.reason =
      say<"At the rims of what moves, motion is that of what was there in the frame before: everywhere "
          "else it is the same in both.">();
  out.change = say<"Give each frame its own motion: what you write is that of the frame before.">();
  correctBy(motionCorrection({MotionKind::FrameLate}), out);
  return out;
}

void tellJumps(const MotionEvidence& evidence, const std::vector<Region>& regions,
               const CaptureInfo& captureInfo, double allPixels, Diagnosis& out) {
  if (const auto never = identityFrame(evidence.pairs())) {
    out.findings.push_back(identityFinding(*never, captureInfo.frameNames));
    return;
  }
  std::vector<RegionPlace> places;
  double jumping = 0.0, measured = 0.0;
  std::optional<int> frame;
  for (std::size_t i = 0; i < regions.size() && i < evidence.regions().size(); ++i) {
    if (evidence.regions()[i].textured > 0) measured += regions[i].pixels;
    const auto jump = jumpOf(evidence.regions()[i]);
    if (!jump || (frame && *jump != *frame)) continue;
    frame = jump;
    jumping += regions[i].pixels;
    places.push_back(placeOf(regions[i], captureInfo, allPixels));
  }
  if (!frame) return;
  const bool isWhole = jumping >= kJumpWholeShare * measured;
  Finding finding = faultFinding(isWhole ? Fault::PreviousIdentity : Fault::OldTransformOnReturn);
  finding.isWholePicture = isWhole;
  finding.regions = std::move(places);
  finding.confidence = Confidence::Likely;
  finding.reason = say<"In frame %1 alone motion is much longer than before and after, and the motion of the "
                       "frame beside it fits the pixels better.">(captureInfo.frameNames.of(*frame));
  finding.change = jumpChange(isWhole);
  if (isWhole) correctBy(inFrame(*frame), finding);
  out.findings.push_back(std::move(finding));
}

} // namespace taa::doctor
