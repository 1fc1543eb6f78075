// Whether pictures hold the jitter that is stated for them: sign, axes, length, unit, frame, or none at all.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/jitter/JitterTrials.h"

#include <glm/vec2.hpp>

#include <functional>
#include <optional>

namespace taa::doctor {

/// What pictures hold at a frame, px, where that is not what is stated.
using JitterCorrector = std::function<std::optional<glm::vec2>(int frame)>;

struct JitterOutcome {
  JitterCorrector corrector; ///< empty where nothing is to be corrected
  /// Pictures shift as neither what is stated nor anything else that was tried makes them.
  bool isContradicted = false;
  bool isOpen = false; ///< it is not decided what jitter pictures hold
};

/// Whose jitter it is.
struct JitterCaptureInfo {
  const CaptureInfo& captureInfo;
  bool isCameraKnown = true;           ///< shifts do not rest on motion vectors
  std::optional<RegionPlace> sky = {}; ///< none: there is none
  /// Asked where pictures hold no jitter: see areSurfacesJittered(). Empty: nobody knows.
  std::function<bool()> areSurfacesJittered = {};
};

/// Whether depth shifts from frame to frame as the jitter that is stated: surfaces are drawn with it,
/// whatever is seen on them. `evidence`: of frames whose luma is asDepthPicture()'s.
bool areSurfacesJittered(const JitterEvidence& evidence);
/// Depth as light, 0 to 1: what is in the middle of all that is drawn has a half. Expects depth.
Image asDepthPicture(const DoctorFrame& frame);

/// What a trial says is wrong, which is no twofold one, and what to change; without what it rests on.
Finding jitterFinding(const JitterTrial& trial);

/// Adds what is wrong, right, or not decided about jitter.
JitterOutcome tellJitter(const JitterEvidence& evidence, const JitterCaptureInfo& captureInfo,
                         Diagnosis& out);

} // namespace taa::doctor
