// Motion that is given against what pictures move by: the last word on whether what was found explains what
// is seen. Where nothing does, that is a finding.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/flow/Refuted.h"

namespace taa::doctor {

/// What was told of motion and jitter before.
struct FlowCaptureInfo {
  const CaptureInfo& captureInfo;
  bool isMotionCorrected = false; ///< by one explanation for the whole picture, which was told
  bool isJitterOpen = false;      ///< by a pixel or so motion may be off, then
};

/// Whether pictures move as depth and matrices make what rests move, where the motion given is another one:
/// of the four, motion is the one that is wrong.
bool isDepthConfirmed(const FlowSeen& seen);
/// Whether they move as the motion given there: depth or matrices are wrong.
bool isMotionConfirmed(const FlowSeen& seen);

/// Adds findings, by what is measured where it can be, of the regions that pictures refute, and takes back
/// those that pictures refute. `asGiven`: of the frames as they are; `corrected`: as they are once all that
/// was told is right.
void tellFlow(const FlowSeen& asGiven, const FlowSeen& corrected, const FlowCaptureInfo& captureInfo,
              Diagnosis& out);

} // namespace taa::doctor
