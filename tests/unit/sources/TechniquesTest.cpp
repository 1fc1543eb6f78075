// The README's table of techniques against the parameter table, and against the catalogue when it is there.
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/rows/Intermediates.h"
#include "tests/support/TestNames.h"
#include "tests/unit/sources/TechniqueEffects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace taa {
namespace {

struct Row {
  std::string id, name, here;
};

std::vector<Row> techniques() {
  std::istringstream lines(readFile(std::string(TAA_SOURCE_DIR) + "/README.md", 1 << 20));
  std::string line;
  while (std::getline(lines, line) && line != "## Techniques") {
  }
  const std::regex pattern(R"(\| (J?D?[0-9]+(?:\.[0-9]+)?[a-c]?) \| (.+) \| (.+) \|)");
  std::vector<Row> rows;
  std::smatch found;
  while (std::getline(lines, line) && !line.starts_with("## "))
    if (std::regex_match(line, found, pattern)) rows.push_back({found[1], found[2], found[3]});
  return rows;
}

/// What stands between backticks.
std::vector<std::string> codes(const std::string& text) {
  std::vector<std::string> all;
  const std::regex pattern("`([^`]+)`");
  for (std::sregex_iterator code(text.begin(), text.end(), pattern), end; code != end; ++code)
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
  for (const Row& row : techniques())
    for (const std::string& code : codes(row.here)) EXPECT_TRUE(isKnown(code)) << row.id << ": " << code;
}

TEST(Techniques, SayWhyWhereTheyAreNotThere) {
  for (const Row& row : techniques()) {
    const bool isAbsent = row.here.starts_with("Left out: ") || row.here.starts_with("Not yet: ");
    const bool isThere = !codes(row.here).empty() || row.here.starts_with("always");
    EXPECT_NE(isAbsent && row.here.ends_with('.'), isThere && !isAbsent) << row.id << ": " << row.here;
  }
}

TEST(Techniques, AreEachShownByATestOfWhatTheyDo) {
  const std::set<std::string> names = test::testNames();
  std::set<std::string> ids;
  for (const Row& row : techniques()) {
    if (row.here.starts_with("Left out: ")) continue;
    ids.insert(row.id);
    EXPECT_TRUE(test::testsOfTechniques().contains(row.id))
        << row.id << " " << row.name << " has no test of its effect";
  }
  for (const auto& [id, tests] : test::testsOfTechniques()) {
    EXPECT_TRUE(ids.contains(id)) << id << " is no row of the README, or left out there";
    for (const char* name : tests) EXPECT_TRUE(names.contains(name)) << id << ": there is no test " << name;
  }
}

TEST(Techniques, CoverEveryChoiceAndSwitchOfThePipeline) {
  std::set<std::string> named;
  for (const Row& row : techniques())
    for (const std::string& code : codes(row.here)) named.insert(code);
  for (const Parameter& row : parameters()) {
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

TEST(Techniques, HoldEveryRowOfTheCatalogue) {
  const std::filesystem::path file =
      std::filesystem::path(TAA_SHARED_DATA).parent_path() / "taa/catalogue.md";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no catalogue at " << file;
  std::set<std::string> ids;
  for (const Row& row : techniques()) ids.insert(row.id);
  std::istringstream lines(readFile(file, 1 << 20));
  const std::regex pattern(R"(\| \**(J?[0-9]+(?:\.[0-9]+)?[a-c]?)\** \|.*)");
  std::smatch found;
  int count = 0;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, pattern)) {
      ++count;
      EXPECT_TRUE(ids.contains(found[1])) << line.substr(0, 60);
    }
  EXPECT_GT(count, 150);
}

} // namespace
} // namespace taa
