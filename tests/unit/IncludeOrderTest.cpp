// Reads the sources and holds them to the directions of design §4 and the file rules of the house style.
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
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

/// Where a file stands: its folder below core, "core" for the façade, "app", or a folder of panels.
std::string layerOf(const std::string& path) {
  static const std::regex kLayer(R"(^(core|app|shaders)/(?:([a-z]+)/)?)");
  std::smatch match;
  if (!std::regex_search(path, match, kLayer)) return "";
  return match[1] == "core" && match[2].matched ? match[2].str() : match[1].str();
}

/// Which layers a layer may include, itself apart (design §4).
const std::map<std::string, std::vector<std::string>>& allowedLayers() {
  static const std::map<std::string, std::vector<std::string>> kAllowed = [] {
    std::map<std::string, std::vector<std::string>> allowed;
    const std::vector<std::string> low = {"base", "gl", "settings", "scene", "shaders"};
    const auto plus = [](std::vector<std::string> list, const std::vector<std::string>& more) {
      list.insert(list.end(), more.begin(), more.end());
      return list;
    };
    allowed["base"] = {};
    for (const char* layer : {"gl", "settings", "scene"}) allowed[layer] = {"base", "shaders"};
    for (const char* layer : {"render", "capture"}) allowed[layer] = low;
    allowed["taa"] = plus(low, {"render", "capture"});
    allowed["inspect"] = plus(allowed["taa"], {"taa"});
    // Finished frames with their tables, wherever they came from; never the window or the command line.
    allowed["io"] = {"base", "settings", "scene", "taa", "render", "shaders"};
    allowed["core"] = plus(allowed["inspect"], {"inspect", "io"});
    allowed["cli"] = plus(allowed["core"], {"core"});
    allowed["app"] = allowed["cli"];
    return allowed;
  }();
  return kAllowed;
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
  EXPECT_EQ(layerOf("core/base/Error.h"), "base");
  EXPECT_EQ(layerOf("core/Inspector.h"), "core");
  EXPECT_EQ(layerOf("app/panels/Probe.h"), "app");
  EXPECT_TRUE(isQtHeader("QString") && isQtHeader("QtTest/QSignalSpy") && !isQtHeader("Quantity.h"));
}

TEST(IncludeOrder, GoesDownOnly) {
  for (const Source& source : coreAndApp()) {
    const std::string layer = layerOf(source.path);
    const auto row = allowedLayers().find(layer);
    ASSERT_NE(row, allowedLayers().end()) << source.path << " is in a folder that design §4 does not know";
    for (const std::string& include : source.includes) {
      const std::string other = layerOf(include);
      if (other.empty() || other == layer) continue;
      EXPECT_NE(std::ranges::find(row->second, other), row->second.end())
          << source.path << " includes " << include << ", which is not below it";
    }
  }
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
