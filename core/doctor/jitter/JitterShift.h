// How far a picture is shifted against the one before it, besides motion: what jitter does to both, measured
// by least squares.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/motion/MotionSearch.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace taa::doctor {

/// Pixels with detail, and where they were in the frame before but for jitter: warped by the camera's motion
/// where that is known, so that motion vectors have no part in it, else by the motion given. No place is so
/// near the border that a shift of kFarthestShiftPx leads out of the picture.
struct ShiftSamples {
  std::vector<SearchedPixel> world, sky;
  double skyShare = 0.0;  ///< of the picture, with detail or without
  double longestPx = 0.0; ///< of the motions that they are warped by
  bool isSparse = false;  ///< little of the world has detail
};
inline constexpr float kFarthestShiftPx = 3.5f;

ShiftSamples shiftSamples(const FrameNeighbors& frames);
/// Whether there are enough to measure a shift by.
bool areEnough(const std::vector<SearchedPixel>& samples);

/// What a shift leaves: the median of |luma − luma of the frame before|. Expects samples.
double lumaLeft(const std::vector<SearchedPixel>& samples, const Image& previousLuma,
                const glm::vec2& shiftPx);

/// px: the place of a pixel in the frame before is its center − motion + this. Jitters j of this frame and j'
/// of the one before make it j' − j. What moves by itself counts as outliers. Nothing where there is too
/// little detail.
std::optional<glm::vec2> measureShift(const std::vector<SearchedPixel>& samples,
                                      const FrameNeighbors& frames);

/// The share of the jitter that is stated by which the samples are shifted, besides motion: 1 as stated, 0
/// not at all. A gradient is enough, but for one across the jitter. Nothing where other shares leave hardly
/// more.
std::optional<double> measureShare(const std::vector<SearchedPixel>& samples, const FrameNeighbors& frames);

} // namespace taa::doctor
