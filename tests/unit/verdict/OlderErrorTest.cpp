// Errors that are older than the frames that are followed, of frames made by hand, and what is concluded of
// them.
#include "core/verdict/pixel/OlderError.h"

#include "core/verdict/pixel/PixelVerdict.h"
#include "core/verdict/pixel/VerdictText.h"
#include "tests/support/verdicts/JudgedPixel.h"
#include "tests/support/verdicts/MadeEvidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

using taa::ErrorPart;
using taa::PixelError;
using taa::Settings;
using taa::Stage;
using taa::VerdictEvidence;
using taa::VerdictKind;
using namespace taa::test;

namespace {

constexpr glm::ivec2 kPixel{2, 1};
constexpr int kFrames = taa::kFollowedFrames;

/// As a lane with α = 0.05 makes it.
MadeEvidence::Frame slow(MadeEvidence::Frame frame) {
  for (MadeEvidence::Pixel& pixel : frame.pixels) pixel.alpha = glm::dvec3(0.05);
  return frame;
}

/// Begins bright; from frame `changed` on it is `after`, which stays as it is then.
void changeAt(int changed, int last, const MadeEvidence::Frame& after, MadeEvidence& evidence) {
  MadeEvidence::Frame first = stillFrame(0.9);
  first.starts = true;
  evidence.add(0, first);
  for (int frame = 1; frame <= last; ++frame)
    evidence.add(frame, slow(frame < changed ? stillFrame(0.9) : frame == changed ? after : stillFrame(0.1)));
}

PixelError errorIn(MadeEvidence& evidence, int frame) {
  taa::LineageOptions options;
  options.frames = kFrames;
  return pixelError(evidence, frame, kPixel, options);
}

/// Nine tenths of today's color are older than the frames that are followed, and off.
VerdictEvidence offForLong() {
  VerdictEvidence evidence = healthy();
  of(evidence.error.sum, ErrorPart::Older) = glm::dvec3(0.18);
  evidence.error.resolved += 0.18;
  for (taa::SurfaceMoment& moment : evidence.moments) moment.resolved += 0.18;
  evidence.error.frames.back().weight = 0.9;
  return evidence;
}

/// The same, and what it was of: an error of frame 24 that came in with frame 20.
VerdictEvidence offSince20(ErrorPart part) {
  VerdictEvidence evidence = offForLong();
  taa::PixelError older;
  older.frame = 24;
  older.resolved = glm::dvec3(0.9);
  older.reference = glm::dvec3(0.5);
  for (int age = 0; age < taa::kVerdictFrames; ++age) {
    taa::ErrorOfFrame entry;
    entry.frame = 24 - age;
    older.frames.push_back(entry);
  }
  of(older.frames[4].split, part) = of(older.sum, part) = glm::dvec3(0.4);
  evidence.older = older;
  return evidence;
}

} // namespace

TEST(OlderError, MainPartIsTheOneThatPointsTheErrorsWay) {
  PixelError error;
  error.resolved = glm::dvec3(0.5, 0.0, 0.0);
  of(error.sum, ErrorPart::Ghost) = {-0.1, 0.9, 0.0};
  of(error.sum, ErrorPart::Blur) = {0.6, -0.9, 0.0};
  EXPECT_EQ(mainPart(error).part, ErrorPart::Blur);
  EXPECT_NEAR(mainPart(error).share, 1.2, 1e-12);
}

TEST(OlderError, IsOfTheFrameInWhichTheLightChanged) {
  const int changed = 5, last = changed + 40;
  MadeEvidence evidence;
  changeAt(changed, last, stillFrame(0.1), evidence);
  const PixelError error = errorIn(evidence, last);
  ASSERT_EQ(mainPart(error).part, ErrorPart::Older);
  const std::optional<PixelError> older = olderError(evidence, error);
  ASSERT_TRUE(older);
  EXPECT_EQ(mainPart(*older).part, ErrorPart::Lag);
  EXPECT_EQ(older->frame, last - 2 * kFrames) << "followed on twice";
  EXPECT_EQ(older->pixel, kPixel);
  for (const taa::ErrorOfFrame& entry : older->frames)
    EXPECT_NEAR(of(entry.split, ErrorPart::Lag).x,
                entry.frame == changed ? 0.8 * std::pow(0.95, older->frame - changed + 1) : 0.0, 1e-6)
        << entry.frame;
}

