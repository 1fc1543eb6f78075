// Texts of files that nobody has looked at, as messages show them.
#include "core/base/ShownText.h"

#include <gtest/gtest.h>

#include <string>

namespace taa {

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

} // namespace taa
