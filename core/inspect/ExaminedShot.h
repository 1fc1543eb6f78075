// The doctor on a shot that somebody looks at, beside it.
#pragma once

#include "core/base/Progress.h"
#include "core/doctor/examination/CorrectedLook.h"
#include "core/doctor/examination/Doctor.h"
#include "core/io/SessionFile.h"

namespace taa {

struct ExaminationRequest {
  SessionFile shot; ///< all but its frame and further lanes
  int first = 0, frames = doctor::kDoctorFrames;
};

/// With a GL context of its own: expects a thread that has none. Frames are drawn in turn with other threads,
/// which go on while it measures. Throws Error, Cancelled.
doctor::Diagnosis examineShot(const ExaminationRequest& request, const doctor::DiagnosisTold& told,
                              const Progress& progress);

/// The frames of a diagnosis of the request's, with what can be made right made so. `healthy`: see
/// corrected(). With a GL context of its own, as above. Throws Error, Cancelled.
doctor::CorrectedLook lookAtCorrectedShot(const ExaminationRequest& request,
                                          const doctor::Diagnosis& diagnosis, const Settings& healthy,
                                          const Progress& progress);

} // namespace taa
