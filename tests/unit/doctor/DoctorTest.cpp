// The doctor on painted frames: nothing where nothing is wrong, and each fault by its name, in its region.
#include "core/doctor/examination/Doctor.h"

#include "core/base/Error.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace taa::doctor {
namespace {

using test::changeMotion;
using test::kBoardId;
using test::kGroundId;
using test::paintedExamination;
using test::PaintedShot;

constexpr int kFrames = 8;
constexpr std::uint32_t kSky = 0;

Diagnosis diagnosisOf(const PaintedShot& shot, const test::FrameFault& fault = {}) {
  return examine(paintedExamination(shot, kFrames, fault));
}

/// "motionNegatedY in object 2 (board)", by commas; "" where nothing was found.
std::string told(const Diagnosis& diagnosis) {
  std::string text;
  for (const Finding& finding : diagnosis.findings) {
    text += (text.empty() ? "" : ", ") + finding.id + " in ";
    if (finding.isWholePicture)
      text += "all";
    else
      for (const RegionPlace& region : finding.regions) text += region.name;
  }
  return text;
}

test::FrameFault onObject(std::uint32_t id, const std::function<glm::vec2(const glm::vec2&)>& change) {
  return [id, change](DoctorFrame& frame) { changeMotion(frame, id, change); };
}

/// Of ground and board; the sky has no detail.
test::FrameFault onAll(const std::function<glm::vec2(const glm::vec2&)>& change) {
  return [change](DoctorFrame& frame) {
    for (const std::uint32_t id : {kSky, kGroundId, kBoardId}) changeMotion(frame, id, change);
  };
}

} // namespace

TEST(Doctor, FindsNothingWhereNothingIsWrong) {
  for (const bool isJittered : {false, true})
    for (const glm::dvec2& camera : {glm::dvec2(0.0), glm::dvec2(2.25, -1.5), glm::dvec2(-5.0, 0.5)}) {
      PaintedShot shot;
      shot.isJittered = isJittered;
      shot.cameraPx = camera;
      const Diagnosis diagnosis = diagnosisOf(shot);
      EXPECT_EQ(told(diagnosis), "");
      EXPECT_EQ(diagnosis.frames, kFrames);
      EXPECT_EQ(diagnosis.pairs, kFrames - 1);
    }
}

TEST(Doctor, TellsWhatTheFirstFramesShowBeforeItHasSeenAll) {
  const PaintedShot shot;
  Examination examination =
      paintedExamination(shot, 12, onAll([](const glm::vec2& m) { return glm::vec2(m.x, -m.y); }));
  std::vector<Diagnosis> early;
  const Diagnosis diagnosis = examine(examination, {}, [&](const Diagnosis& seen) { early.push_back(seen); });
  ASSERT_EQ(early.size(), 1u);
  EXPECT_EQ(early[0].frames, kFirstLook);
  EXPECT_EQ(told(early[0]), "motionNegatedY in all");
  EXPECT_EQ(told(diagnosis), "motionNegatedY in all");
  EXPECT_EQ(diagnosis.frames, 12);
  examination.frames = kFirstLook;
  examine(examination, {}, [&](const Diagnosis& seen) { early.push_back(seen); });
  EXPECT_EQ(early.size(), 1u) << "what is returned says it all";
}

TEST(Doctor, BeginsAtTheFirstFrameThatIsAskedFor) {
  const PaintedShot shot;
  Examination examination = paintedExamination(shot, 16, [](DoctorFrame& frame) {
    if (frame.frame < 6) changeMotion(frame, kBoardId, [](const glm::vec2& m) { return -m; });
  });
  examination.first = 6;
  examination.frames = 8;
  const FrameReader read = examination.read;
  int last = 0;
  examination.read = [&](int frame) {
    EXPECT_GE(frame, 6);
    last = std::max(last, frame);
    return read(frame);
  };
  EXPECT_EQ(told(examine(examination)), "");
  EXPECT_EQ(last, 13);
}

