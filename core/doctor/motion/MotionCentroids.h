// What the centroids of objects move by: an object that is seen whole takes its middle with it. From frame to
// frame that is known to a part of a pixel alone, but over many frames ways add up, and so do motions.
#pragma once

#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace taa::doctor {

/// An explanation against the motion given, in objects and frames up to which the two have led them to
/// different places.
struct MiddleCounts {
  std::size_t samples = 0, won = 0; ///< objects in frames; won: of which the explanation is nearer
  /// Sums, px: how far the motions of an object's pixels, added up in their mean, are from the way of its
  /// middle, as given and by the explanation; the length of that way.
  double given = 0.0, tried = 0.0, moved = 0.0;

  void add(const MiddleCounts& other);
};

/// Of one object, or of many.
struct MiddleEvidence {
  std::vector<MiddleCounts> trials; ///< as motionTrials(); empty: none was seen whole
  glm::ivec2 pixel{-1};             ///< of one object: one of its pixels in the frame added last

  void add(const MiddleEvidence& other);
};

/// Pairs of frames one after another.
class MotionCentroids {
 public:
  /// By region: of those that are objects by their number, that nothing nearer and no border cuts, for as
  /// long as they keep their size. Explanations are those that change the value given: what turns has another
  /// motion than its middle, and no factor, sign, axis or unit undoes that; and the camera's motion, of what
  /// rests in the world. Needs object numbers and depth.
  std::map<RegionIndex, MiddleEvidence> add(const FrameNeighbors& frames,
                                            const std::vector<MotionTrial>& trials,
                                            const std::vector<RegionIndex>& labels,
                                            const std::vector<RegionIndex>& labelsBefore);

 private:
  /// Of an object, since it is seen whole.
  struct Way {
    double sizeAtStart = 0.0; ///< pixels
    double offPx = 0.0;       ///< that its middle may be off by for how its size has changed
    double spreadPx = 0.0;    ///< sum, of frames, of what the motions of its pixels differ by
    glm::dvec2 px{0.0};
    std::vector<std::optional<glm::dvec2>> motions; ///< by trial; none: it says nothing of a frame
  };
  std::map<RegionIndex, Way> ways_;
  int frame_ = -1; ///< they lead to
};

/// Explanations of how objects move that the motion given does not fit, simple ones first; those that nothing
/// tells apart.
std::vector<std::size_t> middleWinners(const MiddleEvidence& evidence);

} // namespace taa::doctor
