// What pictures refute is found, by its number where a line explains it and as unknown where nothing does; of
// painted frames with mistakes that no list has.
#include "core/doctor/flow/FlowCheck.h"

#include "core/doctor/motion/MotionWords.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

using test::idsOf;

constexpr int kFrames = 12;

/// Speeds that change, so that no factor looks like an offset.
test::PaintedShot changingShot() {
  test::PaintedShot shot;
  shot.change = 0.3;
  return shot;
}

using MotionChange = std::function<glm::vec2(const glm::vec2& motion, int frame)>;

Diagnosis diagnosisOf(const MotionChange& ground, const MotionChange& board, bool hasCamera = false) {
  Examination examination = test::paintedExamination(changingShot(), kFrames, [=](DoctorFrame& frame) {
    const int number = frame.frame;
    const auto with = [number](const MotionChange& change) {
      return [&change, number](const glm::vec2& motion) { return change(motion, number); };
    };
    if (ground)
      for (const std::uint32_t id : {0u, test::kGroundId}) test::changeMotion(frame, id, with(ground));
    if (board) test::changeMotion(frame, test::kBoardId, with(board));
    if (!hasCamera) frame.previousClipFromClip.reset();
  });
  examination.known.camera = hasCamera;
  return examine(examination);
}

bool isRight(const Diagnosis& diagnosis, const std::string& part) {
  return std::ranges::count(diagnosis.parts.right(), part, &RightPart::part) > 0;
}

} // namespace

// Of depth with matrices and of motion one is wrong: pictures say which.
TEST(FlowCheck, AsksPicturesWhichOfTwoWitnessesIsRight) {
  const auto seenWith = [](const glm::dvec2& px, std::size_t count) {
    FlowSquare square;
    square.px = px;
    square.given = {4.0, 0.0};
    square.camera = glm::dvec2(1.5, 0.0);
    return std::vector<FlowPair>{{1, std::vector<FlowSquare>(count, square), {}, {}, 0}};
  };
  const std::vector<Region> none;
  const auto asGiven = seenWith({4.1, 0.0}, 24), asCamera = seenWith({1.4, 0.0}, 24);
  EXPECT_TRUE(isMotionConfirmed({asGiven, none}));
  EXPECT_FALSE(isDepthConfirmed({asGiven, none}));
  EXPECT_TRUE(isDepthConfirmed({asCamera, none}));
  EXPECT_FALSE(isMotionConfirmed({asCamera, none}));
  const auto asNeither = seenWith({9.0, 0.0}, 24), few = seenWith({4.1, 0.0}, 23);
  EXPECT_FALSE(isMotionConfirmed({asNeither, none}) || isDepthConfirmed({asNeither, none}));
  EXPECT_FALSE(isMotionConfirmed({few, none}));
}

TEST(FlowCheck, FindsNothingInHealthyFrames) {
  const Diagnosis diagnosis = diagnosisOf({}, {}, true);
  EXPECT_EQ(idsOf(diagnosis), "");
  EXPECT_TRUE(isRight(diagnosis, "Motion"));
}

// 1 / 1.18 is on no list: what is nearest there leaves more than a tenth of the motion.
TEST(FlowCheck, MeasuresAFactorThatNoListHas) {
  const MotionChange change = [](const glm::vec2& motion, int) { return 1.18f * motion; };
  const Diagnosis diagnosis = diagnosisOf(change, change);
  ASSERT_EQ(idsOf(diagnosis), "motionScaled");
  const Finding& finding = diagnosis.findings[0];
  EXPECT_NE(finding.change.find("(0.848, 0.84"), std::string::npos) << finding.change;
  EXPECT_FALSE(isRight(diagnosis, "Motion"));
}

// Drawn with another field of view than its motion is made with: a half is on the list, and is not it.
TEST(FlowCheck, MeasuresAFactorOfOneObjectThatIsNearAKnownOne) {
  const auto foundWith = [](float factor) {
    const Diagnosis diagnosis = diagnosisOf(
        {}, [=](const glm::vec2& motion, int) { return factor * motion; }, true);
    EXPECT_EQ(diagnosis.findings.size(), 1u) << idsOf(diagnosis);
    return diagnosis.findings.empty() ? Finding() : diagnosis.findings.front();
  };
  const Finding measured = foundWith(1.0f / 2.1445f);
  EXPECT_EQ(measured.id, "motionScaled");
  EXPECT_NE(measured.change.find("(2.1"), std::string::npos) << measured.change;
  EXPECT_EQ(foundWith(0.5f).id, "motionHalved");
}

