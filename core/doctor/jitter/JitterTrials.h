// Explanations of what the stated jitter is instead of what it is said to be, and how well pictures fit each.
#pragma once

#include "core/doctor/jitter/JitterShift.h"
#include "core/doctor/jitter/RestingPictures.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {

/// What the stated jitter is, beside what pictures hold.
enum class JitterKind : std::uint8_t {
  AsStated,
  NotApplied, ///< pictures hold none
  MirroredX,
  MirroredY,
  Opposite,
  SwappedAxes,
  Scaled,     ///< too long or too short by a factor, or one for each axis
  OtherUnit,  ///< by a factor that the picture's size explains
  FrameLate,  ///< it is that of the frame before
  FrameEarly, ///< it is that of the frame after
};

struct JitterTrial {
  JitterKind kind = JitterKind::AsStated;
  glm::vec2 factor{1.0f};                 ///< of Scaled, OtherUnit: pictures hold the stated jitter times it
  JitterKind also = JitterKind::AsStated; ///< besides, where that is twofold: FrameLate, FrameEarly

  bool isTwofold() const { return also != JitterKind::AsStated; }
};

/// What the trials leave of a pair of frames, see lumaLeft(); as jitterTrials(), NaN where one says nothing.
using TrialLuma = std::vector<double>;

/// What was gathered over all frames.
struct JitterEvidence {
  struct Shift {
    int frame = 0; ///< that of the later frame of a pair
    glm::vec2 px{0.0f};
  };
  std::map<int, glm::vec2> stated;   ///< px, displacement of content, by frame
  std::vector<Shift> shifts;         ///< measureShift()
  std::vector<double> skyShares;     ///< measureShare() of the sky
  int pairs = 0;                     ///< that were tried to measure
  std::vector<TrialLuma> world, sky; ///< of pairs that have detail enough there
  double skyShare = 0.0;             ///< of the pictures, summed over pairs
  /// Where the world rests: sixteenths of the pictures that have detail enough by themselves, summed over
  /// pairs; and of these: that fit the jitter that is stated clearly better than none.
  std::size_t parts = 0, shiftingParts = 0;
  RestingPictures resting;

  void add(const FrameNeighbors& frames);
};

/// Two frames one after the other: the jitters that are stated, and the shift that is measured, px.
struct ShiftPair {
  int frame = 0; ///< the later one
  glm::dvec2 before{0.0}, now{0.0}, shift{0.0};
};
/// Those whose jitters are both stated.
std::vector<ShiftPair> shiftPairs(const JitterEvidence& evidence);

/// AsStated first, NotApplied, then all others for pictures of a size; twofold ones last.
std::vector<JitterTrial> jitterTrials(const glm::ivec2& sizePx);
inline constexpr std::size_t kNotAppliedTrial = 1;
std::string jitterTrialId(const JitterTrial& trial);
std::string jitterTrialText(const JitterTrial& trial);

/// What pictures hold at a frame if the trial is right, px; nothing where no frame states it.
std::optional<glm::vec2> trueJitter(const JitterTrial& trial, const std::map<int, glm::vec2>& stated,
                                    int frame);
/// How far the measured shifts are from those that the trial makes, px: half of the pairs are nearer, since
/// some are measured wrong where much moves; infinite where it says nothing.
double shiftResidual(const JitterTrial& trial, const JitterEvidence& evidence);

} // namespace taa::doctor
