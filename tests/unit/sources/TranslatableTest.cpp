// Texts of the window go through tr(), so that they can be translated.
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
