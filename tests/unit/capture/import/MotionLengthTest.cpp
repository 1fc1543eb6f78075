// A length that was measured is said by the shortest number that its errors leave.
#include "core/capture/import/MotionLength.h"

#include <gtest/gtest.h>

namespace taa::capture {

TEST(MotionLength, IsOneShortNumberWhereBothAxesLeaveOne) {
  const MotionLength length{{39.775, 39.952}, {0.16, 0.16}};
  EXPECT_EQ(length.rounded(), glm::dvec2(40.0));
  EXPECT_EQ(length.text(), "Times 40: 39.78 ± 0.16 and 39.95 ± 0.16 as measured");
  EXPECT_EQ((MotionLength{{0.749, 0.7506}, {0.002, 0.002}}.rounded()), glm::dvec2(0.75));
  EXPECT_EQ((MotionLength{{0.3004, 0.2996}, {0.0005, 0.0005}}.rounded()), glm::dvec2(0.3)) << "not 3 · 0.1";
}

TEST(MotionLength, KeepsSignsAndAxesApart) {
  EXPECT_EQ((MotionLength{{-1.4691, 1.4964}, {0.003, 0.003}}.rounded()), glm::dvec2(-1.47, 1.5));
  EXPECT_EQ((MotionLength{{20.02, -20.02}, {0.05, 0.05}}.rounded()), glm::dvec2(20.0, -20.0));
}

TEST(MotionLength, StaysAsItIsWithoutAnError) {
  EXPECT_EQ((MotionLength{{1.234567, 1.3}, {0.0, 0.0}}.rounded()), glm::dvec2(1.234567, 1.3));
}

} // namespace taa::capture
