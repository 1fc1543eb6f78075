#include "core/base/ShownText.h"

#include "core/base/Say.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>

namespace taa {

namespace {

constexpr std::size_t kLongest = 100, kLongestLine = 2000, kLongestLog = 16000;

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

/// Its letters; `instead` says what stands for a byte that is of none.
template <typename Instead>
std::string lettersOf(std::string_view text, Instead instead) {
  std::string letters;
  letters.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = letterBytes(text, at);
    if (bytes > 0)
      letters += text.substr(at, bytes);
    else
      letters += instead(text[at]);
    at += bytes > 0 ? bytes : 1;
  }
  return letters;
}

/// `at`, or where the letter begins that `at` is within.
std::size_t letterStart(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && (byteAt(text, at) & 0xc0) == 0x80) --at;
  return at;
}

/// Of letters more than `most` bytes: the beginning and the last quarter.
std::string shortened(std::string letters, std::size_t most) {
  if (letters.size() <= most) return letters;
  const std::size_t end = most / 4, start = letterStart(letters, letters.size() - end);
  return letters.substr(0, letterStart(letters, most - end)) + "…" + letters.substr(start);
}

} // namespace

std::string plainText(std::string_view text) {
  return lettersOf(text, [](char) { return '?'; });
}

std::string shownText(std::string_view text) {
  // A byte that is of no letter becomes one byte: what is cut off cannot be needed.
  const std::string letters = plainText(text.substr(0, kLongest + 4));
  if (text.size() <= kLongest) return letters;
  return letters.substr(0, letterStart(letters, kLongest)) + "…";
}

std::string shownLine(std::string_view sentence) {
  const auto instead = [](char byte) { return byte == '\n' || byte == '\r' || byte == '\t' ? ' ' : '?'; };
  return shortened(lettersOf(sentence, instead), kLongestLine);
}

std::string shownLines(std::string_view log) {
  const auto instead = [](char byte) { return byte == '\n' || byte == '\t' ? byte : '?'; };
  return shortened(lettersOf(log, instead), kLongestLog);
}

std::string shownReason(const std::exception& error) {
  if (dynamic_cast<const nlohmann::json::exception*>(&error))
    return say<"a value in it is missing, or of another kind than is expected there">();
  return shownLines(error.what());
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
