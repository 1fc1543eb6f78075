// Frames to examine, and what is known of them.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/source/DoctorSource.h"

#include <vector>

namespace taa::doctor {

inline constexpr int kFirstLook = 5; ///< frames after which the first findings are told

struct Examination {
  FrameReader read;
  int first = 0;              ///< number of the first frame
  int frames = kDoctorFrames; ///< from that one on; as many as there are, at most
  KnownPlanes known;
  CaptureInfo captureInfo;                ///< its sizes are those of the first frame where they are 0
  std::vector<Finding> contradicted = {}; ///< see correctContradicted(); told before all else
};

/// Of `frames` frames of a source, or as many as it has from `first` on. Throws Error where those are fewer
/// than two.
Examination examinationOf(const DoctorSource& source, int frames, int first = 0);

} // namespace taa::doctor
