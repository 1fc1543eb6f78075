// What the doctor says as a page to put into a bug tracker: one file, without scripts and without anything
// from elsewhere.
#pragma once

#include "core/doctor/Diagnosis.h"

#include <string>

namespace taa {

/// HTML of all that doctorText() says, with the residuals as bars.
std::string doctorHtml(const doctor::Diagnosis& diagnosis, const std::string& source);

} // namespace taa
