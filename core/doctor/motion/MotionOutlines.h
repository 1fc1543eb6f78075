// How well each explanation of a region's motion fits its outline: a pixel of it that by an explanation lay
// outside of it a frame ago, with nothing nearer before it, speaks against that. It needs no detail.
#pragma once

#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionTrials.h"

#include <cstddef>
#include <map>
#include <vector>

namespace taa::doctor {

/// An explanation against the motion given, at pixels near the region's silhouette where the two lead to
/// different places.
struct OutlineCounts {
  std::size_t pixels = 0;
  std::size_t given = 0, tried = 0;    ///< of these: outside, between four pixels that are
  std::size_t pairs = 0, pairsWon = 0; ///< pairs of frames in which these differ; won: by the explanation

  void add(const OutlineCounts& other);
};

/// Of one region.
struct OutlineEvidence {
  /// As motionTrials(); empty: no outline was seen. Nothing is counted of jitter left in motion: outlines may
  /// have another one than is stated themselves.
  std::vector<OutlineCounts> trials;
  /// What the middle of the region moves by, where all of it is seen in both frames.
  OutlineCounts found;
  /// Of its pixels: sums of squares of that motion less the one given, of the step of jitter, and of their
  /// product.
  double offSquares = 0.0, jitterSquares = 0.0, offByJitter = 0.0;

  void add(const OutlineEvidence& other);
  /// Whether it is off by a factor of the jitter: then outlines have another one than is stated, and nothing
  /// moves.
  bool isOffByJitter() const;
};

/// Of one pair of frames, by region: of those that are objects by their number.
std::map<RegionIndex, OutlineEvidence> outlinesOf(const FrameNeighbors& frames,
                                                  const std::vector<MotionTrial>& trials,
                                                  const std::vector<RegionIndex>& labels,
                                                  const std::vector<RegionIndex>& labelsBefore);

/// Explanations that fit the outline, and the motion given does not: those that nothing tells apart, simple
/// ones first.
std::vector<std::size_t> outlineWinners(const OutlineEvidence& evidence);
/// Whether an explanation leads out of an outline that the motion given fits.
bool breaksOutline(std::size_t trial, const OutlineEvidence& evidence);
/// Whether the middle of the region says how it moves, and the motion given does not fit.
bool isOutlineFoundElsewhere(const OutlineEvidence& evidence);

} // namespace taa::doctor
