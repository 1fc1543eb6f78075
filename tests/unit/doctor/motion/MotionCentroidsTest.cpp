// Small plain squares that move by parts of a pixel before a wall, drawn where pixel centers lie in them.
#include "core/doctor/motion/MotionCentroids.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

using Change = std::function<glm::vec2(const glm::vec2&)>;

const glm::ivec2 kSizePx{96, 64};
constexpr float kWallM = 20.0f, kSquareM = 5.0f;

/// Squares, whose motion is `perFramePx`, in a row; the number of each is 1 more than its place.
struct Squares {
  int count = 3;
  glm::dvec2 sidePx{7.0};
  glm::dvec2 perFramePx{0.5, 0.0};
  double spreadPx = 0.0; ///< what motions of their left halves lack, and those of their right ones have more
  double cameraPx = 0.0; ///< per frame: a camera turns, by which what rests in the world moves along x
  float screenM =
      0.0f; ///< 0: none; else the distance of what hides all that is left of the centroids of squares
};

DoctorFrame squaresFrame(const Squares& squares, int frame, const Change& change) {
  DoctorFrame out;
  out.frame = frame;
  out.luma = out.depthView = Image(kSizePx.x, kSizePx.y, 1);
  out.motionPx = Image(kSizePx.x, kSizePx.y, 2);
  out.objectId.resize(out.luma.pixels.size());
  if (squares.cameraPx != 0.0) {
    out.depth = Image(kSizePx.x, kSizePx.y, 1);
    out.previousClipFromClip = glm::translate(
        glm::mat4(1.0f), glm::vec3(static_cast<float>(-2.0 * squares.cameraPx / kSizePx.x), 0.0f, 0.0f));
  }
  for (int y = 0; y < kSizePx.y; ++y)
    for (int x = 0; x < kSizePx.x; ++x) {
      *out.depthView.at(x, y) = kWallM;
      for (int i = 0; i < squares.count; ++i) {
        const glm::dvec2 corner =
            glm::dvec2(10.3 + 25.0 * i, 20.2) + static_cast<double>(frame) * squares.perFramePx;
        const glm::dvec2 at = glm::dvec2(x + 0.5, y + 0.5) - corner;
        if (at.x < 0.0 || at.y < 0.0 || at.x >= squares.sidePx.x || at.y >= squares.sidePx.y) continue;
        const bool isHidden = squares.screenM > 0.0f && at.x < 0.5 * squares.sidePx.x;
        *out.depthView.at(x, y) = isHidden ? squares.screenM : kSquareM;
        out.objectId[static_cast<std::size_t>(y) * kSizePx.x + x] =
            isHidden ? 9u : static_cast<std::uint32_t>(i + 1);
        const glm::vec2 motion = change(glm::vec2(squares.perFramePx));
        const double spreadPx = at.x < 0.5 * squares.sidePx.x ? -squares.spreadPx : squares.spreadPx;
        out.motionPx.at(x, y)[0] = motion.x + static_cast<float>(spreadPx);
        out.motionPx.at(x, y)[1] = motion.y;
      }
    }
  return out;
}

/// Of all squares over 12 frames.
MiddleEvidence centroidsOfSquares(const Squares& squares, const Change& change) {
  const std::vector<MotionTrial> trials = motionTrials(kSizePx);
  MotionCentroids centroids;
  MiddleEvidence out;
  DoctorFrame before;
  std::vector<RegionIndex> labelsBefore;
  for (int frame = 0; frame < 12; ++frame) {
    const DoctorFrame now = squaresFrame(squares, frame, change);
    std::vector<RegionIndex> labels;
    for (const std::uint32_t id : now.objectId) labels.push_back(static_cast<RegionIndex>(id));
    if (frame > 0)
      for (const auto& [region, evidence] : centroids.add({now, before}, trials, labels, labelsBefore))
        out.add(evidence);
    before = now;
    labelsBefore = labels;
  }
  return out;
}

std::string winnersOf(const MiddleEvidence& evidence) {
  const std::vector<MotionTrial> trials = motionTrials(kSizePx);
  std::string text;
  for (const std::size_t t : middleWinners(evidence)) text += (text.empty() ? "" : ",") + trialId(trials[t]);
  return text;
}

std::string winnersOf(const Squares& squares, const Change& change) {
  return winnersOf(centroidsOfSquares(squares, change));
}

glm::vec2 same(const glm::vec2& motion) {
  return motion;
}
glm::vec2 mirrored(const glm::vec2& motion) {
  return {-motion.x, motion.y};
}

} // namespace

