// Tests of texts that are cut short.
#include "core/base/Text.h"

#include <gtest/gtest.h>

#include <string>

namespace taa {
namespace {

TEST(Text, OfFewBytesIsNotCut) {
  EXPECT_EQ(shortened("", 3), "");
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened(std::string(64, 'x'), 64), std::string(64, 'x'));
}

TEST(Text, OfMoreEndsWithAnEllipsisBetweenCharacters) {
  EXPECT_EQ(shortened("abcd", 3), "…");
  EXPECT_EQ(shortened("abcdefgh", 7), "abcd…");
  EXPECT_EQ(shortened("aäöüß", 8), "aäö…")
      << "9 bytes: 5 of them before the ellipsis, at the end of a character";
  EXPECT_EQ(shortened("aäöüß", 7), "aä…") << "a character of two bytes is whole or not there";
}

} // namespace
} // namespace taa
