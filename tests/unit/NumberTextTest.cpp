// Numbers as text.
#include "core/base/NumberText.h"

#include <gtest/gtest.h>

#include <cmath>

namespace taa {

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

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(shortestText(0.1f), "0.1");
  EXPECT_EQ(shortestText(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(decimalText(100000.0), "100000");
  EXPECT_EQ(decimalText(1e-5), "1e-05");
}

TEST(NumberText, HasTheDigitsThatAreAskedFor) {
  EXPECT_EQ(significantText(0.25, 4), "0.25");
  EXPECT_EQ(significantText(123456.0, 3), "1.23e+05");
  EXPECT_EQ(fixedText(0.25, 3), "0.250");
  EXPECT_EQ(fixedText(1e300, 2).size(), 304u);
  EXPECT_EQ(roundedText(0.2501, 3), "0.25");
  EXPECT_EQ(roundedText(-0.0001, 3), "0");
  EXPECT_EQ(numberText(-0.25), "−0.25");
  EXPECT_EQ(numberText(std::nan("")), "nan");
  EXPECT_EQ(shortestText(-std::nanf("")), "nan") << "whatever its sign";
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

} // namespace taa
