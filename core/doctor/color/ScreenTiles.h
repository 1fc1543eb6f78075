// Squares of the picture, and what the edges in each do from frame to frame: they move as they are said to,
// or they rest on the screen, with the jitter or without.
#pragma once

#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace taa::doctor {

inline constexpr int kTilePx = 8; ///< a side of a square

/// Over pixels at edges: sums of |luma − luma of the frame before|, read where each explanation says.
struct TileSums {
  std::size_t pixels = 0;
  std::size_t atSilhouette = 0; ///< of these: beside another region
  double inPlace = 0.0;         ///< at the same pixel
  double jittered = 0.0;        ///< the same but for jitter
  double asGiven = 0.0;         ///< by the motion given
  double unjittered = 0.0;      ///< the same as if there were no jitter
  double ofWorld = 0.0;         ///< by what rests in the world moves by, where that is known; else as given
  double ofWorldUnjittered = 0.0;
  double worldPx = 0.0; ///< lengths of that motion
  double givenPx = 0.0; ///< lengths of the motion given

  /// What the better one of both motions leaves.
  double moving() const { return asGiven < ofWorld ? asGiven : ofWorld; }
  /// The same motion as if there were no jitter.
  double movingUnjittered() const { return asGiven < ofWorld ? unjittered : ofWorldUnjittered; }
  void add(const TileSums& other);
};

struct ScreenTile {
  int pairs = 0; ///< of frames, with edges along both axes. Of these:
  int fixed = 0; ///< nothing changes in place
  int changing = 0;
  /// What rests but for jitter leaves less than what rests without and than the motion given; and less than
  /// the motion of what rests in the world, too.
  int jittered = 0, jitteredOfAll = 0;
  TileSums sums;

  /// px a frame, the longer one of both motions.
  double meanPx() const {
    const double px = sums.worldPx > sums.givenPx ? sums.worldPx : sums.givenPx;
    return sums.pixels == 0 ? 0.0 : px / static_cast<double>(sums.pixels);
  }
  /// px a frame of the one that fits better.
  double fittingPx() const {
    const double px = sums.asGiven < sums.ofWorld ? sums.givenPx : sums.worldPx;
    return sums.pixels == 0 ? 0.0 : px / static_cast<double>(sums.pixels);
  }
  double meanWorldPx() const {
    return sums.pixels == 0 ? 0.0 : sums.worldPx / static_cast<double>(sums.pixels);
  }
};

/// Over all pairs of frames.
struct ScreenTiles {
  glm::ivec2 sizePx{0}, counts{0};  ///< of the picture; columns and rows
  std::vector<ScreenTile> tiles;    ///< row by row
  std::vector<RegionIndex> labels;  ///< regions of the pixels of the frame added last …
  RegionIndex sky = kNoRegion;      ///< … the one that is the sky …
  int frame = 0;                    ///< … and its number
  int pairs = 0, jitteredPairs = 0; ///< of frames; those whose jitter differs

  /// Expects frames of one size. `labels`: of `frames.now`.
  void add(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels);
};

} // namespace taa::doctor
