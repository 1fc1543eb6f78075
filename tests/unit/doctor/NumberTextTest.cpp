// Numbers in the doctor's sentences.
#include "core/doctor/NumberText.h"

#include <gtest/gtest.h>

namespace taa::doctor {

TEST(NumberText, HasThreeDigitsAndFourAfterThePoint) {
  EXPECT_EQ(shortNumber(0.25), "0.25");
  EXPECT_EQ(shortNumber(13.249), "13.2");
  EXPECT_EQ(shortNumber(1280.4), "1280");
  EXPECT_EQ(shortNumber(0.03125), "0.0313");
  EXPECT_EQ(shortNumber(0.00001), "0");
  EXPECT_EQ(shortNumber(0.0), "0");
}

TEST(NumberText, HasNoMinusBeforeZero) {
  EXPECT_EQ(shortNumber(-0.00001), "0");
  EXPECT_EQ(shortVector({-0.0, -1.5}), "(0, -1.5)");
}

} // namespace taa::doctor
