// Texts of the window go through tr(), and what the core is doing through say(), so that all of them can be
// found; nothing is decided by how they read.
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace {

/// What shows its first argument to a person.
constexpr const char* kShown =
    R"x((setText|setToolTip|setWindowTitle|setPlaceholderText|setAccessibleName|setAccessibleDescription|)x"
    R"x(setStatusTip|setTitle|setHeaderLabels|showError|showHint|addAction|addMenu|addTab|addButton|)x"
    R"x(QLabel|QPushButton|QCheckBox|QGroupBox|QAction|Prompt|IconButton)\()x"
    R"x([^;"]*?(QStringLiteral|QLatin1String|QString|u)?\(?u?"((?:[^"\\]|\\.)*)")x";

/// A word that somebody reads: not an icon's name, a format or a number.
bool isWords(const std::string& text) {
  return std::regex_search(text, std::regex("[A-Za-z]{3,} [a-z]{2,}|^[A-Z][a-z]{2,}"));
}

std::vector<std::string> untranslated(const std::string& source) {
  std::vector<std::string> found;
  const std::regex shown(kShown);
  for (std::sregex_iterator at(source.begin(), source.end(), shown), end; at != end; ++at) {
    const std::string whole = at->str();
    if (whole.find("tr(") != std::string::npos || whole.find("translate(") != std::string::npos) continue;
    if (isWords((*at)[3].str())) found.push_back(whole);
  }
  return found;
}

std::vector<std::string> matches(const std::string& source, const std::regex& pattern) {
  return {std::sregex_token_iterator(source.begin(), source.end(), pattern), std::sregex_token_iterator()};
}

/// Sentences, and what work is called, that are compared.
std::vector<std::string> comparisons(const std::string& source) {
  static const std::regex kCompared(
      R"x([=!]= (?:taa::)?say<[^;]*|say<"[^"]*">\([^;()]*\) [=!]= [^;]*|\.what [=!]= [^;]*)x");
  return matches(source, kCompared);
}

/// What is reported as being done without say().
std::vector<std::string> unsaid(const std::string& source) {
  static const std::regex kReported(R"x(\breport\(\w+, "[^"]+")x");
  return matches(source, kReported);
}

} // namespace

TEST(Translatable, FindsWhatIsNot) {
  EXPECT_EQ(untranslated(R"(label->setText(QStringLiteral("Two words"));)").size(), 1u);
  EXPECT_EQ(untranslated(R"(auto* button = new QPushButton("Close");)").size(), 1u);
  EXPECT_TRUE(untranslated(R"(label->setText(tr("Two words"));)").empty());
  EXPECT_TRUE(untranslated(R"(new IconButton(QStringLiteral("stop"), tr("Stop"));)").empty());
  EXPECT_TRUE(untranslated(R"(label->setText(QStringLiteral("%1 × %2"));)").empty());
}

TEST(Translatable, EveryTextOfTheWindowIs) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("app")) {
    if (entry.path().extension() != ".cpp") continue;
    ++files;
    for (const std::string& text : untranslated(taa::readFile(entry.path())))
      ADD_FAILURE() << entry.path().string() << ": " << text;
  }
  EXPECT_GT(files, 40);
}

TEST(Translatable, FindsSentencesThatAreCompared) {
  EXPECT_EQ(comparisons(R"(if (what == say<"Measuring">()) ++done;)").size(), 1u);
  EXPECT_EQ(comparisons(R"(return say<"%1 is off">(name) != text;)").size(), 1u);
  EXPECT_EQ(comparisons(R"(if (work.what == "Measuring") return;)").size(), 1u);
  EXPECT_TRUE(comparisons(R"(return x == 0 ? say<"none">() : say<"some">();)").empty());
  EXPECT_EQ(unsaid(R"(report(progress, "Measuring", 1, 2);)").size(), 1u);
  EXPECT_TRUE(unsaid(R"(report(progress, say<"Measuring">(), 1, 2);)").empty());
}

// The command line is English.
TEST(Translatable, WhatTheCoreIsDoingIsSaidAndNeverCompared) {
  int files = 0;
  for (const char* folder : {"core", "app"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      ++files;
      const std::string source = taa::readFile(entry.path()), path = entry.path().generic_string();
      for (const std::string& text : comparisons(source)) ADD_FAILURE() << path << ": " << text;
      if (path.starts_with("core/cli/")) continue;
      for (const std::string& text : unsaid(source)) ADD_FAILURE() << path << ": " << text;
    }
  EXPECT_GT(files, 500);
}
