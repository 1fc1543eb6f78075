// Optical flow: what squares of the picture move by, measured from two pictures. Motion that is given is one
// of the places where the search begins, and is kept where it fits as well as any other; where it does not,
// it has no part.
#pragma once

#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace taa::doctor {

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

  /// Motion given is what depth and matrices make of what rests there: a light or a reflection may move over
  /// it.
  bool isOfCamera = false;
  std::optional<glm::dvec2> camera; ///< what that is, px; nothing where it is not known

  double offPx() const;
  /// Whether pictures refute the motion given, by more than `tolerancePx` and by more than chance.
  bool refutesGiven(double tolerancePx) const;
};

/// Of a pair of frames.
struct FlowPair {
  int frame = 0; ///< the later one
  std::vector<FlowSquare> squares;
  /// By region: of the squares well inside it, the share whose motion pictures say.
  std::map<RegionIndex, double> said;
  std::size_t asked = 0; ///< squares that were looked for; those that were found are `squares`
};

/// Squares whose motion pictures say: nearly all that is seen there must have been in the frame before.
/// Evenly of all regions: kMaxFlowSquares, and four of each where there are many. `labels`: regions of
/// `frames.now`. Motion has to be known.
FlowPair measureFlow(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels);
inline constexpr std::size_t kMaxFlowSquares = 256;

/// measured = factors · given + offset, by least squares over the squares that follow it.
struct FlowFit {
  glm::dmat2 factors{1.0}; ///< column-major, as GLM has it
  glm::dvec2 offsetPx{0.0};
  glm::dmat2 factorErrors{0.0}; ///< standard errors of each
  glm::dvec2 offsetErrorsPx{0.0};
  std::size_t squares = 0, followed = 0; ///< that were asked; that lie within the tolerance

  /// Whether nearly all follow it, and its numbers are known to a twentieth.
  bool isGood() const;
};

/// `tolerancePx`: to which squares follow it. Nothing where there are too few. With `isThroughZero` there is
/// no offset; where the motion given is along one line, it is one factor for both axes then, else nothing.
std::optional<FlowFit> fitFlow(const std::vector<const FlowSquare*>& squares, bool isThroughZero,
                               double tolerancePx);
/// One factor for both axes, without an offset.
std::optional<FlowFit> fitFactor(const std::vector<const FlowSquare*>& squares, double tolerancePx);

} // namespace taa::doctor
