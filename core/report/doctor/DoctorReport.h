// What the doctor says, to hand on: as plain sentences and as JSON, the same in both.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/examination/CorrectedLook.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace taa {

/// What a report calls a source: a built-in scene's own name, else that of the folder or file, wherever it
/// lies.
std::string reportedName(const std::string& source);

/// Findings with their evidence, then what is undecided, what is right, and notes.
std::string doctorText(const doctor::Diagnosis& diagnosis, const std::string& source);

/// {"source", "frames", "pairs", "healthy": bool, "findings": [{"id", "name", "sure", "known",
/// "wholePicture",
/// "regions": [{"name", "frame", "box": [left, top, right, bottom], "pixel": [x, y], "share"}], "reason",
/// "measure", "residuals": [{"id", "text", "value", "given", "best"}], "symptom", "change", "correction":
/// ["path=value"]}], "undecided": [{"question", "reason", "capture", "misfit": bool, "faults"}], "right":
/// [""], "notes": [""]}; "healthy": nothing was found, and all that was measured fits.
nlohmann::ordered_json doctorJson(const doctor::Diagnosis& diagnosis, const std::string& source);

/// What is made right, by which settings, what is found then, and how far both are from the reference.
/// `given`: the settings of the frames as they are.
std::string correctedText(const doctor::CorrectedLook& look, const doctor::Diagnosis& diagnosis,
                          const Settings& given);
/// {"findings": ["id"], "settings": ["path=value"], "left": ["id"], "frame", "psnr": {"given", "corrected"}};
/// "psnr" where there is a reference.
nlohmann::ordered_json correctedJson(const doctor::CorrectedLook& look, const doctor::Diagnosis& diagnosis,
                                     const Settings& given);

} // namespace taa
