// Regions that are drawn without the jitter that all else is drawn with: a view model with a projection of
// its own, a layer that was drawn before.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionTrials.h"

#include <map>
#include <vector>

namespace taa::doctor {

/// How much of the jitter that is stated a region's pictures do not have, with its standard error.
struct MissingJitter {
  double share = 0.0; ///< 0: they have all of it, 1: none
  double error = 0.0;
  int pairs = 0; ///< of frames, in which it was measured
};

/// The frame before, read where motion and jitter lead to, against the frame now, by the slope along the step
/// of the jitter: least squares over the pixels well inside a region.
class RegionJitter {
 public:
  void add(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels);
  std::map<RegionIndex, MissingJitter> regions() const;

 private:
  /// Of a pair.
  struct Sums {
    double together = 0.0, slopes = 0.0;
    int pixels = 0;
  };
  std::map<RegionIndex, std::vector<Sums>> regions_;
};

/// Adds a finding for regions that clearly have none, beside others that clearly have it.
void tellRegionJitter(const RegionJitter& jitter, const std::vector<Region>& regions,
                      const CaptureInfo& captureInfo, Diagnosis& out);

} // namespace taa::doctor
