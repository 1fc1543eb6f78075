// Time is not averaged away: regions whose motion is wrong in some frames or in a part of them, and what
// makes it right there. Over all frames and pixels the others outweigh them.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionEvidence.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::doctor {

/// Frames in which pictures say of a region that an explanation is right and the motion given is not.
struct WonPairs {
  std::size_t trial = 0;           ///< of motionTrials()
  std::vector<int> frames, asked;  ///< these; those in which the two lead to different places
  std::size_t pixels = 0;          ///< of `frames`: in which they do
  double given = 0.0, tried = 0.0; ///< sums of |luma − luma of the frame before| there
  int frame = 0;                   ///< the one with the most to gain …
  glm::ivec2 pixel{0};             ///< … and a pixel there

  double gain() const { return given - tried; }
  bool areNearlyAll() const;
};

/// By the explanation that gains most. Nothing: none wins enough pixels clearly.
std::optional<WonPairs> wonPairs(const RegionEvidence& evidence, const std::vector<MotionTrial>& trials);

/// A finding for each thing that is wrong, of regions of whose motion nothing is told.
void tellPairs(const MotionEvidence& evidence, const std::vector<Region>& regions,
               const CaptureInfo& captureInfo, Diagnosis& out);

} // namespace taa::doctor
