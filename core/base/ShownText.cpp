#include "core/base/ShownText.h"

#include <cstddef>
#include <cstdint>

namespace taa {

namespace {

constexpr std::size_t kLongest = 100;

unsigned byteAt(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

/// Bytes of the letter at `at`; 0 where none is: a control character, or not UTF-8.
std::size_t letterBytes(std::string_view text, std::size_t at) {
  const unsigned first = byteAt(text, at);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || at + bytes > text.size()) return 0;
  std::uint32_t letter = first & (0x7fu >> bytes);
  for (std::size_t next = at + 1; next < at + bytes; ++next) {
    if ((byteAt(text, next) & 0xc0) != 0x80) return 0;
    letter = (letter << 6) | (byteAt(text, next) & 0x3f);
  }
  const bool isShortest = letter >= (bytes == 2 ? 0x80u : bytes == 3 ? 0x800u : 0x10000u);
  const bool isSurrogate = letter >= 0xd800 && letter <= 0xdfff;
  // From 0x80 to 0x9f stand further control characters.
  return isShortest && !isSurrogate && letter <= 0x10ffff && letter >= 0xa0 ? bytes : 0;
}

} // namespace

std::string shownText(std::string_view text) {
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = letterBytes(text, at);
    if (shown.size() + (bytes > 0 ? bytes : 1) > kLongest) return shown + "…";
    shown += bytes > 0 ? text.substr(at, bytes) : "?";
    at += bytes > 0 ? bytes : 1;
  }
  return shown;
}

bool isPlainText(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = letterBytes(text, at);
    if (bytes == 0) return false;
    at += bytes;
  }
  return true;
}

} // namespace taa
