// What the pixels of a region say of its motion, with a rule that rather says nothing than something wrong.
#pragma once

#include "core/doctor/motion/MotionEvidence.h"
#include "core/settings/Faults.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace taa::doctor {

enum class MotionVerdict : std::uint8_t {
  Right,        ///< motion given fits, and another would not
  Wrong,        ///< an explanation fits, and motion given does not
  TooSmall,     ///< undecided, as all below: too few pixels or frames
  Still,        ///< no explanation leads elsewhere
  NoTexture,    ///< no detail
  Contradicted, ///< neither motion given nor an explanation fits
  Doubtful,     ///< an explanation fits better, but not clearly
};

/// What a decision rests on.
enum class DecidedBy : std::uint8_t {
  Pixels,    ///< and, where they say more than pixels can, depth and matrices
  Outline,   ///< where the region lay
  Centroids, ///< what the centroids of all small objects together move by
};

struct MotionDecision {
  MotionVerdict verdict = MotionVerdict::TooSmall;
  /// Of Wrong: indices of the explanations that these frames cannot tell apart, simple ones first; none: what
  /// searchMotion() found fits, and no trial.
  std::vector<std::size_t> explanations;
  DecidedBy by = DecidedBy::Pixels;
};

/// A trial has to leave much less than motion given does, in nearly all squares of the picture and pairs of
/// frames in which the two differ. Where depth and cameras make the motion given, only rest on the screen and
/// what searchMotion() found can contradict it. Where pixels do not tell, outlines do. `trials`: those of the
/// evidence.
MotionDecision decideMotion(const RegionEvidence& evidence, const std::vector<MotionTrial>& trials);
/// By pixels alone: where silhouettes have the motion of what is beside, outlines say nothing.
MotionDecision decideByPixels(const RegionEvidence& evidence, const std::vector<MotionTrial>& trials);

/// Whether motion given is 0 nearly everywhere.
bool isUnwritten(const RegionEvidence& evidence);
/// Whether it is that of the camera, which is known and moves.
bool isConfirmed(const RegionEvidence& evidence);
/// Whether depth and cameras say that it rests on the screen if it rests in the world.
bool isAtRestInWorld(const RegionEvidence& evidence);
/// Which camera made motion that is not that of the frame's: one that is turned, by which everything moves by
/// the same besides, or one beside it, by what is in inverse ratio to the distance. Nothing: neither.
std::optional<Fault> wrongCamera(const RegionEvidence& evidence);

} // namespace taa::doctor