TEST(MotionCentroids, SayNothingAgainstMotionThatIsRight) {
  EXPECT_EQ(winnersOf({}, same), "");
  const MiddleEvidence evidence = centroidsOfSquares({}, same);
  ASSERT_FALSE(evidence.trials.empty());
  for (const MiddleCounts& trial : evidence.trials) EXPECT_LE(trial.won, trial.samples / 5);
}

// Half a pixel a frame is 5.5 px after 11.
TEST(MotionCentroids, AddUpWhatIsLittleFromFrameToFrame) {
  EXPECT_EQ(winnersOf({.perFramePx = {0.5, 0.2}}, mirrored), "mirroredX");
  EXPECT_EQ(winnersOf({.perFramePx = {0.4, -0.2}}, [](const glm::vec2& m) { return -m; }), "opposite");
  EXPECT_EQ(winnersOf({.perFramePx = {0.6, 0.1}}, [](const glm::vec2& m) { return glm::vec2(m.y, m.x); }),
            "swappedAxes");
  EXPECT_EQ(winnersOf({.perFramePx = {0.6, 0.2}}, [](const glm::vec2& m) { return 2.0f * m; }),
            "scaled:0.5,twoFramesOld")
      << "of even motion both are the same";
}

// A square that rests in the world goes by half a pixel a frame as the camera turns. The motion given leads
// the other way and is too long: negated, it still misses the way by nearly 2 px of 5.5, and the camera's by
// none.
TEST(MotionCentroids, TellWhatRestsInTheWorldByTheCamera) {
  const Squares squares{.perFramePx = {0.5, 0.0}, .cameraPx = 0.5};
  EXPECT_EQ(winnersOf(squares, [](const glm::vec2& m) { return glm::vec2(-1.33f * m.x, 0.3f); }), "ofCamera");
  EXPECT_EQ(winnersOf(squares, same), "");
  EXPECT_EQ(winnersOf(squares, mirrored), "mirroredX,opposite,ofCamera") << "they lead to the same place";
}

// The front of a ball that turns on its place moves, and its middle does not: no factor is told by that.
TEST(MotionCentroids, DoNotTellWhatTurns) {
  EXPECT_EQ(winnersOf({.perFramePx = {0.0, 0.0}}, [](const glm::vec2&) { return glm::vec2(1.0f, 0.0f); }),
            "");
}

// Of a cube that the camera goes around the front goes one way and the outline, a little, the other: as if
// its motion were negated. What its pixels move by differs by as much as it moves.
TEST(MotionCentroids, DoNotTellWhatIsTurnedAround) {
  const Change turned = [](const glm::vec2&) { return glm::vec2(0.25f, 0.0f); };
  EXPECT_EQ(winnersOf({.perFramePx = {-0.2, 0.0}}, turned), "mirroredX,opposite");
  EXPECT_EQ(winnersOf({.perFramePx = {-0.2, 0.0}, .spreadPx = 0.25}, turned), "");
}

TEST(MotionCentroids, LeaveOutWhatIsNotSeenWhole) {
  EXPECT_TRUE(centroidsOfSquares({.screenM = 2.0f}, mirrored).trials.empty())
      << "something nearer is beside it";
  EXPECT_TRUE(centroidsOfSquares({.sidePx = {1.0, 20.0}}, mirrored).trials.empty()) << "thin as a pixel";
  EXPECT_TRUE(centroidsOfSquares({.sidePx = {3.0, 3.0}}, mirrored).trials.empty()) << "too small";
}

// A square that comes out from behind something at nearly its own distance: half of its way is that of its
// middle, and twice its motion is not what is wrong with it.
TEST(MotionCentroids, LeaveOutWhatComesOut) {
  const std::vector<MotionTrial> trials = motionTrials(kSizePx);
  MotionCentroids centroids;
  MiddleEvidence out;
  DoctorFrame before;
  std::vector<RegionIndex> labelsBefore;
  for (int frame = 0; frame < 12; ++frame) {
    DoctorFrame now =
        squaresFrame({.count = 1, .sidePx = {30.0, 20.0}, .perFramePx = {1.0, 0.0}}, frame, same);
    std::vector<RegionIndex> labels;
    for (std::size_t i = 0; i < now.objectId.size(); ++i) {
      const bool isCovered = static_cast<int>(i) % kSizePx.x < 24;
      labels.push_back(isCovered ? 0 : static_cast<RegionIndex>(now.objectId[i]));
      if (isCovered) now.depthView.pixels[i] = 0.99f * kSquareM;
    }
    if (frame > 0)
      for (const auto& [region, evidence] : centroids.add({now, before}, trials, labels, labelsBefore))
        if (region == 1) out.add(evidence);
    before = now;
    labelsBefore = labels;
  }
  EXPECT_FALSE(out.trials.empty()) << "its depth does not give it away";
  EXPECT_EQ(winnersOf(out), "");
}

} // namespace taa::doctor
