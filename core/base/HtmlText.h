// Text of anybody's in a page of HTML.
#pragma once

#include <string>
#include <string_view>

namespace taa {

/// As it is shown, letter by letter: between tags, and within the quotes of an attribute.
inline std::string htmlText(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '&')
      out += "&amp;";
    else if (letter == '<')
      out += "&lt;";
    else if (letter == '>')
      out += "&gt;";
    else if (letter == '"')
      out += "&quot;";
    else
      out += letter;
  }
  return out;
}

} // namespace taa
