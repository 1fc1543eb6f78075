// Sentences of the core, each written whole where it is said, so that it can be found and read as one.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// An English text as a template argument, with places %1 … %9 for what is put into it.
template <std::size_t kSize>
struct Sentence {
  std::array<char, kSize> text{};

  // Not explicit: it is written as a string.
  consteval Sentence(const char (&from)[kSize]) { std::copy_n(from, kSize, text.begin()); }

  /// The highest n of its places.
  constexpr std::size_t places() const {
    std::size_t most = 0;
    for (std::size_t i = 0; i + 1 < kSize; ++i)
      if (text[i] == '%' && text[i + 1] >= '1' && text[i + 1] <= '9')
        most = std::max(most, static_cast<std::size_t>(text[i + 1] - '0'));
    return most;
  }
};

namespace saying {

/// The text with `arguments` at its places.
std::string fill(const char* text, const std::vector<std::string>& arguments);

inline std::string argument(std::string_view text) {
  return std::string(text);
}
std::string argument(std::integral auto number) {
  return std::to_string(number);
}

} // namespace saying

/// say<"%1 has no camera called %2">(file, name): texts and whole numbers; one for each place.
template <Sentence kText, typename... Arguments>
std::string say(const Arguments&... arguments) {
  static_assert(sizeof...(arguments) == kText.places(), "a text has one place for each argument");
  return saying::fill(kText.text.data(), {saying::argument(arguments)...});
}

} // namespace taa
