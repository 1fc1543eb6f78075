// The manual against the tree: no dead citation, path or link, and pages of tables as the tables are.
#include "core/base/Files.h"
#include "core/report/ManualPages.h"
#include "tests/manual/ManualTables.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstddef>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = "resources/manual";

std::string manualText(const std::string& file) {
  return readFile(kFolder / file);
}

std::vector<std::string> all(const std::string& text, const std::regex& pattern, std::size_t group = 1) {
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
    found.push_back((*at)[group]);
  return found;
}

/// Rows and headings of the chapters: "4.1", "J10", "D8", "2.2", "13".
std::set<std::string> numbers() {
  static const std::set<std::string> kNumbers = [] {
    std::set<std::string> found;
    std::istringstream lines(manualText("techniques.md"));
    const std::regex pattern(R"((?:\| |#+ )([JD]?[0-9]+(?:\.[0-9]+[a-c]?)?)(?: \||\.? ).*)");
    std::smatch number;
    for (std::string line; std::getline(lines, line);)
      if (std::regex_match(line, number, pattern)) found.insert(number[1]);
    return found;
  }();
  return kNumbers;
}

/// What the invariants begin with.
std::set<std::string> invariantNumbers() {
  const std::vector<std::string> found =
      all("\n" + manualText("invariants.md"), std::regex(R"(\n([0-9]+)\. )"));
  return {found.begin(), found.end()};
}

/// Comments and texts of a source as running text: lines that go on are joined.
std::string running(const std::string& source) {
  std::string text = std::regex_replace(source, std::regex(R"(\n *//[/<]* *)"), " ");
  return std::regex_replace(text, std::regex("\"\\s*\\n\\s*\""), "");
}

struct Citations {
  std::vector<std::string> rows;       ///< "4.1" of "manual 4.1", "manual §4" and "manual 3.4 to 3.7"
  std::vector<std::string> pages;      ///< "conventions" of "manual, conventions"
  std::vector<std::string> invariants; ///< "37"
};

Citations citations(const std::string& source) {
  const std::string text = running(source);
  static const std::regex kRows(
      R"([Mm]anual ((?:§ ?)?[JD]?[0-9][0-9.]*[a-c]?(?:(?:, | and | or | to |; )(?:§ ?)?[JD]?[0-9][0-9.]*[a-c]?\b)*))");
  static const std::regex kRow(R"(([JD]?[0-9]+(?:\.[0-9]+[a-c]?)?))");
  static const std::regex kChapter(R"(([a-zA-Z0-9.]*) ?§ ?([0-9]+))");
  static const std::regex kPage(R"(\bmanual, ([a-z]{6,}))");
  static const std::regex kInvariants(R"([Ii]nvariants? ([0-9]+(?:(?:, | and | to )[0-9]+)*))");
  Citations found;
  for (const std::string& list : all(text, kRows))
    for (const std::string& row : all(list, kRow)) found.rows.push_back(row);
  for (std::sregex_iterator at(text.begin(), text.end(), kChapter), end; at != end; ++at)
    if ((*at)[1] != "2.0") found.rows.push_back((*at)[2]); // of glTF 2.0
  for (const std::string& page : all(text, kPage)) found.pages.push_back(page);
  for (const std::string& list : all(text, kInvariants))
    for (const std::string& number : all(list, std::regex("([0-9]+)"))) found.invariants.push_back(number);
  return found;
}

std::vector<fs::path> sources() {
  static const std::set<std::string> kEndings = {".h", ".cpp", ".glsl", ".frag", ".vert", ".comp", ".json"};
  std::vector<fs::path> files;
  for (const char* folder : {"core", "app", "shaders", "tests", "resources/presets"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (kEndings.contains(entry.path().extension().string()) && entry.path().filename() != "ManualTest.cpp")
        files.push_back(entry.path());
  return files;
}

/// The README and the pages of the manual.
std::vector<fs::path> documents() {
  std::vector<fs::path> files = {"README.md"};
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) files.push_back(entry.path());
  return files;
}

/// What links to headings of a page may say.
std::set<std::string> anchors(const fs::path& page) {
  std::set<std::string> found;
  for (const std::string& heading : all("\n" + readFile(page), std::regex(R"(\n#+ ([^\n]+))")))
    found.insert(headingAnchor(heading));
  return found;
}

} // namespace

TEST(Manual, CitationsAreRead) {
  const Citations found =
      citations("// By manual 3.4 to 3.7, D8 and\n/// §12 (manual, conventions); glTF 2.0 "
                "§3.7; invariants 17 to 19, 45.\n\"(manual \"\n    \"J10, HDRP)\"");
  EXPECT_EQ(found.rows, (std::vector<std::string>{"3.4", "3.7", "D8", "12", "J10", "12"}));
  EXPECT_EQ(found.pages, std::vector<std::string>{"conventions"});
  EXPECT_EQ(found.invariants, (std::vector<std::string>{"17", "19", "45"}));
}