TEST(FlowCheck, SaysUnknownWhereNothingExplains) {
  // Of the place on the screen and the frame: no function of the motion is what pictures show.
  const MotionChange change = [](const glm::vec2& motion, int frame) {
    return motion + glm::vec2(6.0f * std::sin(2.0f * static_cast<float>(frame)),
                              5.0f * std::cos(3.1f * static_cast<float>(frame)));
  };
  const Diagnosis diagnosis = diagnosisOf(change, change);
  ASSERT_EQ(idsOf(diagnosis), std::string(kUnknownMotionId));
  const Finding& finding = diagnosis.findings[0];
  EXPECT_NE(finding.reason.find("all frames"), std::string::npos) << finding.reason;
  ASSERT_FALSE(finding.residuals.empty());
  EXPECT_LT(2.0 * finding.residuals.front().value, finding.residuals.back().value);
  EXPECT_FALSE(isRight(diagnosis, "Motion"));
  EXPECT_FALSE(diagnosis.isHealthy());
}

// The mean over all frames hides what is wrong in every third one.
TEST(FlowCheck, NamesTheFramesInWhichOneObjectIsWrong) {
  const Diagnosis diagnosis = diagnosisOf(
      {},
      [](const glm::vec2& motion, int frame) {
        return frame % 3 == 0 ? motion + glm::vec2(-5.0f, 4.0f) : motion;
      },
      true);
  ASSERT_EQ(idsOf(diagnosis), std::string(kUnknownMotionId));
  const Finding& finding = diagnosis.findings[0];
  ASSERT_EQ(finding.regions.size(), 1u);
  EXPECT_EQ(finding.regions[0].objectId, test::kBoardId);
  EXPECT_NE(finding.reason.find("frames 3, 6, 9 (3 of 11)"), std::string::npos) << finding.reason;
}

TEST(FlowCheck, NamesMotionThatIsMissingWithoutCameras) {
  const auto zero = [](const glm::vec2&, int) { return glm::vec2(0.0f); };
  EXPECT_EQ(idsOf(diagnosisOf(zero, {})), "motionWithoutCamera") << "what moves by itself has it";
}

// The way to the frame after the missing one is that of two, and motion says that of one.
TEST(FlowCheck, NamesTheFrameBeforeWhichOneIsMissing) {
  Examination examination =
      test::paintedExamination({}, kFrames, [](DoctorFrame& frame) { frame.previousClipFromClip.reset(); });
  examination.known.camera = false;
  examination.read = [read = examination.read](int frame) {
    DoctorFrame out = read(frame < 7 ? frame : frame + 1);
    out.frame = frame;
    return out;
  };
  const Diagnosis diagnosis = examine(examination);
  ASSERT_EQ(idsOf(diagnosis), "frameMissing");
  EXPECT_EQ(diagnosis.findings[0].name, "A frame missing before frame 7");
}

// The ground goes left, which is what numbers without a sign lose of its motion; the board goes right.
TEST(FlowCheck, NamesNegativeMotionThatIsLost) {
  test::PaintedShot shot;
  shot.cameraPx = {-3.25, 2.5};
  shot.boardPx = {8.0, 1.5};
  Examination examination = test::paintedExamination(shot, kFrames, [](DoctorFrame& frame) {
    for (const std::uint32_t id : {0u, test::kGroundId, test::kBoardId})
      test::changeMotion(frame, id,
                         [](const glm::vec2& motion) { return glm::max(motion, glm::vec2(0.0f)); });
    frame.previousClipFromClip.reset();
  });
  examination.known.camera = false;
  const Diagnosis diagnosis = examine(examination);
  EXPECT_NE(idsOf(diagnosis).find("motionClipped"), std::string::npos) << idsOf(diagnosis);
}

// Longer in some frames than in others, so that no factor makes it of what is given.
TEST(FlowCheck, NamesTheLengthAtWhichMotionEnds) {
  test::PaintedShot shot;
  shot.cameraPx = {0.5, 0.2};
  shot.boardPx = {0.3, -2.0};
  shot.boardChange = 0.35;
  const auto limited = [&](float limitPx) {
    return examine(test::paintedExamination(shot, kFrames, [=](DoctorFrame& frame) {
      test::changeMotion(frame, test::kBoardId, [=](const glm::vec2& motion) {
        return motion * std::min(1.0f, limitPx / glm::length(motion));
      });
    }));
  };
  EXPECT_EQ(idsOf(limited(100.0f)), "");
  const Diagnosis diagnosis = limited(2.0f);
  SCOPED_TRACE(idsOf(diagnosis));
  const auto found = std::ranges::find(diagnosis.findings, "motionLimited", &Finding::id);
  ASSERT_NE(found, diagnosis.findings.end());
  EXPECT_NE(found->reason.find("longer than 2 px"), std::string::npos) << found->reason;
}

