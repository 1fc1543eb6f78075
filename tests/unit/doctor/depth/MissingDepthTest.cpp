// A board that is drawn into the picture and not into depth, of painted frames.
#include "core/doctor/depth/MissingDepth.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace taa::doctor {
namespace {

constexpr int kFrames = 12;

Diagnosis diagnosisWith(const test::FrameFault& fault) {
  return examine(test::paintedExamination({}, kFrames, fault));
}

bool isFound(const Diagnosis& diagnosis) {
  return test::idsOf(diagnosis).find("depthOfObjectMissing") != std::string::npos;
}

/// The ground goes on where the board is.
void leaveBoardOut(DoctorFrame& frame) {
  const auto groundAt = [&](const Image& plane) { return plane.pixels.back(); };
  for (Image* plane : {&frame.depth, &frame.depthView, &frame.previousDepthView}) {
    const float ground = groundAt(*plane);
    for (std::size_t i = 0; i < frame.objectId.size(); ++i)
      if (frame.objectId[i] == test::kBoardId) plane->pixels[i] = ground;
  }
}

} // namespace

TEST(MissingDepth, IsThatOfWhatHasNoOutlineInDepth) {
  EXPECT_FALSE(isFound(diagnosisWith({})));
  const Diagnosis diagnosis = diagnosisWith(leaveBoardOut);
  ASSERT_EQ(test::idsOf(diagnosis), "depthOfObjectMissing");
  const Finding& finding = diagnosis.findings[0];
  ASSERT_EQ(finding.regions.size(), 1u);
  EXPECT_EQ(finding.regions[0].objectId, test::kBoardId);
}

// What is painted on the ground rests with it: nothing is missing there.
TEST(MissingDepth, IsNoneOfWhatMovesWithWhatIsBehind) {
  test::PaintedShot shot;
  shot.boardPx = glm::dvec2(0.0);
  EXPECT_FALSE(isFound(examine(test::paintedExamination(shot, kFrames, leaveBoardOut))));
}

} // namespace taa::doctor
