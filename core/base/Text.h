// Texts that many places make of lists and numbers.
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// "a, b, c"
inline std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// `text`, or as many of its first characters as have `maxBytes` bytes with the "…" behind them.
inline std::string shortened(const std::string& text, std::size_t maxBytes) {
  constexpr std::string_view kEllipsis = "…";
  if (text.size() <= maxBytes) return text;
  std::size_t end = maxBytes - kEllipsis.size();
  const auto isInside = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; };
  while (end > 0 && isInside(text[end])) --end;
  return text.substr(0, end).append(kEllipsis);
}

/// The shortest decimal that reads back as the same number of its type.
inline std::string shortestText(std::floating_point auto value) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

} // namespace taa
