// Which explanation is told where several fit: by pixels, then by what it gains.
#include "core/doctor/motion/MotionJudgement.h"

#include <gtest/gtest.h>

namespace taa::doctor {
namespace {

TEST(BroadestTrial, IsTheOneOfTheMostPixelsWhateverItGains) {
  EXPECT_EQ(broadestTrial({{3, 100.0, 1.0}, {5, 90.0, 50.0}}), 3u);
  EXPECT_EQ(broadestTrial({{3, 100.0, 1.0}, {5, 90.0, 50.0}, {5, 20.0, 0.0}}), 5u) << "of two regions";
}

TEST(BroadestTrial, OfAsManyPixelsIsTheFirstThatGainsNearlyAsMuchAsAny) {
  EXPECT_EQ(broadestTrial({{2, 10.0, 50.0}, {4, 10.0, 99.5}, {7, 10.0, 100.0}}), 4u);
  EXPECT_EQ(broadestTrial({{7, 10.0, 100.0}, {2, 10.0, 99.5}}), 2u) << "by number, not by order";
}

// Outlines and centroids tell what pixels lose by: the search went on for ever, because none was found.
TEST(BroadestTrial, IsOneOfThoseThatFitWhereAllLose) {
  EXPECT_EQ(broadestTrial({{3, 10.0, -2.0}}), 3u);
  EXPECT_EQ(broadestTrial({{3, 10.0, -2.0}, {5, 10.0, -1.0}}), 5u);
  EXPECT_EQ(broadestTrial({{3, 10.0, -1.005}, {5, 10.0, -1.0}}), 3u);
}

} // namespace
} // namespace taa::doctor