TEST(Manual, NoCitationIsDead) {
  const std::set<std::string> rows = numbers(), invariants = invariantNumbers();
  ASSERT_GT(rows.size(), 200u);
  std::size_t count = 0;
  for (const fs::path& file : sources()) {
    const Citations found = citations(readFile(file));
    count += found.rows.size();
    for (const std::string& row : found.rows)
      EXPECT_TRUE(rows.contains(row)) << file << " cites " << row << ", which the manual has not";
    for (const std::string& number : found.invariants)
      EXPECT_TRUE(invariants.contains(number)) << file << " cites invariant " << number;
    for (const std::string& page : found.pages)
      EXPECT_TRUE(fs::exists(kFolder / (page + ".md"))) << file << " cites the page " << page;
  }
  EXPECT_GT(count, 400u);
}

TEST(Manual, NothingElseIsCited) {
  const std::regex absent("catalogue|[Dd]esign §");
  for (const fs::path& file : sources())
    EXPECT_FALSE(std::regex_search(readFile(file), absent)) << file << " cites what no reader has";
}

TEST(Manual, PathsLeadSomewhere) {
  const std::regex path(R"(`((?:core|app|shaders|tests|resources)(?:/[A-Za-z0-9_.-]+)+)[ `])");
  std::size_t count = 0;
  for (const fs::path& file : documents())
    for (const std::string& found : all(readFile(file), path)) {
      ++count;
      EXPECT_TRUE(fs::exists(found)) << file << " names " << found;
    }
  EXPECT_GT(count, 40u);
}

TEST(Manual, LinksLeadSomewhere) {
  const std::regex link(R"(\]\(([^)#]*)(?:#([^)]*))?\))");
  for (const fs::path& file : documents()) {
    const std::string text = readFile(file);
    for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
      const std::string target = (*at)[1], anchor = (*at)[2];
      if (target.starts_with("https://")) continue;
      const fs::path page = target.empty() ? file : file.parent_path() / target;
      EXPECT_TRUE(fs::exists(page)) << file << " links to " << target;
      if (!anchor.empty() && fs::exists(page)) {
        EXPECT_TRUE(anchors(page).contains(anchor)) << file << " links to " << target << "#" << anchor;
      }
    }
  }
}

TEST(Manual, PagesOfTablesAreAsTheTablesAre) {
  for (const ManualPage& page : manualTables())
    EXPECT_TRUE(manualText(page.file) == page.text)
        << page.file << " is old: run build/dev/bin/taa_manual pages resources/manual";
}

// Fog and the count are exposed alone: no stage makes anything of them.
TEST(Manual, TheFlowHasEveryTextureThatAStageReads) {
  const std::string page = manualText("intermediates.md");
  const std::size_t from = page.find("```text"), to = page.find("```\n", from + 7);
  ASSERT_NE(to, std::string::npos);
  const std::string flow = page.substr(from, to - from);
  const std::string inputs = readFile(std::string(TAA_SOURCE_DIR) + "/shaders/taa/inputs.glsl");
  const std::regex declared(R"(uniform u?sampler2D u_(\w+))");
  std::size_t textures = 0;
  for (std::sregex_iterator at(inputs.begin(), inputs.end(), declared), end; at != end; ++at, ++textures) {
    std::string name = (*at)[1];
    if (name.starts_with("history"))
      name = "history." + std::string(1, static_cast<char>(std::tolower(name[7]))) + name.substr(8);
    const bool isShownAlone = name == "fog" || name == "forwardCount";
    EXPECT_EQ(flow.find(name) != std::string::npos, !isShownAlone) << name;
  }
  EXPECT_EQ(textures, 17u);
}

TEST(Manual, ItsContentsNameEveryPage) {
  const std::vector<ManualPage> pages = manualPages();
  std::set<std::string> files;
  for (const ManualPage& page : pages) {
    EXPECT_FALSE(page.title.empty()) << page.file;
    EXPECT_EQ(page.text.find("<!--"), std::string::npos) << page.file;
    files.insert(page.file);
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder))
    EXPECT_TRUE(files.contains(entry.path().filename().string())) << entry.path() << " is in no contents";
  EXPECT_EQ(pages.front().file, "README.md");
}

TEST(Manual, AnchorsAreThoseOfTheWeb) {
  EXPECT_EQ(headingAnchor("Threads and jobs"), "threads-and-jobs");
  EXPECT_EQ(headingAnchor("2.1 Into the projection"), "21-into-the-projection");
}

} // namespace taa
