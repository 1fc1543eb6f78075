// What the doctor says as a page to put into a bug tracker: one file, without scripts and without anything
// from elsewhere.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/examination/CorrectedLook.h"

#include <string>

namespace taa {

/// HTML of all that doctorText() says, with the residuals as bars and the outlines of regions. `corrected`:
/// its pictures are in the page, given and corrected side by side; null: there are none.
std::string doctorHtml(const doctor::Diagnosis& diagnosis, const std::string& source,
                       const doctor::CorrectedLook* corrected = nullptr);

} // namespace taa
