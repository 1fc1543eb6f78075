// What a driver made of frames, to hand on: as a sentence, as lines of a table and as JSON; the same figures
// in all of them.
#pragma once

#include "core/probe/Verification.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace taa {

/// "All 1234567 values of 72 rows lie within what GLSL allows on llvmpipe …; 99.98 % have the bits of …".
std::string verificationSentence(const Verification& verification, const std::string& driver);
/// A line of headings, then the rows; what is outside first, then the widest.
std::vector<std::vector<std::string>> verificationTable(const Verification& verification);
/// Of each row that has values outside one of them: where, what it is and what it may be; in the order of the
/// table, which begins with these rows.
std::vector<std::string> outsideSentences(const Verification& verification);
nlohmann::ordered_json verificationJson(const Verification& verification);

} // namespace taa
