// The glossary of the manual as synonyms: what this program calls a thing, and what the field calls it, too.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// A row: a thing of this program.
struct GlossaryRow {
  std::vector<std::string> words;  ///< as it is called here
  std::vector<std::string> others; ///< as others call it

  bool operator==(const GlossaryRow&) const = default;
};

/// Of a Markdown table "| word | also | means |", names separated by commas. Throws Error naming the line of
/// a row that has other columns.
std::vector<GlossaryRow> readGlossary(std::string_view markdown);

/// That which the program carries: resources/manual/glossary.md.
const std::vector<GlossaryRow>& glossary();

} // namespace taa
