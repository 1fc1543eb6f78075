// Lessons that say what is not true, and states whose numbers follow from the formulas.
#include "core/lessons/LessonCheck.h"
#include "core/capture/source/Capture.h"
#include "core/inspect/Inspector.h"
#include "core/lessons/LessonNumbers.h"
#include "core/lessons/RecordedFrames.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using taa::LessonFinding;

namespace {

class LessonCheck : public taa::test::GlTest {};

/// A lesson of one step with this header.
std::vector<LessonFinding> checked(const std::string& header) {
  taa::Inspector inspector;
  return taa::checkLesson(
      inspector,
      taa::lessonFromText("# L\n\n## S\n\n```state\nscene: builtin:lights\nsize: 64x36\n" + header + "```\n",
                          "l.md"));
}

std::vector<std::string> mistakes(const std::string& header) {
  return taa::mistakesOf(checked(header));
}

} // namespace

TEST_F(LessonCheck, MeasuresWhatTheFormulaOfTheMeanGives) {
  // α of the exact mean after n frames is 1/(n + 1), N is n + 1 (manual 13.2).
  EXPECT_EQ(
      mistakes("preset: reference\ncamera: still\nframe: 7\nclaim: probe 32,18 alpha = 0.125 within 1e-6\n"
               "claim: probe 32,18 historyLength = 8 within 1e-4\n"
               "claim: probe 32,18 alpha at 3 = 0.25 within 1e-6\n"),
      std::vector<std::string>{});
}

