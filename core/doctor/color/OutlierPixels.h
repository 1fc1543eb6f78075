// What pictures show and motion does not lead to, neither from the frame before nor to the frame after:
// particles that are drawn in color alone, limbs that move otherwise than their body's motion says, lights
// that flicker. It says where something is left that no explanation of a whole region holds, and not what.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionTrials.h"

#include <cstddef>
#include <map>
#include <vector>

namespace taa::doctor {

/// Places of a region: connected pixels as wide as long, well inside it.
struct OutlierPlaces {
  std::size_t places = 0;
  std::vector<int> frames; ///< in which they are, rising; one of them is
  int frame = 0;           ///< that of the largest …
  std::size_t most = 0;    ///< … its pixels …
  glm::ivec2 pixel{0};     ///< … and one of them
};

class OutlierPixels {
 public:
  /// Frames without one after them are not asked. `labels`: regions of `frames.now`.
  void add(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels);
  const std::map<RegionIndex, OutlierPlaces>& regions() const { return regions_; }
  int asked() const { return asked_; } ///< frames

 private:
  std::map<RegionIndex, OutlierPlaces> regions_;
  int asked_ = 0;
};

/// Leaves motion open where a region has many such places and no finding is of it.
void tellOutlier(const OutlierPixels& outlier, const std::vector<Region>& regions,
                 const CaptureInfo& captureInfo, Diagnosis& out);

} // namespace taa::doctor
