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

// Two digits of the error, and as many of what was measured.
TEST(NumberText, OfAMeasurementEndsWhereItsErrorDoes) {
  EXPECT_EQ(measuredNumber(319.87432, 0.4142), "319.87");
  EXPECT_EQ(errorNumber(0.4142), "0.41");
  EXPECT_EQ(measuredNumber(319.87432, 25.3), "320");
  EXPECT_EQ(errorNumber(25.3), "25");
  EXPECT_EQ(measuredNumber(-0.75012, 0.00123), "-0.7501");
  EXPECT_EQ(errorNumber(0.00123), "0.0012");
}

} // namespace taa::doctor
