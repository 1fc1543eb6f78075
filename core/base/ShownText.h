// Texts of files that nobody has looked at, as messages can show them.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace taa {

/// Its beginning, at most 100 bytes and "…", whole letters, with a question mark for each that is not one.
std::string shownText(std::string_view text);

/// All of it in letters, with a question mark for each byte that is of none, and for a control character.
std::string plainText(std::string_view text);

/// A sentence with texts of files in it, as one line: in letters, with spaces for what begins another line.
/// Of more than 2000 bytes its beginning, "…" and its end, where the reason stands.
std::string shownLine(std::string_view sentence);

/// As above, of what compilers say: lines stay lines. At most 16,000 bytes.
std::string shownLines(std::string_view log);

/// Why something failed, as shownLines(): of a library of JSON without what that writes for programmers.
std::string shownReason(const std::exception& error);

/// Whether all of it is UTF-8 without control characters.
bool isPlainText(std::string_view text);

} // namespace taa
