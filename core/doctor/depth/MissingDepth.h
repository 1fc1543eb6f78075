// Things that are drawn into the picture and not into depth: where they are it goes on with what is behind.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/flow/Refuted.h"
#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/frames/Regions.h"

#include <cstddef>
#include <vector>

namespace taa::doctor {

class MissingDepth {
 public:
  void add(const DoctorFrame& frame, const std::vector<RegionIndex>& labels);
  /// Adds a finding of regions at whose silhouettes depth has no step, and which move as they are said to and
  /// not as that depth has it.
  void tell(const FlowSeen& seen, const CaptureInfo& captureInfo, Diagnosis& out) const;

 private:
  struct Silhouettes {
    std::size_t pairs = 0, steps = 0; ///< of pixels beside each other, of which one is the region's
  };

  bool isFlat(std::size_t region) const;

  std::vector<Silhouettes> silhouettes_; ///< by region
};

} // namespace taa::doctor