TEST(Doctor, NamesAFaultOfTheWholePicture) {
  const PaintedShot shot;
  EXPECT_EQ(told(diagnosisOf(shot, onAll([](const glm::vec2& m) { return glm::vec2(m.x, -m.y); }))),
            "motionNegatedY in all");
  EXPECT_EQ(told(diagnosisOf(shot, onAll([](const glm::vec2& m) { return glm::vec2(-m.x, m.y); }))),
            "motionNegatedX in all");
  EXPECT_EQ(told(diagnosisOf(shot, onAll([](const glm::vec2& m) { return -m; }))), "motionNegated in all");
  EXPECT_EQ(told(diagnosisOf(shot, onAll([](const glm::vec2& m) { return glm::vec2(m.y, m.x); }))),
            "motionSwapped in all");
  EXPECT_EQ(told(diagnosisOf(shot, onAll([](const glm::vec2& m) { return 2.0f * m; }))),
            "motionDoubled in all");
  EXPECT_EQ(told(diagnosisOf(shot, onAll([](const glm::vec2& m) { return 0.5f * m; }))),
            "motionHalved in all");
}

// Motion that is next to none looks like one without the camera's, and without cameras like other jitter.
TEST(Doctor, NamesMotionOfAnotherUnitThatIsShorterThanAPixel) {
  const PaintedShot shot;
  const glm::vec2 size(test::kPaintedPx);
  const auto withoutCamera = [](const test::FrameFault& fault) {
    return [fault](DoctorFrame& frame) {
      fault(frame);
      frame.previousClipFromClip.reset();
      frame.objectId.clear();
    };
  };
  const auto uv = onAll([size](const glm::vec2& m) { return m / size; });
  const auto ndc = onAll([size](const glm::vec2& m) { return glm::vec2(2.0f, -2.0f) * m / size; });
  const auto opposite = onAll([size](const glm::vec2& m) { return -m / size; });
  EXPECT_EQ(told(diagnosisOf(shot, uv)), "motionInUv in all");
  EXPECT_EQ(told(diagnosisOf(shot, ndc)), "motionInNdc in all");
  EXPECT_EQ(told(diagnosisOf(shot, opposite)), "motionInUv in all, motionNegated in all");
  EXPECT_EQ(told(diagnosisOf(shot, withoutCamera(uv))), "motionInUv in all");
  EXPECT_EQ(told(diagnosisOf(shot, withoutCamera(ndc))), "motionInNdc in all");
  const Diagnosis diagnosis = diagnosisOf(shot, uv);
  EXPECT_EQ(diagnosis.findings[0].correction, std::vector<std::string>{"fault.motionUnit=asUv"});
  for (const char* text : {" ± ", "160 and 96: texture coordinates"})
    EXPECT_NE(diagnosis.findings[0].reason.find(text), std::string::npos) << diagnosis.findings[0].reason;
}

TEST(Doctor, NamesAFaultOfOneObjectAlone) {
  const PaintedShot shot;
  EXPECT_EQ(
      told(diagnosisOf(shot, onObject(kBoardId, [](const glm::vec2& m) { return glm::vec2(m.x, -m.y); }))),
      "motionNegatedY in object 2 (board)");
  EXPECT_EQ(told(diagnosisOf(shot, onObject(kGroundId, [](const glm::vec2& m) { return 2.0f * m; }))),
            "motionDoubled in object 1 (ground)");
}

// Where nothing moves up or down, nobody can tell whether y is negated too.
TEST(Doctor, SaysWhatLeadsToTheSamePlaces) {
  PaintedShot shot;
  shot.cameraPx = {3.0, 0.0};
  shot.boardPx = {1.5, 0.0};
  const Diagnosis diagnosis = diagnosisOf(shot, onAll([](const glm::vec2& m) { return -m; }));
  ASSERT_EQ(diagnosis.findings.size(), 1u) << told(diagnosis);
  EXPECT_EQ(diagnosis.findings[0].confidence, Confidence::Likely);
  EXPECT_NE(diagnosis.findings[0].reason.find("leads to the same places as: "), std::string::npos)
      << diagnosis.findings[0].reason;
}

