// Motion and depth at the silhouettes of a square that moves over what rests, read rightly, beside, and
// coarsely.
#include "core/doctor/motion/MotionSilhouettes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace taa::doctor {
namespace {

constexpr int kWidth = 96, kHeight = 96, kFrom = 24, kTo = 72;

/// `moved`: by so many px to the right and down.
bool isSquare(int x, int y, int moved) {
  return x - moved >= kFrom && x - moved < kTo && y - moved >= kFrom && y - moved < kTo;
}

/// `shift`, `coarse`: of the texels that motion and depth are read at, as the table of faults reads them.
DoctorFrame squareFrame(int shift, int coarse, int moved = 0) {
  DoctorFrame out;
  out.luma = Image(kWidth, kHeight, 1);
  out.motionPx = Image(kWidth, kHeight, 2);
  out.depth = Image(kWidth, kHeight, 1);
  out.objectId.assign(std::size_t(kWidth) * kHeight, 0);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      out.objectId[static_cast<std::size_t>(y) * kWidth + x] = isSquare(x, y, moved) ? 2 : 1;
      const bool isRead =
          isSquare(x / coarse * coarse + coarse / 2 - shift, y / coarse * coarse + coarse / 2 - shift, moved);
      out.motionPx.at(x, y)[0] = isRead ? 3.0f : 0.0f;
      *out.depth.at(x, y) = isRead ? 0.02f : 0.01f;
    }
  return out;
}

SilhouetteEvidence silhouettesOf(int shift, int coarse, int moved = 0) {
  SilhouetteEvidence out;
  for (int frame = 0; frame < 2; ++frame) out.add(squareFrame(shift, coarse, frame * moved));
  return out;
}

/// A ground without numbers, whose depth and motion grow to the right and down, and so does light;
/// `lightSide`: of the squares that have one light.
DoctorFrame slopeFrame(int depthSide, int motionSide, int lightSide) {
  DoctorFrame out;
  out.luma = out.depth = Image(kWidth, kHeight, 1);
  out.motionPx = Image(kWidth, kHeight, 2);
  const auto at = [](int x, int y, int side) {
    return static_cast<float>(x / side * side + 2 * (y / side * side));
  };
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      *out.luma.at(x, y) = at(x, y, lightSide);
      *out.depth.at(x, y) = 0.01f + 1e-4f * at(x, y, depthSide);
      out.motionPx.at(x, y)[0] = 0.01f * at(x, y, motionSide);
    }
  return out;
}

/// Ids of what is found.
std::string toldOfSlope(int depthSide, int motionSide, int lightSide) {
  SilhouetteEvidence silhouettes;
  silhouettes.add(slopeFrame(depthSide, motionSide, lightSide));
  Diagnosis out;
  tellSilhouettes(silhouettes, true, out);
  std::string text;
  for (const Finding& finding : out.findings) text += (text.empty() ? "" : ", ") + finding.id;
  return text;
}

} // namespace

TEST(MotionSilhouettes, AreNotNeededWherePixelsShareTexels) {
  EXPECT_EQ(toldOfSlope(1, 1, 1), "");
  EXPECT_EQ(toldOfSlope(2, 1, 1), "depthCoarse");
  EXPECT_EQ(toldOfSlope(1, 4, 1), "motionCoarse");
  EXPECT_EQ(toldOfSlope(3, 2, 1), "depthCoarse, motionCoarse");
  EXPECT_EQ(toldOfSlope(2, 2, 2), "") << "the picture itself is of such squares";
  EXPECT_EQ(toldOfSlope(4, 1, 2), "depthCoarse");
}

TEST(MotionSilhouettes, AreThoseOfTheirObjects) {
  const SilhouetteEvidence silhouettes = silhouettesOf(0, 1);
  // Both sides of four silhouettes of 48 pixels, in two frames.
  EXPECT_EQ(silhouettes.motion.pixels, 2u * 4u * 2u * (kTo - kFrom));
  EXPECT_EQ(silhouettes.motion.foreign, 0u);
  EXPECT_EQ(silhouettes.motion.verdict(), SilhouetteVerdict::Right);
  EXPECT_EQ(silhouettes.depth.verdict(), SilhouetteVerdict::Right);
}

TEST(MotionSilhouettes, AreOfWhatIsBesideWhereMotionIsReadBeside) {
  const SilhouetteEvidence silhouettes = silhouettesOf(1, 1);
  EXPECT_EQ(silhouettes.motion.verdict(), SilhouetteVerdict::Shifted);
  Diagnosis out;
  tellSilhouettes(silhouettes, true, out);
  ASSERT_EQ(out.findings.size(), 1u);
  EXPECT_EQ(out.findings[0].id, "motionShifted");
}

TEST(MotionSilhouettes, ArePartlyOfWhatIsBesideWhereValuesAreCoarse) {
  // In the second frame the silhouettes are at odd places, which squares of two do not have.
  const SilhouetteEvidence silhouettes = silhouettesOf(0, 2, 1);
  EXPECT_EQ(silhouettes.motion.verdict(), SilhouetteVerdict::Coarse);
  Diagnosis out;
  tellSilhouettes(silhouettes, true, out);
  ASSERT_EQ(out.findings.size(), 2u);
  EXPECT_EQ(out.findings[0].id, "depthCoarse");
  EXPECT_EQ(out.findings[1].id, "motionCoarse");
}

// A square whose silhouettes jitter moves by a whole pixel to the right and down, in every second frame back.
TEST(MotionSilhouettes, AreElsewhereWhereDepthHasNoJitter) {
  SilhouetteEvidence silhouettes, stated;
  for (const int moved : {1, -1}) {
    DoctorFrame frame = squareFrame(0, 1, moved);
    frame.depth = squareFrame(0, 1).depth;
    frame.motionPx = squareFrame(0, 1, moved).motionPx;
    frame.jitterPx = frame.depthJitterPx = glm::vec2(static_cast<float>(moved));
    silhouettes.add(frame);
    frame.depthJitterPx = glm::vec2(0.0f);
    stated.add(frame);
  }
  EXPECT_EQ(silhouettes.depth.verdict(), SilhouetteVerdict::Unjittered);
  EXPECT_EQ(silhouettes.motion.verdict(), SilhouetteVerdict::Right);
  EXPECT_EQ(stated.depth.verdict(), SilhouetteVerdict::TooFew); // it is said so
}

TEST(MotionSilhouettes, SayNothingOfMotionThatIsWrongElsewhere) {
  Diagnosis out;
  tellSilhouettes(silhouettesOf(1, 1), false, out);
  EXPECT_TRUE(out.isHealthy());
}

TEST(MotionSilhouettes, AreNotCountedWithoutNumbers) {
  DoctorFrame frame = squareFrame(0, 1);
  frame.objectId.clear();
  SilhouetteEvidence silhouettes;
  silhouettes.add(frame);
  EXPECT_EQ(silhouettes.motion.verdict(), SilhouetteVerdict::TooFew);
}

} // namespace taa::doctor
