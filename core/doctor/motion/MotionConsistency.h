// What depth and matrices say of motion: which explanation makes the camera's motion of the motion given, to
// the precision that it is stored with, where pixels alone could not tell parts of a pixel.
#pragma once

#include "core/doctor/motion/MotionTrials.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace taa::doctor {

/// Distances, px, counted by halves of an octave.
class DistanceCounts {
 public:
  void add(float distancePx);
  void add(const DistanceCounts& other);
  std::size_t count() const { return count_; }
  double medianPx() const; ///< the upper end of its half octave; infinite of none
  std::size_t upTo(double distancePx) const;

 private:
  static constexpr std::size_t kHalfOctaves = 44;
  static double endPx(std::size_t bin); ///< from 2^-12 px
  std::array<std::uint32_t, kHalfOctaves> counts_{};
  std::size_t count_ = 0;
};

/// Of a region, over all pairs of frames.
struct ConsistencyEvidence {
  /// By motionTrials(): how far the motion that each makes of the one given is from the camera's, beyond what
  /// half floats round, at pixels well inside the region.
  /// Of all of them for the motion given, of those `apart` for all others.
  std::vector<DistanceCounts> trials;
  std::size_t apart = 0; ///< pixels whose motion given is not the camera's
  /// Of these: how far the motion given is from the camera's if matrices are upside down.
  DistanceCounts flipped;
  /// Pixels of all of the region, its silhouette too, whose motion given is not the camera's, and of these:
  /// those that showed another region in the frame before, at which the frame after has the motion of the
  /// camera of now.
  std::size_t off = 0, offLate = 0;
  std::set<int> lateFrames; ///< in which any are `offLate`
};

/// Of a pair of frames: pixels well inside regions.
struct PairConsistency {
  int frame = 0;              ///< the later one
  std::size_t known = 0;      ///< pixels whose camera's motion is known; of these:
  std::size_t off = 0;        ///< those with another motion, or marked as without one
  std::size_t ofIdentity = 0; ///< those with the motion that a matrix that was never set makes, or marked
};

/// Adds a pixel well inside a region.
void addConsistency(ConsistencyEvidence& out, const std::vector<MotionTrial>& trials,
                    const FrameNeighbors& frames, const glm::ivec2& pixel);
/// The counts of silhouettes alone.
void addSilhouettes(const ConsistencyEvidence& of, ConsistencyEvidence& out);
/// Adds any pixel of a region to `off` and `offLate`. `wasOther`: it showed another one in the frame before.
void addSilhouetteConsistency(ConsistencyEvidence& out, const FrameNeighbors& frames, const glm::ivec2& pixel,
                              bool wasOther);
/// Adds a pixel well inside a region.
void addConsistency(PairConsistency& out, const FrameNeighbors& frames, const glm::ivec2& pixel);
/// The only frame in which motion is that of a matrix that was never set, where in the others it is not.
std::optional<int> identityFrame(const std::vector<PairConsistency>& pairs);

enum class ConsistencyVerdict : std::uint8_t {
  Unknown,   ///< too few pixels, or no depth and matrices
  OfCamera,  ///< motion given is the camera's
  Explained, ///< it is not, and some explanations make it so
  Apart,     ///< it is not, and none does: it moves by itself
};

struct ConsistencyDecision {
  ConsistencyVerdict verdict = ConsistencyVerdict::Unknown;
  std::vector<std::size_t> explanations; ///< of Explained: all that fit as well, in the order of the trials
};

/// Where an explanation without a free number fits, one that was fitted says nothing. `trials`:
/// motionTrials().
ConsistencyDecision decideConsistency(const ConsistencyEvidence& evidence,
                                      const std::vector<MotionTrial>& trials);
/// Whether matrices that are upside down make the motion given of what rests, and nothing that could be wrong
/// with motion does. `regions`: of the whole picture.
bool areMatricesFlipped(const std::vector<const ConsistencyEvidence*>& regions,
                        const std::vector<MotionTrial>& trials);
/// Whether it has free numbers that were fitted.
bool isFitted(const MotionTrial& trial);
/// Whether an explanation is so particular that nothing follows it by accident: what moves by itself may move
/// by a multiple of the camera's motion, or not at all.
bool isParticular(const MotionTrial& trial);
/// Whether what is not the camera's motion in regions that rest is that of a frame ago, at the silhouettes of
/// what moves: they were elsewhere.
bool isLateAtSilhouettes(const ConsistencyEvidence& evidence);

} // namespace taa::doctor
