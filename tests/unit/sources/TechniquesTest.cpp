// The table of techniques against the tables of settings and intermediates, and against the manual's
// chapters.
#include "core/report/Techniques.h"
#include "core/base/EmbeddedFiles.h"
#include "core/base/Error.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/Intermediates.h"
#include "tests/support/TestNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace taa {
namespace {

/// What stands between backticks.
std::vector<std::string> codes(std::string_view text) {
  std::vector<std::string> all;
  const std::regex pattern("`([^`]+)`");
  for (std::cregex_iterator code(text.data(), text.data() + text.size(), pattern), end; code != end; ++code)
    all.push_back((*code)[1]);
  return all;
}

bool isAssignment(const std::string& code) {
  try {
    Settings settings;
    applyAssignment(settings, code);
    return true;
  } catch (const Error&) {
    return false;
  }
}

bool isKnown(const std::string& code) {
  return isAssignment(code) || std::ranges::count(parameters(), code, &Parameter::path) == 1 ||
         std::ranges::count(kIntermediates, code, &Intermediate::name) == 1 ||
         std::ranges::count(builtinPresets(), code, &Preset::id) == 1 || code == "_VELOCITY";
}

TEST(Techniques, NameOnlySettingsIntermediatesAndPresetsThatExist) {
  ASSERT_GT(techniques().size(), 150u);
  for (const Technique& row : techniques())
    for (const std::string& code : codes(row.here)) EXPECT_TRUE(isKnown(code)) << row.row << ": " << code;
}

TEST(Techniques, SayWhyWhereTheyAreNotThere) {
  for (const Technique& row : techniques()) {
    const bool isAbsent = row.here.starts_with("Left out: ") || row.here.starts_with("Not yet: ");
    const bool isThere = !codes(row.here).empty() || row.here.starts_with("always");
    EXPECT_NE(isAbsent && row.here.ends_with('.'), isThere && !isAbsent) << row.row << ": " << row.here;
  }
}

TEST(Techniques, AreEachShownByATestOfWhatTheyDo) {
  const std::set<std::string> shown = test::techniquesWithTests();
  std::set<std::string> ids;
  for (const Technique& row : techniques()) {
    if (row.here.starts_with("Left out: ")) continue;
    ids.emplace(row.row);
    EXPECT_TRUE(shown.contains(std::string(row.row)))
        << row.row << " " << row.name << " has no test of its effect";
  }
  for (const std::string& id : shown) EXPECT_TRUE(ids.contains(id)) << id << " is no technique, or left out";
}

TEST(Techniques, CoverEveryChoiceAndSwitchOfThePipeline) {
  std::set<std::string> named;
  for (const Technique& row : techniques())
    for (const std::string& code : codes(row.here)) named.insert(code);
  for (const Parameter& row : parameters()) {
    if (row.stage == Stage::Faults) continue; // mistakes, not techniques
    const std::string path(row.path);
    if (row.kind == ParameterKind::Toggle) {
      EXPECT_TRUE(named.contains(path)) << path;
    }
    for (const Choice& choice : row.choices)
      if (path != "inputs.precision") {
        EXPECT_TRUE(named.contains(path + "=" + std::string(choice.id))) << path << "=" << choice.id;
      }
  }
}

TEST(Techniques, HoldEveryRowOfTheManual) {
  std::set<std::string> ids;
  for (const Technique& row : techniques()) ids.emplace(row.row);
  std::istringstream lines(embeddedText("resources/manual/techniques.md"));
  const std::regex pattern(R"(\| ([JD]?[0-9]+(?:\.[0-9]+)?[a-c]?) \|.*)");
  std::smatch found;
  std::set<std::string> told;
  std::vector<std::string> inOrder;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, pattern)) {
      if (told.insert(found[1]).second) inOrder.push_back(found[1]);
      EXPECT_TRUE(ids.contains(found[1])) << line.substr(0, 60);
    }
  EXPECT_GT(told.size(), 180u);
  std::vector<std::string> rows;
  for (const Technique& row : techniques())
    if (told.contains(std::string(row.row)) && (rows.empty() || rows.back() != row.row))
      rows.emplace_back(row.row);
  EXPECT_EQ(rows, inOrder) << "in the order of the manual";
  // Some are told by a section of their own.
  for (const std::string& id : ids)
    EXPECT_TRUE(told.contains(id) || id == "2.1" || id == "2.2" || id == "16")
        << id << " is not in the manual";
}

} // namespace
} // namespace taa
