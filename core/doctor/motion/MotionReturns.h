// Things that are drawn again, or for the first time: the frame before does not show them, so that only their
// own next motions say whether the first one is right.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/frames/Regions.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {

/// A region whose motion jumps in the frame in which it comes.
struct Return {
  RegionIndex region = kNoRegion;
  int frame = 0;
  glm::dvec2 px{0.0}, next{0.0}; ///< mean motion there, and in the frame after
};

class ReturnEvidence {
 public:
  /// Frames one after the other, with motion.
  void add(const DoctorFrame& frame, const std::vector<RegionIndex>& labels);
  std::vector<Return> found() const;

 private:
  struct Mean {
    std::size_t pixels = 0; ///< of the region that have motion …
    glm::dvec2 sum{0.0};    ///< … of which this is the sum, px

    glm::dvec2 px() const { return sum / static_cast<double>(pixels); }
  };

  std::optional<int> first_;                         ///< frame
  std::map<RegionIndex, std::map<int, Mean>> means_; ///< by frame; where motion is known
  std::map<RegionIndex, std::vector<int>> seen_;     ///< frames
  std::vector<int> starts_;                          ///< of history
};

/// What to change, in a sentence.
std::string returnChange();
/// One finding for all of them.
void tellReturns(std::vector<Return> returns, const std::vector<Region>& regions,
                 const CaptureInfo& captureInfo, Diagnosis& out);

} // namespace taa::doctor
