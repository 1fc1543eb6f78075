// What the doctor says, to hand on: as plain sentences and as JSON, the same in both.
#pragma once

#include "core/doctor/Diagnosis.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace taa {

/// Findings with their evidence, then what is undecided, what is right, and notes.
std::string doctorText(const doctor::Diagnosis& diagnosis, const std::string& source);

/// {"source", "frames", "pairs", "healthy": bool, "findings": [{"id", "name", "sure", "known",
/// "wholePicture",
/// "regions": [{"name", "frame", "box": [left, top, right, bottom], "pixel": [x, y], "share"}], "reason",
/// "measure", "residuals": [{"id", "text", "value", "given", "best"}], "symptom", "change"}], "undecided":
/// [{"question", "reason", "capture"}], "right": [""], "notes": [""]}
nlohmann::ordered_json doctorJson(const doctor::Diagnosis& diagnosis, const std::string& source);

} // namespace taa