// The matrices that are stated are those of the frame that is missing, so that motion is the camera's.
TEST(FlowCheck, NamesAMissingFrameWhateverMatricesSay) {
  Examination examination = test::paintedExamination({}, kFrames);
  examination.read = [read = examination.read](int frame) {
    DoctorFrame out = read(frame < 7 ? frame : frame + 1);
    out.frame = frame;
    return out;
  };
  EXPECT_EQ(idsOf(examine(examination)), "frameMissing");
}

// What is right in all other frames explains none of what is wrong in one.
TEST(FlowCheck, ExplainsNothingByWhatIsRightElsewhere) {
  const MotionChange change = [](const glm::vec2& motion, int frame) {
    return frame == 6 ? motion + glm::vec2(7.0f, -5.0f) : motion;
  };
  const Diagnosis diagnosis = diagnosisOf(change, change);
  for (const Finding& finding : diagnosis.findings) EXPECT_NE(finding.id, "motionScaled") << finding.reason;
  EXPECT_FALSE(diagnosis.isHealthy());
}

// Unreal 4's formula without its root: v/2 · |v| is read where v is stored.
TEST(FlowCheck, NamesARootThatIsNotInWhatIsStored) {
  const glm::vec2 pxPerNdc = 0.5f * glm::vec2(test::kPaintedPx);
  const MotionChange change = [pxPerNdc](const glm::vec2& motion, int) {
    const glm::vec2 ndc = motion / pxPerNdc;
    return 0.5f * ndc * glm::abs(ndc) * pxPerNdc;
  };
  test::PaintedShot shot = changingShot();
  shot.cameraPx = {6.0, -4.0};
  shot.change = 0.8;
  Examination examination = test::paintedExamination(shot, kFrames, [&](DoctorFrame& frame) {
    for (const std::uint32_t id : {0u, test::kGroundId, test::kBoardId})
      test::changeMotion(frame, id, [&](const glm::vec2& motion) { return change(motion, 0); });
    frame.previousClipFromClip.reset();
  });
  examination.known.camera = false;
  examination.captureInfo.conventions.emplace().motion.encoding = capture::MotionEncoding::Unreal;
  const Diagnosis diagnosis = examine(examination);
  ASSERT_EQ(idsOf(diagnosis), "motionWithoutRoot");
  EXPECT_NE(diagnosis.findings[0].change.find("times 4.008 in device coordinates"), std::string::npos)
      << diagnosis.findings[0].change;
}

// A negated x and a curve make the same of motion that has one length, to less than a tolerance.
TEST(FlowCheck, NamesNoRootWhereAKnownMistakeExplainsAll) {
  const std::vector<Region> regions(1);
  const auto pairsWith = [](double sign) {
    std::vector<FlowPair> pairs(6);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      pairs[i].frame = static_cast<int>(i) + 1;
      pairs[i].said[0] = 1.0;
      for (int square = 0; square < 36; ++square) {
        FlowSquare& one = pairs[i].squares.emplace_back();
        one.region = 0;
        one.given = {sign * (2.8 + 0.002 * square), 0.0};
        one.px = {sign * one.given.x, 0.0};
        if (square == 0) { // by chance only a curve explains it
          one.px.x *= 0.6;
          one.given.x *= 0.36;
        }
        one.errorPx = 0.02;
        one.left = 0.004;
        one.leftAsGiven = one.apart = sign < 0.0 ? 0.03 : 0.004;
      }
    }
    return pairs;
  };
  const std::vector<FlowPair> given = pairsWith(-1.0), corrected = pairsWith(1.0);
  CaptureInfo captureInfo;
  captureInfo.sizePx = {240, 136};
  captureInfo.conventions.emplace().motion.encoding = capture::MotionEncoding::Unreal;
  const auto toldOf = [&](const std::vector<FlowPair>& looked, bool isCorrected) {
    Diagnosis out;
    out.sizePx = captureInfo.sizePx;
    if (isCorrected) {
      Finding& told = out.findings.emplace_back();
      told.id = "motionNegatedX";
      told.isWholePicture = true;
      told.confidence = Confidence::Sure;
    }
    tellFlow({given, regions}, {looked, regions}, {captureInfo, isCorrected}, out);
    return idsOf(out);
  };
  EXPECT_EQ(toldOf(given, false), "motionWithoutRoot") << "the curve does explain it";
  EXPECT_EQ(toldOf(corrected, true), "motionNegatedX");
}

} // namespace taa::doctor