// A sequence that is neither what is drawn nor any simple form of it.
// Motion that is more than jitter can be off is found nevertheless, by what pictures move by.
TEST(Doctor, SaysOfMotionWhatNoJitterExplainsWhereJitterIsContradicted) {
  const auto fault = [](DoctorFrame& frame) {
    const auto angle = static_cast<float>(frame.frame);
    frame.jitterPx = 0.45f * glm::vec2(std::sin(2.4f * angle), std::cos(5.1f * angle));
    changeMotion(frame, kBoardId, [](const glm::vec2& m) { return 2.0f * m; });
  };
  const Diagnosis diagnosis = diagnosisOf({}, fault);
  EXPECT_EQ(told(diagnosis), "motionUnknown in object 2 (board)");
  std::string questions;
  for (const Undecided& undecided : diagnosis.parts.undecided()) questions += undecided.question + ";";
  EXPECT_TRUE(questions.starts_with("Jitter;")) << questions;
  EXPECT_NE(questions.find("Motion;"), std::string::npos) << questions;
}

TEST(Doctor, FindsWhatAnObjectMovesByWhereNothingWasWritten) {
  const PaintedShot shot;
  EXPECT_EQ(told(diagnosisOf(shot, onObject(kBoardId, [](const glm::vec2&) { return glm::vec2(0.0f); }))),
            "motionZero in object 2 (board)");
  const glm::vec2 camera(shot.cameraPx);
  EXPECT_EQ(told(diagnosisOf(shot, onObject(kBoardId, [camera](const glm::vec2&) { return camera; }))),
            "motionCameraOnly in object 2 (board)");
  EXPECT_EQ(told(diagnosisOf(shot, onObject(kGroundId, [](const glm::vec2&) { return glm::vec2(0.0f); }))),
            "motionZero in object 1 (ground)");
}

TEST(Doctor, NamesASkyWithoutMotionThoughItHasNoDetail) {
  const PaintedShot shot;
  const auto fault = onObject(kSky, [](const glm::vec2&) { return glm::vec2(0.0f); });
  const Diagnosis turning = diagnosisOf(shot, fault);
  EXPECT_EQ(told(turning), "skyWithoutMotion in the sky");
  ASSERT_EQ(turning.findings.size(), 1u);
  EXPECT_EQ(turning.findings[0].confidence, Confidence::Sure);
  PaintedShot still;
  still.cameraPx = glm::dvec2(0.0);
  EXPECT_EQ(told(diagnosisOf(still, fault)), "");
}

TEST(Doctor, NamesJitterThatIsLeftInMotion) {
  const PaintedShot shot;
  const auto jittered = [](float ofThis, float ofPrevious) {
    return [ofThis, ofPrevious](DoctorFrame& frame) {
      if (frame.frame == 0) return;
      const glm::vec2 previous = test::paintedFrame({}, frame.frame - 1).jitterPx;
      const glm::vec2 left = ofThis * frame.jitterPx - ofPrevious * previous;
      for (const std::uint32_t id : {kSky, kGroundId, kBoardId})
        changeMotion(frame, id, [left](const glm::vec2& m) { return m + left; });
    };
  };
  EXPECT_EQ(told(diagnosisOf(shot, jittered(1.0f, 0.0f))), "motionJitterThis in all");
  EXPECT_EQ(told(diagnosisOf(shot, jittered(0.0f, 1.0f))), "motionJitterLast in all");
  EXPECT_EQ(told(diagnosisOf(shot, jittered(1.0f, 1.0f))), "motionJitterBoth in all");
}

TEST(Doctor, NamesMotionOfTheFrameBeforeWhereSpeedsChange) {
  PaintedShot shot;
  shot.change = 0.75;
  const Diagnosis late = diagnosisOf(shot, [shot](DoctorFrame& frame) {
    if (frame.frame > 0) frame.motionPx = test::paintedFrame(shot, frame.frame - 1).motionPx;
  });
  EXPECT_EQ(told(late), "motionLingers in all");
  // At even speed it is the same motion but at the silhouettes of what moves, which were elsewhere.
  const Diagnosis even = diagnosisOf({}, [](DoctorFrame& frame) {
    if (frame.frame > 0) frame.motionPx = test::paintedFrame({}, frame.frame - 1).motionPx;
  });
  EXPECT_EQ(told(even), "motionLingers in object 2 (board)");
}

