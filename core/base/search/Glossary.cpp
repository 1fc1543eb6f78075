#include "core/base/search/Glossary.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Error.h"
#include "core/base/Say.h"

#include <cstddef>
#include <sstream>
#include <utility>

namespace taa {

namespace {

/// The parts between separators, without the spaces around them.
std::vector<std::string> trimmedParts(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<std::string> namesOfCell(const std::string& cell) {
  return cell.empty() ? std::vector<std::string>{} : trimmedParts(cell, ',');
}

} // namespace

std::vector<GlossaryRow> readGlossary(std::string_view markdown) {
  std::vector<GlossaryRow> rows;
  std::istringstream text{std::string(markdown)};
  int number = 0, row = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (!line.starts_with('|')) continue;
    if (++row <= 2) continue; // the heading and the line below it
    const std::vector<std::string> cells = trimmedParts(line.substr(1), '|');
    if (cells.size() != 3)
      throw Error(say<"glossary, line %1: a row has three columns: word, also, means">(number));
    rows.push_back({namesOfCell(cells[0]), namesOfCell(cells[1])});
  }
  return rows;
}

const std::vector<GlossaryRow>& glossary() {
  static const std::vector<GlossaryRow> rows = readGlossary(embeddedText("resources/manual/glossary.md"));
  return rows;
}

} // namespace taa
