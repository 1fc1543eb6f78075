// Reads the sources and holds them to the directions of manual, architecture and the file rules of the house
// style.
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Source {
  std::string path; ///< from the root: "core/taa/TaaPass.h"
  std::vector<std::string> lines;
  std::vector<std::string> includes;

  bool isHeader() const { return path.ends_with(".h"); }
  bool isBelow(const std::string& folder) const { return path.starts_with(folder + "/"); }
};

Source readSource(const fs::path& path) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
  Source source{path.generic_string(), {}, {}};
  std::istringstream text(taa::readFile(path));
  for (std::string line; std::getline(text, line);) {
    std::smatch match;
    if (line.find("include") != std::string::npos && std::regex_search(line, match, kInclude))
      source.includes.push_back(match[1]);
    source.lines.push_back(line);
  }
  return source;
}

std::vector<Source> readSources(const std::vector<std::string>& folders) {
  std::vector<Source> sources;
  for (const std::string& folder : folders)
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
        sources.push_back(readSource(entry.path()));
  return sources;
}

const std::vector<Source>& coreAndApp() {
  static const std::vector<Source> sources = readSources({"core", "app"});
  return sources;
}

const std::vector<Source>& all() {
  static const std::vector<Source> sources = readSources({"core", "app", "tests"});
  return sources;
}

/// Where a file stands: its folder below core; of app the whole folder, "app/views/plots"; "shaders".
std::string roomOf(const std::string& path) {
  static const std::regex kRoom(R"(^(core/([a-z]+)|app|shaders)/)");
  std::smatch match;
  if (!std::regex_search(path, match, kRoom)) return "";
  if (match[1] == "app") return fs::path(path).parent_path().generic_string();
  return match[2].matched ? match[2].str() : match[1].str();
}

std::string folderOf(const std::string& path) {
  return fs::path(path).parent_path().generic_string();
}

/// The floors of the house, the ground first (manual, architecture): a room includes what stands on floors
/// below its own.
const std::vector<std::vector<std::string>>& floors() {
  static const std::vector<std::vector<std::string>> kFloors = {
      {"shaders"},
      {"base"},
      {"gl", "settings", "scene"},
      {"render"},
      {"capture"},
      {"taa"},
      {"probe", "replay", "explanation", "io"},
      {"measure"},
      {"verdict", "doctor"},
      {"picture"},
      {"inspect"},
      {"report", "sweep"},
      {"lessons"},
      {"requests"},
      {"jobs"},
      {"cli"},
      {"app/style"},
      {"app/widgets", "app/widgets/areas"},
      {"app/widgets/parameters"},
      {"app/widgets/bars"},
      {"app/undo", "app/background"},
      {"app/session"},
      {"app/session/keeping"},
      {"app/models"},
      {"app/models/alternatives", "app/models/verdict"},
      {"app/views/legend", "app/views/plots", "app/views/timeline", "app/widgets/probe"},
      {"app/views"},
      {"app/panels", "app/dialogs", "app/importing", "app/doctor"},
      {"app/learn", "app/docks"},
      {"app/commands", "app/figures"},
      {"app/room"},
      {"app/menus"},
      {"app/window/verdict"},
      {"app/window"},
      {"app"},
  };
  return kFloors;
}

/// Nothing: a room that is not in the plan.
std::optional<std::size_t> floorOf(const std::string& room) {
  for (std::size_t floor = 0; floor < floors().size(); ++floor)
    if (std::ranges::find(floors()[floor], room) != floors()[floor].end()) return floor;
  return {};
}

bool isGlHeader(const std::string& include) {
  return include.starts_with("epoxy/") || include.starts_with("GL/") || include.starts_with("EGL/") ||
         include.starts_with("GLES");
}

bool isQtHeader(const std::string& include) {
  static const std::regex kQt(R"(^(Q[A-Z]\w*|Qt\w*/.*)$)");
  return std::regex_match(include, kQt);
}

} // namespace

