// How often verdicts of a kind were right on pixels that no rule was made with.
#include "core/verdict/pixel/BlindAgreement.h"

#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

using taa::BlindAgreement;
using taa::VerdictKind;

namespace {

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Counted anew from the labels: no cell before the last, the labeller's reason, has a comma in it.
BlindAgreement countedIn(const std::string& table, std::string_view kind) {
  constexpr std::size_t kSet = 0, kLabelled = 8, kNamed = 10;
  BlindAgreement counted;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.at(kSet) != "aside" || cells.at(kNamed) != kind) continue;
    ++counted.named;
    if (("|" + cells.at(kLabelled) + "|").find("|" + std::string(kind) + "|") != std::string::npos)
      ++counted.right;
  }
  return counted;
}

} // namespace

TEST(BlindAgreement, IsWhatTheLabelsCountTo) {
  const std::string table = taa::readFile(taa::test::rootFolder() / "tests/verdicts/blind.csv");
  int named = 0;
  for (const taa::VerdictKindInfo& info : taa::kVerdictKinds) {
    const BlindAgreement expected = countedIn(table, info.id), found = taa::blindAgreement(info.kind);
    EXPECT_EQ(found.named, expected.named) << info.id << ": run tests/verdicts/judge --page";
    EXPECT_EQ(found.right, expected.right) << info.id;
    named += found.named;
  }
  EXPECT_GE(named, 64);
}

TEST(BlindAgreement, IsSaidWithBothCounts) {
  for (const taa::VerdictKindInfo& info : taa::kVerdictKinds) {
    const BlindAgreement agreement = taa::blindAgreement(info.kind);
    const std::string text = taa::agreementText(info.kind);
    if (agreement.named == 0)
      EXPECT_EQ(text, "Checked blind: no pixel has had a verdict of this kind yet.");
    else
      EXPECT_NE(
          text.find(std::to_string(agreement.right) + " of " + std::to_string(agreement.named) + " pixels"),
          std::string::npos)
          << text;
  }
}
