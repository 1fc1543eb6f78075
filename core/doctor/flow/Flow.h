// Optical flow: what squares of the picture move by, measured from two pictures. Motion that is given is one
// of the places where the search begins, and is kept where it fits as well as any other; where it does not,
// it has no part.
#pragma once

#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace taa::doctor {

inline constexpr double kChanceErrors = 4.0; ///< standard errors that are no chance

/// A square well inside a region, with detail along both axes.
struct FlowSquare {
  glm::ivec2 pixel{0}; ///< its middle
  RegionIndex region = kNoRegion;
  glm::dvec2 px{0.0};    ///< measured motion, current − previous, without the jitter that is stated
  double errorPx = 0.0;  ///< its standard error, along the axis with less detail
  glm::dvec2 given{0.0}; ///< motion given there, px
  /// Means of |luma − luma of the frame before| as measured and as given; infinite where that leads out of
  /// the picture.
  double left = 0.0, leftAsGiven = 0.0;
  /// Mean of |luma − luma of now where what was measured would have what the motion given leads to|: about
  /// `leftAsGiven` if what was measured is so, and less if the picture repeats by that much.
  double apart = 0.0;

  std::optional<glm::dvec2> camera; ///< what depth and matrices make of what rests there, px
  /// What it would move by under each of motionTrials(), px; not a number where one says nothing.
  std::vector<glm::vec2> byTrial;

  /// Whether that is what is given: a light or a reflection may move over it.
  bool isOfCamera() const;
  double offPx() const;
  /// Whether pictures refute the motion given, by more than `tolerancePx` and by more than chance.
  bool refutesGiven(double tolerancePx) const;
};

/// Means over the pixels of a region in a frame, px.
struct RegionMeans {
  glm::dvec2 middle{0.0}, given{0.0}; ///< of places; of motion where it is known
  std::optional<glm::dvec2> camera;   ///< where it is known of all that was looked at
  double distance = 0.0;              ///< m; 0: no depth tells
  bool isWhole = true;                ///< no border cuts it
};

/// Of a pair of frames.
struct FlowPair {
  int frame = 0; ///< the later one
  std::vector<FlowSquare> squares;
  /// By region: of the squares well inside it, the share whose motion pictures say.
  std::map<RegionIndex, double> said;
  std::map<RegionIndex, RegionMeans> means;
  std::size_t asked = 0; ///< squares that were looked for; those that were found are `squares`
};

/// Squares whose motion pictures say: nearly all that is seen there must have been in the frame before.
/// Evenly of all regions: kMaxFlowSquares, and four of each where there are many. `labels`: regions of
/// `frames.now`; `trials`: motionTrials(). Motion has to be known.
FlowPair measureFlow(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels,
                     const std::vector<MotionTrial>& trials);
inline constexpr std::size_t kMaxFlowSquares = 256;

} // namespace taa::doctor