TEST(OlderError, IsOfWhatCoveredTheSurface) {
  const int changed = 4, last = changed + 20;
  MadeEvidence evidence;
  changeAt(changed, last, coveredFrame(0.1, 1), evidence);
  const std::optional<PixelError> older = olderError(evidence, errorIn(evidence, last));
  ASSERT_TRUE(older);
  EXPECT_EQ(mainPart(*older).part, ErrorPart::Ghost);
}

TEST(OlderError, IsNotLookedForWhereMostCameInLately) {
  MadeEvidence evidence;
  changeAt(5, 12, stillFrame(0.1), evidence);
  EXPECT_FALSE(olderError(evidence, errorIn(evidence, 12)));
}

TEST(OlderError, IsFollowedOnAFewTimesOnly) {
  const int last = 5 + (taa::kOlderSteps + 1) * kFrames;
  MadeEvidence evidence;
  changeAt(3, last, stillFrame(0.1), evidence);
  const std::optional<PixelError> older = olderError(evidence, errorIn(evidence, last));
  ASSERT_TRUE(older);
  EXPECT_EQ(mainPart(*older).part, ErrorPart::Older);
  EXPECT_EQ(older->frame, last - taa::kOlderSteps * kFrames);
}

TEST(OlderError, FollowsAnOldErrorOnInWhatIsStillMade) {
  VerdictEvidence going = offForLong();
  for (int age = 0; age < 10; ++age) addError(going, ErrorPart::Aliasing, age, glm::dvec3(0.002));
  const taa::PixelVerdict made = judge(going, Settings{});
  EXPECT_EQ(made.part, ErrorPart::Aliasing);
  EXPECT_EQ(made.kind, VerdictKind::Blur);
  EXPECT_EQ(made.stage, Stage::FilterCurrent);
  EXPECT_TRUE(made.isOlder);

  VerdictEvidence fading = offForLong(); // at this rate the frames would have made a tenth of it
  addError(fading, ErrorPart::Aliasing, 0, glm::dvec3(0.002));
  EXPECT_EQ(judge(fading, Settings{}).part, ErrorPart::Older);
}

TEST(OlderError, CallsALightThatChangedLongAgoLag) {
  const taa::PixelVerdict verdict = judge(offSince20(ErrorPart::Lag), Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Lag);
  EXPECT_EQ(verdict.part, ErrorPart::Lag);
  EXPECT_EQ(verdict.since, 20);
  EXPECT_TRUE(verdict.isOlder);
  const std::string sentence = verdictSentence(verdict, 40, "", Settings{});
  EXPECT_TRUE(sentence.starts_with("Lag since frame 20: the light or the shading changed")) << sentence;
}

TEST(OlderError, NamesWhatAGhostOfLongAgoIsOf) {
  VerdictEvidence evidence = offSince20(ErrorPart::Ghost);
  evidence.older->frames[4].ghostObject = 1;
  evidence.older->outliers = {{19, 7, glm::dvec3(0.1), 0.2}, {18, 7, glm::dvec3(0.09), 0.18}};
  evidence.ghostFrame = 20;
  const taa::PixelVerdict verdict = judge(evidence, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
  EXPECT_EQ(verdict.causeObject, 7);
  EXPECT_EQ(verdict.causeFrame, 19);
  EXPECT_EQ(verdict.rows.front().frame, 20);
}

TEST(OlderError, SaysThatItDoesNotKnowWhatIsOlderThanAllThatWasFollowed) {
  const taa::PixelVerdict verdict = judge(offSince20(ErrorPart::Older), Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Lag);
  EXPECT_EQ(verdict.part, ErrorPart::Older);
  EXPECT_FALSE(verdict.causeObject);
  const std::string sentence = verdictSentence(verdict, 40, "", Settings{});
  EXPECT_TRUE(sentence.starts_with("Lag since before frame 20: ")) << sentence;
  EXPECT_NE(sentence.find("older than the 16 frames"), std::string::npos) << sentence;
}
