// Texts that many places make of lists and numbers.
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <vector>

namespace taa {

/// "a, b, c"
inline std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The shortest decimal that reads back as the same number of its type.
inline std::string shortestText(std::floating_point auto value) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

} // namespace taa
