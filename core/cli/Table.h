// Text in columns for people.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace taa::cli {

/// Prints `rows` with columns as wide as their longest entry, two spaces apart, each line after `indent`;
/// no spaces at the ends of lines. A row of one entry is a heading, which makes no column wider.
void printTable(std::ostream& out, const std::vector<std::vector<std::string>>& rows,
                const std::string& indent = "");

} // namespace taa::cli
