// Whether depth was drawn with jitter, of frames of a wall that leans away from the camera.
#include "core/capture/import/DepthJitter.h"

#include "core/capture/import/Guess.h"
#include "tests/support/Paths.h"
#include "tests/unit/capture/import/LeaningWall.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace taa::capture {

namespace {

class DepthJitterTest : public testing::Test {
 protected:
  ~DepthJitterTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ = test::temporaryFolder() / "wall";
};

/// What the wrong answer about depth's jitter leaves: by the frames' difference of jitter another place of
/// the wall, whose reversed depth 1/d has the same slope everywhere. × 1000, over pixels where it is enough
/// to be told.
double missOfTheOtherAnswer(const LeaningWall& wall) {
  const glm::dvec2 slope(wall.lean.x / LeaningWall::kSlopeX * 2.0 / MovingSquare::kWidth,
                         -wall.lean.y / LeaningWall::kSlopeY * 2.0 / MovingSquare::kHeight);
  double sum = 0.0, count = 0.0;
  for (int frame = 1; frame < MovingSquare::kFrames; ++frame) {
    const glm::dvec2 step = MovingSquare::jitterPx(frame - 1) - MovingSquare::jitterPx(frame);
    const double change = std::abs(glm::dot(slope, step)) / (1.0 - wall.lean.x * wall.stepM * frame);
    for (int y = 0; y < MovingSquare::kHeight; ++y)
      for (int x = 0; x < MovingSquare::kWidth; ++x) {
        const double miss = change * wall.distanceAt(glm::dvec2(x, y) + 0.5, frame);
        if (miss < 0.002) continue;
        sum += miss;
        count += 1.0;
      }
  }
  return 1000.0 * sum / count;
}

} // namespace

TEST_F(DepthJitterTest, IsFound) {
  LeaningWall wall;
  for (const bool isJittered : {true, false}) {
    SCOPED_TRACE(isJittered);
    wall.isDepthJittered = isJittered;
    writeWall(folder_, wall);
    const Guess guess = guessCapture(folder_, "", {});
    EXPECT_EQ(guess.manifest.conventions.depth.kind, DepthKind::Planar);
    EXPECT_EQ(guess.manifest.conventions.depth.jittered, isJittered);
    const Finding finding = findingOf(guess.findings, "depth.jittered");
    EXPECT_TRUE(finding.isSure) << finding.reason;
    EXPECT_FALSE(finding.contradicts());
    ASSERT_EQ(finding.hypotheses.size(), 2u);
    EXPECT_TRUE(finding.hypotheses[0].isChosen);
    // Floats, and the curve of what motion stands for within a jitter's length.
    EXPECT_LT(finding.hypotheses[0].residual, 0.02);
    EXPECT_NEAR(finding.hypotheses[1].residual, missOfTheOtherAnswer(wall),
                0.02 * missOfTheOtherAnswer(wall));
  }
}

TEST_F(DepthJitterTest, ContradictsWhatIsStated) {
  LeaningWall wall;
  wall.isDepthJittered = false;
  writeWall(folder_, wall);
  const Guess guess = guessCapture(folder_, "", {"depth.jittered=on"});
  EXPECT_TRUE(guess.manifest.conventions.depth.jittered);
  EXPECT_TRUE(findingOf(guess.findings, "depth.jittered").contradicts());
}

TEST_F(DepthJitterTest, IsNotSureWhereNothingIsSteep) {
  LeaningWall wall;
  wall.lean = {0.0, 0.0};
  wall.isDepthJittered = false;
  writeWall(folder_, wall);
  const Guess guess = guessCapture(folder_, "", {});
  const Finding finding = findingOf(guess.findings, "depth.jittered");
  EXPECT_FALSE(finding.isSure);
  EXPECT_TRUE(guess.manifest.conventions.depth.jittered) << "the default stands";
  EXPECT_NE(finding.reason.find("too little is steep enough"), std::string::npos) << finding.reason;
}

TEST_F(DepthJitterTest, IsNotSureWhereMatricesAreOfSomethingElse) {
  LeaningWall wall;
  wall.statedStepM = -2.0 * wall.stepM;
  writeWall(folder_, wall);
  const Finding finding = findingOf(guessCapture(folder_, "", {}).findings, "depth.jittered");
  EXPECT_FALSE(finding.isSure);
  EXPECT_NE(finding.reason.find("neither answer's"), std::string::npos) << finding.reason;
}

TEST_F(DepthJitterTest, IsNotAskedWithoutWhatTellsIt) {
  writeWall(folder_, {});
  std::filesystem::remove(folder_ / "frames.json");
  for (const Finding& finding : guessCapture(folder_, "", {}).findings)
    EXPECT_NE(finding.path, "depth.jittered");
}

} // namespace taa::capture
