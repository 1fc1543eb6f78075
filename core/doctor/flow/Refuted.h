// Regions whose motion pictures refute, and the frames in which they do.
#pragma once

#include "core/doctor/flow/Flow.h"
#include "core/doctor/frames/Regions.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace taa::doctor {

/// What was measured of frames, and the regions of these.
struct FlowSeen {
  const std::vector<FlowPair>& pairs;
  const std::vector<Region>& regions;
};

/// Of a region's squares in a pair of frames: so many make the pair, else a light moves over it.
inline constexpr double kMostSquares = 0.6;
inline constexpr std::size_t kEnoughRefutingSquares = 8;

/// A region whose motion pictures refute.
struct Refuted {
  const Region* region = nullptr;
  std::vector<int> frames;                ///< in which they do
  std::vector<int> asked;                 ///< in which its motion was measured
  std::vector<const FlowSquare*> squares; ///< of these frames, all that were measured …
  std::vector<const FlowSquare*> ofAll;   ///< … and of all frames
};

/// `tolerancePx`: by which motion may be off.
std::vector<Refuted> refutedRegions(const FlowSeen& seen, double tolerancePx);
/// Of the whole picture, whose squares are all alike wrong.
Refuted wholePicture(const FlowSeen& seen);

/// Frames of which nearly all that was measured moves otherwise than is given, whatever depth and matrices
/// say: no light moves over all of the picture. Empty where that is so of most frames.
Refuted wholeFrames(const FlowSeen& seen, double tolerancePx);

/// Of the pair that a square of `seen` is of.
int frameOf(const FlowSquare& square, const FlowSeen& seen);

std::vector<const FlowSquare*> squaresOf(const std::vector<Refuted>& refuted);
/// Frames of any of them: in which they are refuted, and that were asked.
std::pair<std::vector<int>, std::vector<int>> framesOf(const std::vector<Refuted>& refuted);

} // namespace taa::doctor