TEST(IncludeOrder, FindsTheSources) {
  EXPECT_GT(coreAndApp().size(), 8u);
  EXPECT_EQ(roomOf("core/base/Error.h"), "base");
  EXPECT_EQ(roomOf("core/scene/gltf/GltfLoader.h"), "scene");
  EXPECT_EQ(roomOf("core/jobs/RenderThread.h"), "jobs");
  EXPECT_EQ(roomOf("app/panels/Probe.h"), "app/panels");
  EXPECT_EQ(roomOf("app/views/plots/CurveChart.h"), "app/views/plots");
  EXPECT_TRUE(isQtHeader("QString") && isQtHeader("QtTest/QSignalSpy") && !isQtHeader("Quantity.h"));
}

TEST(IncludeOrder, GoesDownOnly) {
  for (const Source& source : coreAndApp()) {
    const std::string room = roomOf(source.path);
    const std::optional<std::size_t> floor = floorOf(room);
    ASSERT_TRUE(floor) << source.path << " is in a folder that the plan does not know";
    for (const std::string& include : source.includes) {
      const std::string other = roomOf(include);
      if (other.empty() || other == room) continue;
      EXPECT_LT(floorOf(other).value_or(floors().size()), *floor)
          << source.path << " includes " << include << ", which is not below it";
    }
  }
}

// A subfolder is a layer, above or below what it stands in, or it is no subfolder.
TEST(IncludeOrder, HasNoLoopsBetweenFolders) {
  std::map<std::string, std::set<std::string>> uses;
  for (const Source& source : coreAndApp())
    for (const std::string& include : source.includes)
      if (!roomOf(include).empty() && folderOf(include) != folderOf(source.path))
        uses[folderOf(source.path)].insert(folderOf(include));
  ASSERT_GT(uses.size(), 40u);
  for (const auto& [start, first] : uses) {
    std::set<std::string> reached;
    std::vector<std::string> open(first.begin(), first.end());
    while (!open.empty()) {
      const std::string folder = open.back();
      open.pop_back();
      if (reached.insert(folder).second && uses.contains(folder))
        open.insert(open.end(), uses[folder].begin(), uses[folder].end());
    }
    EXPECT_FALSE(reached.contains(start)) << start << " uses what uses it";
  }
}

// Whoever looks for one thing finds it beside its neighbors.
TEST(Sources, AreNotAloneInASubfolder) {
  std::map<std::string, std::set<std::string>> things;
  for (const Source& source : coreAndApp())
    things[folderOf(source.path)].insert(fs::path(source.path).stem().generic_string());
  for (const auto& [folder, names] : things)
    EXPECT_GT(names.size(), 1u) << *names.begin() << " is alone in " << folder;
}

TEST(IncludeOrder, KeepsGlInsideTheGlFolder) {
  for (const Source& source : all())
    for (const std::string& include : source.includes)
      EXPECT_TRUE(!isGlHeader(include) || (source.isBelow("core/gl") && !source.isHeader()))
          << source.path << " includes " << include;
}

TEST(IncludeOrder, KeepsQtOutOfTheCore) {
  for (const Source& source : all())
    for (const std::string& include : source.includes)
      EXPECT_FALSE(isQtHeader(include) && source.isBelow("core")) << source.path << " includes " << include;
}

TEST(IncludeOrder, HasNoWayBetweenPanels) {
  for (const Source& source : coreAndApp())
    for (const std::string& include : source.includes)
      if (source.isBelow("app/panels") && include.starts_with("app/panels/")) {
        const fs::path own = fs::path(source.path).replace_extension(".h");
        EXPECT_EQ(include, own.generic_string()) << source.path << " includes another panel";
      }
}

TEST(Sources, BeginWithAComment) {
  for (const Source& source : all()) {
    // A .cpp beside a header is introduced by the header.
    if (!source.isHeader() && fs::exists(fs::path(source.path).replace_extension(".h"))) continue;
    ASSERT_FALSE(source.lines.empty()) << source.path;
    EXPECT_TRUE(source.lines[0].starts_with("// ")) << source.path << " begins with: " << source.lines[0];
  }
}

TEST(Sources, HaveOneGuardInEachHeader) {
  for (const Source& source : all())
    EXPECT_EQ(std::ranges::count(source.lines, "#pragma once"), source.isHeader() ? 1 : 0) << source.path;
}

TEST(Sources, OpenNoNamespaceInHeaders) {
  for (const Source& source : all())
    for (const std::string& line : source.lines)
      EXPECT_FALSE(source.isHeader() && line.find("using namespace") != std::string::npos) << source.path;
}
