// The table of techniques: each row of the manual's chapters, and what chooses it here or why nothing does.
// Rows that a choice's explanation names follow from the table of settings.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace taa {

struct Technique {
  std::string_view row;  ///< as the manual numbers it: "4.1", "J10", "D8"; 24 comes several times
  std::string_view name; ///< "closest 3×3"
  /// Markdown: assignments, intermediates and presets between backticks, as --set takes them; or "always…",
  /// or "Left out: " and why. A test holds it against the tables of settings, intermediates and presets.
  std::string here;
};

/// In the order of the manual.
std::span<const Technique> techniques();

} // namespace taa
