// Values that are no number, before anything is made of them.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/frames/Regions.h"

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::doctor {

/// NaN and infinities of motion.
struct NotFinite {
  std::size_t nan = 0, infinite = 0; ///< pixels of all frames
  std::vector<int> frames;
  glm::ivec2 pixel{0};           ///< one of them, in the first of these frames
  std::set<RegionIndex> regions; ///< that hold more than a few
};

/// The farthest depth of frames in which nothing is as far as the sky.
struct FarthestDepth {
  float depth = 0.0f;    ///< reversed, as in DoctorFrame
  double distance = 0.0; ///< m
  double share = 1.0;    ///< of the picture that has exactly it, where it is least
  int frames = 0;
  bool isSame = true; ///< in all of these
};

class ValueEvidence {
 public:
  void add(const DoctorFrame& frame, const std::vector<RegionIndex>& labels);

  const NotFinite& motion() const { return motion_; }
  const std::vector<int>& asked() const { return asked_; } ///< frames
  /// Of all frames.
  std::size_t badColors() const { return badColors_; }
  /// Whether nearly all motion of what moves is of whole pixels, of many lengths.
  bool isOfWholePixels() const;
  /// px: steps of which all motion is, along x and y, where they are coarse; nothing: it has finer ones.
  std::optional<glm::dvec2> stepsPx() const;
  /// One value that is farthest over much of the picture in all frames: perhaps the sky, which nobody stated.
  std::optional<FarthestDepth> unstatedSky() const;

 private:
  void addWhole(const DoctorFrame& frame);
  void addDepth(const DoctorFrame& frame);
  void addSteps(const DoctorFrame& frame);

  NotFinite motion_;
  FarthestDepth farthest_;
  std::array<std::set<float>, 2> values_; ///< of motion, px, by axis; no more than are too many for steps
  std::size_t mostOfFrame_ = 0;           ///< of them, along the axis that has more, that one frame has
  std::vector<int> asked_;
  std::size_t badColors_ = 0;
  std::size_t moving_ = 0, whole_ = 0;    ///< pixels; of these: that move by whole pixels
  std::set<std::pair<int, int>> lengths_; ///< px; some of them
};

/// Id of a finding that is of all motion, whatever else seems to be wrong with it.
inline constexpr std::string_view kMotionStepsId = "motionSteps";

/// A finding of motion; a note of colors, which a TAA may be made for.
void tellBadValues(const ValueEvidence& evidence, const std::vector<Region>& regions,
                   const CaptureInfo& captureInfo, Diagnosis& out);

} // namespace taa::doctor