TEST(Doctor, SaysWhatItCannotDecideAndWhatToCaptureInstead) {
  PaintedShot shot;
  shot.isBoardTextured = false;
  shot.boardPx = {0.5, 0.5}; // no more than an outline's pixels are wide
  const Diagnosis diagnosis = diagnosisOf(
      shot, onObject(kBoardId, [](const glm::vec2& motion) { return motion + glm::vec2(0.5f, 0.0f); }));
  EXPECT_EQ(told(diagnosis), "");
  bool isSaid = false;
  for (const Undecided& undecided : diagnosis.parts.undecided())
    isSaid = isSaid || (undecided.question == "Motion of object 2 (board)" &&
                        undecided.reason.find("too little detail") != std::string::npos &&
                        undecided.capture.find("texture") != std::string::npos);
  EXPECT_TRUE(isSaid);
}

TEST(Doctor, GoesByOutlinesWhereThereIsTooLittleDetail) {
  PaintedShot shot;
  shot.isBoardTextured = false;
  shot.cameraPx = {0.0, 0.0};
  shot.boardPx = {3.0, 2.0};
  const auto found = [&](const std::function<glm::vec2(const glm::vec2&)>& change) {
    return diagnosisOf(shot, onObject(kBoardId, change));
  };
  EXPECT_EQ(told(diagnosisOf(shot)), "");
  const Diagnosis zero = found([](const glm::vec2&) { return glm::vec2(0.0f); });
  EXPECT_EQ(told(zero), "motionZero in object 2 (board)");
  EXPECT_NE(zero.findings.at(0).reason.find("outline"), std::string::npos) << zero.findings[0].reason;
  EXPECT_NE(zero.findings[0].measure.find("outline"), std::string::npos);
  EXPECT_EQ(told(found([](const glm::vec2& m) { return glm::vec2(m.x, -m.y); })),
            "motionNegatedY in object 2 (board)");
  EXPECT_EQ(told(found([](const glm::vec2& m) { return 2.0f * m; })), "motionDoubled in object 2 (board)");
  EXPECT_EQ(told(found([](const glm::vec2& m) { return m / glm::vec2(160.0f, 96.0f); })),
            "motionInUv in object 2 (board)");
}

// Outlines are those of depth and object numbers: where these have another jitter than is stated, all of them
// shift.
TEST(Doctor, TakesNoJitterOfDepthForMotionOfOutlines) {
  PaintedShot shot;
  shot.isBoardTextured = false;
  for (const glm::dvec2& board : {glm::dvec2(0.0), glm::dvec2(2.0, 1.0)}) {
    shot.boardPx = board;
    const Diagnosis diagnosis =
        diagnosisOf(shot, [](DoctorFrame& frame) { frame.depthJitterPx = -frame.depthJitterPx; });
    for (const Finding& finding : diagnosis.findings)
      EXPECT_FALSE(finding.id.starts_with("motion")) << finding.id;
  }
}

TEST(Doctor, NamesDepthThatIsTheOtherWayAroundByWhatHidesWhat) {
  PaintedShot shot;
  shot.cameraPx = {0.0, 0.0};
  EXPECT_EQ(told(diagnosisOf(shot,
                             [](DoctorFrame& frame) {
                               for (float& depth : frame.depth.pixels) depth = 1.0f - depth;
                             })),
            "depthReversed in all");
}

TEST(Doctor, SaysWhatToChangeInTheEnginesOwnConvention) {
  Examination examination = paintedExamination({}, kFrames, onAll([](const glm::vec2& m) { return -m; }));
  examination.captureInfo.conventions = capture::startingPoint("three").conventions; // NDC, y up
  const Diagnosis diagnosis = examine(examination);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  // The board moves most, by (3.75, 1.5) px: (7.5/160, −3/96) in device coordinates, y up.
  EXPECT_NE(
      diagnosis.findings[0].change.find("you write (-0.0469, 0.0313); the pictures show (0.0469, -0.0313)"),
      std::string::npos)
      << diagnosis.findings[0].change;
}

TEST(Doctor, LeavesItWhereItIsCancelled) {
  int reported = 0;
  const Progress progress = [&reported](std::string_view, int, int) { return ++reported < 3; };
  EXPECT_THROW(examine(paintedExamination({}, kFrames), progress), Cancelled);
  EXPECT_EQ(reported, 3);
}

} // namespace taa::doctor
