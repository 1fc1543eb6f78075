// Numbers as text, and how number fields move.
#include "app/style/Numbers.h"
#include "app/widgets/parameters/NumberScale.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>

using namespace taa::app;

TEST(Numbers, ExactTextReadsBackAsTheSameFloat) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isnan(value)) continue;
    EXPECT_EQ(exactText(value).toFloat(), value) << exactText(value).toStdString();
  }
  EXPECT_EQ(exactText(0.1f), "0.1");
  EXPECT_EQ(exactText(std::nanf("")), "nan");
}

TEST(Numbers, AlignedTextsHaveTheirPointsInOneColumn) {
  const QChar space(QChar::Nbsp);
  EXPECT_EQ(alignedText("3.25", 6), "3.25" + QString(3, space));
  EXPECT_EQ(alignedText("−100", 6), QStringLiteral("−100") + QString(6, space));
  EXPECT_EQ(alignedText("0.00125", 6), "0.00125");
}

TEST(Numbers, FixedTextsHaveTheirDecimalsAndNoSignOfZero) {
  EXPECT_EQ(fixedText(-0.125, 2), QStringLiteral("−0.13"));
  EXPECT_EQ(fixedText(2.0, 3), "2.000");
  EXPECT_EQ(fixedText(-0.004, 2), "0.00");
  EXPECT_EQ(fixedText(-0.0, 0), "0");
}

TEST(Numbers, RoundedTextsHaveFiveDigitsAndNoSignOfZero) {
  EXPECT_EQ(roundedText(0.17883301f), "0.17883");
  EXPECT_EQ(roundedText(-8.575681f), QStringLiteral("−8.5757"));
  EXPECT_EQ(roundedText(0.005830441f), "0.00583");
  EXPECT_EQ(roundedText(0.25f), "0.25");
  EXPECT_EQ(roundedText(100.0f), "100");
  EXPECT_EQ(roundedText(1234567.0f), "1234567") << "no digit of an id is lost";
  EXPECT_EQ(roundedText(-0.0f), "0");
  EXPECT_EQ(roundedText(8.05e-6f), "0.000008");
  EXPECT_EQ(roundedText(-1e-9f), QStringLiteral("≈ 0")) << "which is not 0";
  EXPECT_EQ(roundedText(std::nanf("")), "nan");
  EXPECT_EQ(roundedText(-INFINITY), QStringLiteral("−inf"));
}

TEST(Numbers, TuplesNameEveryChannel) {
  const float values[] = {3.20711f, -0.08f};
  EXPECT_EQ(tupleText(values, 3), QStringLiteral("(3.21, −0.08)"));
  EXPECT_EQ(tupleText(std::span(values).first(1), 3), "3.21");
}

TEST(NumberScale, StepsAreRoundAndStayInTheRange) {
  const NumberScale unit{0, 1};
  EXPECT_EQ(unit.stepped(0.1, 1), 0.11);
  EXPECT_EQ(unit.stepped(0.995, 5), 1.0);
  const NumberScale frames{1, 1024, true};
  EXPECT_EQ(frames.stepped(16, -3), 13);
  EXPECT_EQ(frames.stepped(1, -3), 1);
}

TEST(NumberScale, ADragAcrossTheFieldCrossesTheRange) {
  const NumberScale unit{0, 4};
  EXPECT_DOUBLE_EQ(unit.dragged(0, 250), 4.0);
  const NumberScale frames{1, 1024, true};
  EXPECT_TRUE(frames.isLogarithmic());
  EXPECT_NEAR(frames.dragged(1, 250), 1024, 1e-9);
  EXPECT_NEAR(frames.fraction(32), 0.5, 1e-12);
  EXPECT_EQ(frames.rounded(31.7, false), 32);
}

TEST(NumberScale, FreeNumbersMoveByTheirSize) {
  const NumberScale free;
  EXPECT_FALSE(free.isBounded());
  EXPECT_EQ(free.quantum(12.0), 1.0);
  EXPECT_DOUBLE_EQ(free.quantum(0.5), 0.01);
  EXPECT_EQ(free.fraction(3.0), 0.0);
}
