// The doctor: measures what is wrong with the frames of a TAA integration, region by region, and says what to
// change.
#pragma once

#include "core/base/Progress.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/examination/Examination.h"

#include <functional>

namespace taa::doctor {

/// What is known after a few frames, see kFirstLook; what examine() returns takes its place.
using DiagnosisTold = std::function<void(const Diagnosis&)>;

/// Looks at each frame with those before and after it. Throws Error, Cancelled.
Diagnosis examine(const Examination& examination, const Progress& progress = {},
                  const DiagnosisTold& told = {});

} // namespace taa::doctor
