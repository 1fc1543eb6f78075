// The doctor: measures what is wrong with the frames of a TAA integration, region by region, and says what to
// change.
#pragma once

#include "core/base/Progress.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/Patient.h"
#include "core/doctor/source/DoctorSource.h"

#include <functional>
#include <vector>

namespace taa::doctor {

/// Frames to examine, and what is known of them.
struct Examination {
  FrameReader read;
  int first = 0;              ///< number of the first frame
  int frames = kDoctorFrames; ///< from that one on; as many as there are, at most
  KnownPlanes known;
  Patient patient;                        ///< its sizes are those of the first frame where they are 0
  std::vector<Finding> contradicted = {}; ///< see mendContradicted(); told before all else
};

/// Of `frames` frames of a source, or as many as it has from `first` on. Throws Error where those are fewer
/// than two.
Examination examinationOf(const DoctorSource& source, int frames, int first = 0);

/// What is known after kFirstLook frames; what examine() returns takes its place.
using DiagnosisTold = std::function<void(const Diagnosis&)>;
inline constexpr int kFirstLook = 5;

/// Looks at each frame with those before and after it. Throws Error, Cancelled.
Diagnosis examine(const Examination& examination, const Progress& progress = {},
                  const DiagnosisTold& told = {});

} // namespace taa::doctor
