// Texts of files that nobody has looked at, as messages show them.
#include "core/base/ShownText.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace taa {

using namespace std::string_view_literals;

TEST(ShownText, IsShortAndHasNothingThatMovesACursor) {
  EXPECT_EQ(shownText("a\nb\x1b[2Jc"), "a?b?[2Jc");
  EXPECT_EQ(shownText("\xff\xc3(\xed\xa0\x80"), "\?\?(\?\?\?");
  EXPECT_EQ(shownText("Bäume −½"), "Bäume −½");
  EXPECT_EQ(shownText(std::string(101, 'x')), std::string(100, 'x') + "…");
  EXPECT_EQ(shownText(std::string(99, 'x') + "½"), std::string(99, 'x') + "…");
  EXPECT_TRUE(isPlainText("Bäume 🌲"));
  EXPECT_FALSE(isPlainText("a\tb"));
  EXPECT_FALSE(isPlainText("\xc0\xaf"));
  EXPECT_FALSE(isPlainText("\xe2\x88"));
  EXPECT_FALSE(isPlainText("\xc2\x9b"));
}

TEST(ShownText, KeepsAllLettersOfAName) {
  EXPECT_EQ(plainText("Bäume\n\xff" + std::string(200, 'x')), "Bäume??" + std::string(200, 'x'));
}

TEST(ShownText, OfASentenceIsOneLineWithItsReason) {
  EXPECT_EQ(shownLine("cannot open a\nwarning: b\x1b[31m\x00: gone"sv),
            "cannot open a warning: b?[31m?: gone");
  const std::string name(5000, 'x');
  EXPECT_EQ(shownLine("cannot open " + name + ": it is a folder"),
            "cannot open " + std::string(1500 - 12, 'x') + "…" + std::string(500 - 16, 'x') +
                ": it is a folder");
  EXPECT_TRUE(isPlainText(shownLine(std::string(1499, 'x') + std::string(2000, '\xc2') + "½½½½")));
  std::string halves;
  for (int i = 0; i < 3001; ++i) halves += "½";
  EXPECT_TRUE(isPlainText(shownLine("x" + halves)));
  EXPECT_LE(shownLine("x" + halves).size(), 2005u);
}

TEST(ShownText, OfACompilerKeepsItsLines) {
  EXPECT_EQ(shownLines("shaders/a.frag:\n\tline 3: \x1b[31m"), "shaders/a.frag:\n\tline 3: ?[31m");
}

TEST(ShownText, OfALibrarysReasonIsForPeople) {
  try {
    static_cast<void>(nlohmann::json::parse("[1]").at("name"));
    FAIL() << "a list has no names";
  } catch (const std::exception& error) {
    EXPECT_EQ(shownReason(error), "a value in it is missing, or of another kind than is expected there");
  }
  EXPECT_EQ(shownReason(std::runtime_error("a\tb\x1b")), "a\tb?");
}

} // namespace taa