TEST_F(LessonCheck, NamesAClaimThatDoesNotHoldWithItsLineAndNumbers) {
  const auto found = mistakes("frame: 1\npreset: off\nclaim: metric meanAlpha < 0.5\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front(), "l.md:10: the claim does not hold: metric meanAlpha < 0.5, measured 1 and 0.5");
}

TEST_F(LessonCheck, RefusesATaskThatIsSolvedAtTheStart) {
  const auto found = mistakes("frame: 1\npreset: off\ntask: metric meanAlpha > 0.5\nsolution: preset off\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front(), "l.md:10: the task is solved at the start");
}

TEST_F(LessonCheck, RefusesASolutionThatSolvesNothing) {
  const auto found =
      mistakes("frame: 1\npreset: minimal\ntask: metric meanAlpha = 1\nsolution: set weight.alpha=0.5\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found.front().find("the solution does not solve the task"), std::string::npos) << found.front();
}

TEST_F(LessonCheck, ComparesLanesOnTheSameFrame) {
  EXPECT_EQ(mistakes("frame: 2\npreset: minimal\nlane: off = off\nlane: same = this\n"
                     "claim: metric meanAlpha of off > metric meanAlpha * 2\n"
                     "claim: difference 20,20 resolved of same = 0\n"),
            std::vector<std::string>{});
}

TEST_F(LessonCheck, SaysOfAFrameThatIsNotThere) {
  const auto found = mistakes("frame: 90000\nclaim: metric meanAlpha > 0\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found.front().find("there is no frame 90000"), std::string::npos) << found.front();
}

TEST_F(LessonCheck, FollowsTheSamplesOfAPixelAtRest) {
  // The mean of n + 1 frames read in place is worth as many samples, and none of it is blurred.
  EXPECT_EQ(
      mistakes("preset: reference\ncamera: still\nframe: 7\n"
               "claim: lineage 32,18 frames = 8 within 1e-3\n"
               "claim: lineage 32,18 samples = 8 within 1e-3\n"
               "claim: lineage 32,18 spread = 0 within 1e-6\nclaim: lineage 32,18 older = 0 within 1e-6\n"),
      std::vector<std::string>{});
}

TEST_F(LessonCheck, MeasuresABoxInRgbWhateverItsAxes) {
  // YCoCg and its lifting differ in the lengths of their axes alone: the same box.
  EXPECT_EQ(mistakes("preset: minimal\nset: space.color=yCoCg\nframe: 1\n"
                     "lane: lifting = this space.color=yCoCgLifting\n"
                     "claim: volume 32,18 = volume 32,18 of lifting within 1e-9\nclaim: volume 32,18 > 0\n"),
            std::vector<std::string>{});
}

TEST_F(LessonCheck, PushingLeavesHolesWhereTheCameraComesNearer) {
  EXPECT_EQ(mistakes("camera: still\nframe: 2\nclaim: pushed none = 0\nclaim: pushed several = 0\n"),
            std::vector<std::string>{});
  // What turns by more than a pixel a frame uncovers a column at the border.
  EXPECT_EQ(mistakes("camera: orbit\nframe: 2\nclaim: pushed none > 1\nclaim: pushed several > 0.1\n"),
            std::vector<std::string>{});
}

TEST_F(LessonCheck, CountsTheLevelsThatEightBitsTellApart) {
  // All pixels of a mean at rest have the same α.
  EXPECT_EQ(mistakes("preset: reference\ncamera: still\nframe: 2\nclaim: levels alpha = 1\n"),
            std::vector<std::string>{});
  // A single step through the fog is in a beam or is not; the integral follows how long a ray is in the beam.
  EXPECT_EQ(mistakes("scene: builtin:fog\nframe: 0\nset: inputs.fogNoise=none inputs.fogSteps=1\n"
                     "lane: integral = this inputs.fogSteps=0\n"
                     "claim: levels fogOpacity = 2\nclaim: levels fogOpacity of integral > 20\n"),
            std::vector<std::string>{});
}

TEST_F(LessonCheck, ACameraThatIsPosedStopsWhereItIsSaid) {
  EXPECT_EQ(mistakes("pose: 0 0,1.5,6 0,0\npose: 4 0.5,1.5,6 0,0\nframe: 6\n"
                     "claim: probe 32,18 motion at 3 > 0.01\nclaim: probe 32,18 motion = 0 within 1e-4\n"),
            std::vector<std::string>{});
}

TEST_F(LessonCheck, OpensFramesThatItRecordsAndTheDoctorFindsWhatIsWrongInThem) {
  EXPECT_EQ(mistakes("camera: pan\nrecord: 6 like=unreal fault=motionNegated reference=4\n"
                     "preset: unrectified\nframe: 5\n"
                     "lane: healed = this fault.motionX=-1 fault.motionY=-1\n"
                     "claim: metric rmse of healed < metric rmse\n"),
            std::vector<std::string>{});
}

TEST_F(LessonCheck, FramesThatItRecordsDoNotSayWhatIsWrongInThem) {
  taa::Inspector inspector;
  const taa::Lesson lesson =
      taa::lessonFromText("# L\n\n## S\n\n```state\nscene: builtin:lights\nsize: 64x36\n"
                          "record: 2 like=unreal fault=depthReversed\n```\n",
                          "l.md");
  const taa::LessonState opened = taa::onItsFrames(inspector, lesson.steps.front().state, {});
  EXPECT_EQ(taa::capture::openCapture(opened.shot.source)->manifest().notes, std::vector<std::string>{});
  inspector.shot().open(opened.shot.source, {}, {});
  EXPECT_EQ(inspector.shot().scene().warnings, std::vector<std::string>{});
}

TEST_F(LessonCheck, RungsAreMeasuredEachHoweverManyThereAre) {
  // What they measure is said by the mistakes, and then holds; nothing else does.
  std::string wrong;
  for (const char* preset : {"off", "minimal", "reference", "source000-2", "source000-3", "sharp"})
    wrong += std::string("rung: ") + preset + " psnr=99 flicker=0.5\n";
  const std::vector<std::string> found = mistakes("frame: 4\n" + wrong);
  ASSERT_EQ(found.size(), 6u);
  std::string right;
  for (const std::string& mistake : found) {
    ASSERT_NE(mistake.find("the rung does not hold; measured: rung: "), std::string::npos) << mistake;
    right += mistake.substr(mistake.find("rung: ")) + "\n";
  }
  EXPECT_EQ(mistakes("frame: 4\n" + right), std::vector<std::string>{});
  EXPECT_NE(found[0].substr(found[0].find("psnr")), found[1].substr(found[1].find("psnr")));
}

// The numbers of the first frame follow from the formulas: without history α is 1 for all settings, a mean of
// n frames has α = 1/n.
TEST_F(LessonCheck, MeasuresEachNumberOnceForAllLanes) {
  taa::Inspector inspector;
  const taa::Lesson lesson = taa::lessonFromText(
      "# L\n\n## S\n\n```state\nscene: builtin:lights\ncamera: still\nsize: 64x36\npreset: reference\nframe: "
      "7\n"
      "lane: half = this weight.alpha=0.5\nlane: off = off\n"
      "claim: metric meanAlpha < metric meanAlpha of off * 0.5\nclaim: metric meanAlpha of half > 0.1\n"
      "claim: probe 32,18 historyLength at 3 = 4 within 1e-4\nclaim: not verdict 32,18 ghost\n```\n",
      "l.md");
  const taa::LessonStep& step = lesson.steps.front();
  const auto numbers = taa::measureNumbers(inspector, step.state, step.claims);
  ASSERT_EQ(numbers.size(), 2u) << "a verdict is no number";
  EXPECT_EQ(numbers[0].label, "Mean α");
  ASSERT_EQ(numbers[0].values.size(), 3u);
  EXPECT_NEAR(numbers[0].values[0], 0.125, 1e-6);
  EXPECT_EQ(numbers[0].values[2], 1.0);
  EXPECT_EQ(numbers[1].label, "History length at 32, 18, frames, in frame 3");
  EXPECT_NEAR(numbers[1].values[0], 4.0, 1e-4);
}
