// A thing that is not drawn for some frames and comes back: its own next motions say whether the first one is
// that of an old transform.
#include "core/doctor/motion/MotionReturns.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kWidth = 20, kHeight = 10;

/// All of the picture is region 0, and its left half region 1 where it is drawn, with this motion.
std::vector<Return> returnsOf(const std::vector<std::optional<glm::vec2>>& motions) {
  ReturnEvidence evidence;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    DoctorFrame frame;
    frame.frame = static_cast<int>(i);
    frame.startsHistory = i == 0;
    frame.motionPx = Image(kWidth, kHeight, 2);
    std::vector<RegionIndex> labels(std::size_t{kWidth} * kHeight, 0);
    for (int y = 0; y < kHeight && motions[i]; ++y)
      for (int x = 0; x < kWidth / 2; ++x) {
        labels[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] = 1;
        frame.motionPx.at(x, y)[0] = motions[i]->x;
        frame.motionPx.at(x, y)[1] = motions[i]->y;
      }
    evidence.add(frame, labels);
  }
  return evidence.found();
}

using Motions = std::vector<std::optional<glm::vec2>>;

} // namespace

TEST(MotionReturns, WithAnOldTransformJump) {
  const glm::vec2 own(3.0f, 0.0f);
  const std::vector<Return> found =
      returnsOf(Motions{own, own, {}, {}, {}, glm::vec2(33.0f, 6.0f), own, own, own});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].region, 1);
  EXPECT_EQ(found[0].frame, 5);
  EXPECT_EQ(found[0].px, glm::dvec2(33.0, 6.0));
  EXPECT_EQ(found[0].next, glm::dvec2(3.0, 0.0));
}

TEST(MotionReturns, ThatGoOnAsTheyGoAreRight) {
  const glm::vec2 own(3.0f, 0.0f);
  EXPECT_TRUE(returnsOf(Motions{own, own, {}, {}, {}, own, own, own}).empty());
  // It brakes.
  EXPECT_TRUE(
      returnsOf(Motions{own, {}, {}, glm::vec2(12.0f, 0.0f), glm::vec2(9.0f, 0.0f), glm::vec2(6.0f, 0.0f)})
          .empty());
  // It was there all the time: what it does is not asked here.
  EXPECT_TRUE(returnsOf(Motions{own, own, glm::vec2(33.0f, 6.0f), own, own}).empty());
}

TEST(MotionReturns, MarkedAsWithoutAPreviousPositionAreRight) {
  const glm::vec2 own(3.0f, 0.0f);
  EXPECT_TRUE(returnsOf(Motions{own, {}, {}, glm::vec2(kNoPreviousPosition), own, own}).empty());
}

} // namespace taa::doctor
