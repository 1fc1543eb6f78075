// Factors of jitter along both axes: made-up shifts whose factors are known.
#include "core/doctor/jitter/JitterFactors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace taa::doctor {
namespace {

/// Of frames whose pictures hold the stated jitter times a factor, measured with an error that changes sign.
JitterEvidence evidenceOf(const glm::vec2& factor, float errorPx, int frames = 17) {
  JitterEvidence out;
  for (int frame = 0; frame < frames; ++frame)
    out.stated[frame] = {0.5f * std::sin(2.1f * static_cast<float>(frame)),
                         0.5f * std::cos(3.7f * static_cast<float>(frame))};
  for (int frame = 1; frame < frames; ++frame) {
    const glm::vec2 step = out.stated[frame - 1] - out.stated[frame];
    out.shifts.push_back({frame, step * factor + (frame % 2 == 0 ? errorPx : -errorPx)});
  }
  return out;
}

} // namespace

TEST(JitterFactors, AreThoseThatShiftsHave) {
  const auto two = measureFactors(evidenceOf({0.9f, 3.1f}, 0.01f));
  ASSERT_TRUE(two);
  EXPECT_NEAR(two->factor.x, 0.9, 3.0 * two->error.x);
  EXPECT_NEAR(two->factor.y, 3.1, 3.0 * two->error.y);
  EXPECT_TRUE(two->areBeyond(glm::dvec2(1.0)));
  EXPECT_TRUE(two->areBeyond({0.9, 1.0})); // along either axis
  EXPECT_FALSE(two->areBeyond(two->factor));
}

TEST(JitterFactors, AreOneWhereTwoLieWithinTheirErrors) {
  const auto one = measureFactors(evidenceOf({1.7f, 1.7f}, 0.02f));
  ASSERT_TRUE(one);
  EXPECT_EQ(one->factor.x, one->factor.y);
  EXPECT_NEAR(one->factor.x, 1.7, 0.05);
}

TEST(JitterFactors, ExplainShiftsThatAreNotThoseStated) {
  const auto explain = [](const glm::vec2& factor) {
    const JitterEvidence evidence = evidenceOf(factor, 0.01f);
    const auto factors = measureFactors(evidence);
    return factors && explainShifts(*factors, evidence);
  };
  EXPECT_TRUE(explain({1.0f, 1.4f}));
  EXPECT_TRUE(explain({0.8f, 0.8f}));
  EXPECT_FALSE(explain({1.0f, 1.0f}));
  EXPECT_FALSE(explain({0.95f, 0.95f})); // as of pictures that are read softly
}

TEST(JitterFactors, AreNoneOfShiftsThatFollowNoFactor) {
  EXPECT_FALSE(measureFactors(evidenceOf({1.0f, 1.0f}, 0.4f)));
  EXPECT_FALSE(measureFactors(evidenceOf({1.0f, 2.0f}, 0.0f, 5))); // too few
}

TEST(JitterFactors, AreNamedByTheAxisThatTheyAreOf) {
  EXPECT_EQ(factorsName({1.0f, 4.0f}), "y of jitter reported 0.25 times as large as it is");
  EXPECT_EQ(factorsName({0.5f, 0.98f}), "x of jitter reported 2 times as large as it is");
  EXPECT_EQ(factorsName({0.5f, 0.25f}), "x of jitter reported 2 times as large as it is, y 4 times");
  EXPECT_EQ(factorsName({0.8f, 0.8f}), "Jitter reported 1.25 times as large as it is");
}

// A known ratio is said where it lies within the errors, and only there.
TEST(JitterFactors, AreTheRatioOfTheSidesWithinTheirErrors) {
  const glm::ivec2 sizePx(340, 77);
  const double wide = 340.0 / 77.0;
  EXPECT_EQ(sidesText({{1.01, wide + 0.02}, {0.01, 0.02}}, sizePx),
            "That is the picture's width over its height: y is divided by the wrong one of the two.");
  EXPECT_EQ(sidesText({{1.0 / wide, 1.0}, {0.01, 0.01}}, sizePx),
            "That is the picture's height over its width: x is divided by the wrong one of the two.");
  EXPECT_EQ(sidesText({{1.0, wide + 0.2}, {0.01, 0.02}}, sizePx), "");
  EXPECT_EQ(sidesText({{1.0, 1.0}, {0.01, 0.02}}, {200, 200}), "");
}

} // namespace taa::doctor
