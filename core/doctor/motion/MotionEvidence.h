// How well each explanation of a region's motion fits the region's own pixels: the frame before, read where
// the explanation says that a pixel was, against the pixel now.
#pragma once

#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionCentroids.h"
#include "core/doctor/motion/MotionConsistency.h"
#include "core/doctor/motion/MotionOutlines.h"
#include "core/doctor/motion/MotionTrials.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::doctor {

/// An explanation against the motion given, at the pixels where the two lead to different places.
struct TrialEvidence {
  std::size_t pixels = 0;              ///< of all pairs of frames
  std::size_t asked = 0, said = 0;     ///< pixels with detail, and those of which it says where they were
  double given = 0.0, tried = 0.0;     ///< sums of |luma − luma of the frame before| there
  std::size_t cells = 0, cellsWon = 0; ///< squares of the picture in which pixels differ; won: by the trial
  std::size_t pairs = 0, pairsWon = 0; ///< likewise pairs of frames

  /// By how much the trial leaves less, over the region's pixels; comparable between trials: what it says
  /// nothing of counts as what it does.
  double gain() const {
    return said == 0 ? given - tried
                     : (given - tried) * static_cast<double>(asked) / static_cast<double>(said);
  }
};

/// The pixel of a region that moves most, and what it would move by under each trial; of a region without
/// pixels well inside it any of them.
struct MotionExample {
  int frame = 0;
  glm::ivec2 pixel{0};
  float lengthPx =
      -1.0f; ///< of the motion given or the camera's, whichever is longer; below 0: there is none
  glm::vec2 given{0.0f};
  std::vector<std::optional<glm::vec2>> byTrial; ///< as motionTrials()
};

/// Vectors of which it is asked whether all are alike.
struct EvenVectors {
  std::size_t count = 0;
  glm::dvec2 sum{0.0};
  double squares = 0.0;

  void add(const glm::dvec2& vector) {
    ++count;
    sum += vector;
    squares += vector.x * vector.x + vector.y * vector.y;
  }
  /// Root of the mean squared distance from their mean, as a share of its length; infinite where that is 0.
  double spread() const;
};

/// An explanation against the motion given in one pair of frames, at the pixels where the two lead to
/// different places; without depth, both of the same region: what was behind something else says nothing.
struct TrialOfPair {
  std::size_t pixels = 0;
  double given = 0.0, tried = 0.0; ///< as TrialEvidence
  glm::ivec2 pixel{0};             ///< the one at which it leaves most less than the motion given …
  float gained = 0.0f;             ///< … by this

  void add(const glm::ivec2& at, float leftGiven, float leftTried) {
    ++pixels;
    given += static_cast<double>(leftGiven);
    tried += static_cast<double>(leftTried);
    if (leftGiven - leftTried <= gained) return;
    gained = leftGiven - leftTried;
    pixel = at;
  }
};

/// One pair of frames of a region.
struct PairTrace {
  int frame = 0;          ///< the later one
  std::size_t pixels = 0; ///< with a motion that leads into the picture
  double lengthPx = 0.0;  ///< sum of their motions' lengths
  /// Pixels at which the motion of the frame before, or after, is another one, and what it and the motion
  /// given leave there: of the two, which leaves less.
  std::size_t compared = 0;
  double given = 0.0, tried = 0.0;
  std::vector<TrialOfPair> trials = {}; ///< as motionTrials()

  double meanPx() const { return pixels == 0 ? 0.0 : lengthPx / static_cast<double>(pixels); }
};

/// Of one region, over all pairs of frames.
struct RegionEvidence {
  std::size_t pixels = 0;   ///< well inside the region, with a motion that leads into the picture
  std::size_t textured = 0; ///< of these: with detail that tells one place from another. The rest is of them:
  std::size_t pairs = 0;    ///< of frames
  double texturedError = 0.0; ///< sum of |luma − luma of the frame before| over `textured`, as given
  double givenPx = 0.0, cameraPx = 0.0; ///< sums of lengths of motion as given, of the camera
  std::size_t zero = 0;                 ///< motion given is exactly 0
  std::size_t ofCamera = 0; ///< it is that of the camera, which also rests there: see kSameMotionPx
  /// Pixels at the region's silhouette, where motion is searched for, that lay elsewhere in the frame before:
  /// as given, and by what was found. A light that moves over a surface takes no silhouette with it.
  std::size_t silhouetteGiven = 0, silhouetteFound = 0;
  std::size_t cameraKnown = 0;
  /// Motion given less the camera's, px, and times the distance of what is seen, px m.
  EvenVectors offCamera, offCameraByDistance;
  std::size_t seen = 0; ///< pixels well inside the region, whatever their motion
  /// Of these: with a motion that is longer than the picture; that is the same as the first of these.
  std::size_t outside = 0, marks = 0;
  glm::vec2 mark{0.0f};           ///< that motion
  std::size_t marked = 0;         ///< likewise: with the mark of no previous position; the rest is of these:
  std::size_t markedTextured = 0; ///< with detail
  double markedError = 0.0;    ///< sum of |luma − luma of the frame before| there, at rest in the world …
  double markedPx = 0.0;       ///< … and of the lengths of motion that this is, where cameras are known
  std::size_t markedPairs = 0; ///< of frames
  std::vector<TrialEvidence> trials; ///< as motionTrials()
  /// What squares of the region truly move by, by searchMotion(), where motion given is 0 or the camera's.
  TrialEvidence found;
  glm::dvec2 foundPx{0.0}; ///< sum over the pixels of `found`
  MotionExample example;
  std::vector<PairTrace> traces;
  ConsistencyEvidence consistency;
  OutlineEvidence outline;
  MiddleEvidence middle;
};

/// px: a motion is the camera's where it differs by less, or by less than a thousandth; half floats do.
inline constexpr float kSameMotionPx = 0.05f;
bool isSameMotion(const glm::vec2& a, const glm::vec2& b);

struct WayShare {
  double share = 1.0;
  /// False: the camera moves aside, and so evenly that another one that stands beside it makes the same.
  bool isClear = false;
};

class MotionEvidence {
 public:
  explicit MotionEvidence(const glm::ivec2& sizePx);

  /// Adds a pair of frames that is not cut. `labels`: regions of `frames.now`; likewise of `frames.before`.
  void add(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels,
           const std::vector<RegionIndex>& labelsBefore);

  const std::vector<MotionTrial>& trials() const { return trials_; }
  /// By region; those never seen have no pixels.
  const std::vector<RegionEvidence>& regions() const { return regions_; }
  const std::vector<PairConsistency>& pairs() const { return pairs_; }
  /// How much of the camera's way is in motion, where that is the same in nearly all pairs.
  std::optional<WayShare> wayShare() const;

 private:
  std::vector<MotionTrial> trials_;
  std::vector<RegionEvidence> regions_;
  std::vector<PairConsistency> pairs_;
  std::vector<double> wayShares_, movedBy_; ///< of pairs that have one
  std::size_t aside_ = 0;                   ///< of these: along the picture's x
  std::size_t moved_ = 0;                   ///< pairs that a previous camera beside this one explains
  MotionCentroids centroids_;
};

} // namespace taa::doctor
