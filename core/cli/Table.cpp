#include "core/cli/Table.h"

#include <algorithm>
#include <ostream>

namespace taa::cli {

namespace {

/// Columns that UTF-8 text takes: one for each code point (no wide or combining ones in our tables).
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

} // namespace

void printTable(std::ostream& out, const std::vector<std::vector<std::string>>& rows,
                const std::string& indent) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    if (row.size() == 1) continue;
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max(widths[column], columns(row[column]));
  }
  for (const std::vector<std::string>& row : rows) {
    std::string line = indent;
    for (std::size_t column = 0; column < row.size(); ++column)
      line += row.size() == 1 ? row[column]
                              : row[column] + std::string(widths[column] - columns(row[column]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

} // namespace taa::cli
