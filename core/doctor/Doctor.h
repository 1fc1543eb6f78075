// The doctor: measures what is wrong with the frames of a TAA integration, region by region, and says what to
// change.
#pragma once

#include "core/base/Progress.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/Patient.h"
#include "core/doctor/frames/DoctorSource.h"

namespace taa::doctor {

/// Frames to examine, and what is known of them.
struct Examination {
  FrameReader read;
  int frames = kDoctorFrames; ///< from frame 0 on; as many as there are, at most
  KnownPlanes known;
  Patient patient; ///< its sizes are those of the first frame where they are 0
};

/// Of the frames of a source. Throws Error where there are fewer than two.
Examination examinationOf(const DoctorSource& source, int frames);

/// Looks at each frame with those before and after it. Throws Error, Cancelled.
Diagnosis examine(const Examination& examination, const Progress& progress = {});

} // namespace taa::doctor
