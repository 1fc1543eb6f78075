// What an assignment of a setting says, in words.
#pragma once

#include <string>
#include <string_view>

namespace taa {

/// "path=value" by the table of settings: "Rectify history ▸ Method: Clip to filtered"; numbers have
/// four significant digits. Throws Error.
std::string assignmentWords(std::string_view assignment);

} // namespace taa
