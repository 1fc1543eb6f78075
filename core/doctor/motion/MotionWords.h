// The sentences of findings about motion: what is wrong, what one sees, and what to change.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/motion/MotionDecision.h"
#include "core/doctor/motion/MotionFindings.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace taa::doctor {

/// What is said of a fault of motion.
struct FaultWords {
  std::string id;              ///< of the table of faults where that has it
  std::string name;            ///< as a heading
  std::string symptom, change; ///< sentences
};

/// `trial`: what explains it; null: the pixels move as no explanation says. `areCamerasRight`: elsewhere the
/// motion given is that of the cameras.
FaultWords motionFault(const MotionTrial* trial, const Region& region, const RegionEvidence& evidence,
                       const FrameNames& names = {}, bool areCamerasRight = false);

/// Gives a finding the words of a fault.
/// Of motion that is longer or shorter, or turned, by what no row of the table says.
FaultWords lengthWords(std::string change);
FaultWords turnedWords(std::string change);
/// Id and words of what none of the known mistakes explains.
inline constexpr std::string_view kUnknownMotionId = "motionUnknown";
FaultWords unknownMotion();

void nameBy(const FaultWords& fault, Finding& out);

/// Of another unit: what is wrong with direction and axes besides, as a trial of its own; nothing: nothing
/// is. Where a capture states its axes, they are no part of a unit.
std::optional<MotionTrial> axesBesideUnit(const MotionTrial& trial, const CaptureInfo& captureInfo);
/// The unit without that.
MotionTrial unitAlone(const MotionTrial& trial, const MotionTrial& axes);

/// What the engine stores for a motion in px, current − previous, by its conventions.
glm::dvec2 storedMotion(const CaptureInfo& captureInfo, const glm::dvec2& motionPx);
/// A sentence with numbers: what is stored at a pixel and what it should be, as the engine writes motion.
/// Empty where the trial says nothing there.
std::string motionExample(const CaptureInfo& captureInfo, const RegionEvidence& evidence, std::size_t trial);

/// Depth and matrices make something of the motion given of some regions that pixels contradict. `names`:
/// theirs. `isMisfit`: nothing else says that these are right.
Undecided contradictedMatrices(const MotionTrial& trial, const std::string& names, bool isMisfit);
/// A sentence why a region's motion is not decided, and what to capture instead.
Undecided undecidedMotion(MotionVerdict verdict, const RegionPlace& place, const RegionEvidence& evidence);

} // namespace taa::doctor
