// Texts of files that nobody has looked at, as messages can show them.
#pragma once

#include <string>
#include <string_view>

namespace taa {

/// Its beginning, at most 100 bytes and "…", whole letters, with a question mark for each that is not one.
std::string shownText(std::string_view text);

/// Whether all of it is UTF-8 without control characters.
bool isPlainText(std::string_view text);

} // namespace taa
