#include "core/lessons/LessonText.h"

#include "core/base/Error.h"
#include "core/base/NearestNames.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

namespace taa {

namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr int kMaxPixel = 32767;

} // namespace

std::string_view withoutBlanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin; (begin = text.find_first_not_of(kBlanks)) != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    text.remove_prefix(end);
  }
  return words;
}

double numberFrom(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw Error(say<"\"%1\" is not a number">(shownText(text)));
  return value;
}

int wholeNumberFrom(std::string_view text, int least, int most) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
    throw Error(say<"\"%1\" is not a whole number from %2 to %3">(shownText(text), least, most));
  return value;
}

glm::ivec2 pixelFrom(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == text.npos) throw Error(say<"\"%1\" is no pixel: expected X,Y">(shownText(text)));
  return {wholeNumberFrom(text.substr(0, comma), 0, kMaxPixel),
          wholeNumberFrom(text.substr(comma + 1), 0, kMaxPixel)};
}

void requireName(std::string_view name, std::span<const std::string_view> known, const std::string& what) {
  if (std::ranges::find(known, name) != known.end()) return;
  throw Error(say<"there is no %1 \"%2\"; near it is \"%3\"">(what, shownText(name),
                                                              nearestNames(name, known, 1).front()));
}

} // namespace taa
