// Texts that many places make of lists.
#pragma once

#include <string>
#include <vector>

namespace taa {

/// "a, b, c"
inline std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

} // namespace taa
