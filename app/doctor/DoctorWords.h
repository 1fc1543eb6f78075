// What the doctor says in the words of the window, and which plane shows it.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/taa/Intermediates.h"

#include <QString>

namespace taa::app {

/// "sure" or "likely".
QString confidenceText(doctor::Confidence confidence);
/// "the whole picture", "the sky, object 7 (wheel)".
QString whereText(const doctor::Finding& finding);
/// How much of the picture a region is and where it is largest: "the sky: 32 %, largest in frame 12".
QString placeText(const doctor::RegionPlace& place);
/// The row of the plane that is wrong.
IntermediateId shownRow(const doctor::Finding& finding);

} // namespace taa::app
