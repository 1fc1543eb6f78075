// What is concluded from evidence that is made by hand, each with what is true of it.
#include "core/verdict/pixel/PixelVerdict.h"
#include "core/verdict/pixel/VerdictText.h"
#include "tests/support/verdicts/JudgedPixel.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace {

using taa::ErrorPart;
using taa::IntermediateId;
using taa::of;
using taa::Settings;
using taa::Stage;
using taa::VerdictEvidence;
using taa::VerdictKind;
using taa::test::addError;
using taa::test::healthy;

VerdictEvidence ghostOf(int object, int age) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Ghost, age, {0.4, 0.0, 0.0});
  evidence.error.frames[static_cast<std::size_t>(age)].ghostObject = object;
  evidence.ghostFrame = 40 - age;
  return evidence;
}

TEST(PixelVerdict, OfAPixelThatIsRightSaysSo) {
  const taa::PixelVerdict verdict = judge(healthy(), Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::None);
  EXPECT_EQ(verdict.error, 0.0);
  EXPECT_EQ(verdict.flicker, 0.0);
  EXPECT_GE(verdict.rows.size(), 4u);
  EXPECT_TRUE(verdictSentence(verdict, 40, "", Settings{}).starts_with("Nothing is wrong: "));
}

TEST(PixelVerdict, NamesAGhostWithItsObjectAndTheFrameThatShowedIt) {
  const taa::PixelVerdict verdict = judge(ghostOf(5, 5), Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
  EXPECT_EQ(verdict.part, ErrorPart::Ghost);
  EXPECT_NEAR(verdict.share, 1.0, 1e-12);
  EXPECT_EQ(verdict.since, 35);
  EXPECT_EQ(verdict.causeFrame, 34); // no sample tells: what history was read of in the frame before
  EXPECT_EQ(verdict.causeObject, 5);
  const std::string sentence = verdictSentence(verdict, 40, "red bar", Settings{});
  EXPECT_TRUE(sentence.starts_with("Ghost of red bar, 6 frames ago: ")) << sentence;
}

TEST(PixelVerdict, NamesTheObjectWhoseSamplesMakeTheErrorOfAGhost) {
  VerdictEvidence evidence = ghostOf(1, 2);
  evidence.error.strays = {{38, 2, {-0.3, 0.0, 0.0}, 0.2}, // the other way
                           {38, 5, {0.03, 0.0, 0.0}, 0.2}, // hardly seen
                           {37, 5, {0.1, 0.0, 0.0}, 0.2},  {36, 5, {0.15, 0.0, 0.0}, 0.2},
                           {35, 5, {0.3, 0.0, 0.0}, 0.8}, // of much, as where history starts
                           {35, 1, {0.4, 0.0, 0.0}, 0.8},  {35, 3, {0.0, 0.9, 0.0}, 0.8}}; // across
  const taa::PixelVerdict verdict = judge(evidence, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
  EXPECT_EQ(verdict.causeObject, 5) << "1 has what does most, 5 does more together";
  EXPECT_EQ(verdict.causeFrame, 37) << "the latest that shows it half as far off as any";
  const std::string sentence = verdictSentence(verdict, 40, "blade", Settings{});
  EXPECT_TRUE(sentence.starts_with("Ghost of blade, 3 frames ago: ")) << sentence;
}

TEST(PixelVerdict, BlamesTheFirstStageThatCouldHaveStoppedAGhost) {
  Settings settings;
  settings.validate.depth = taa::Switch::Off;
  settings.rectify.method = taa::RectifyMethod::None;
  EXPECT_EQ(judge(ghostOf(5, 3), settings).stage, Stage::ValidateHistory);
  settings.rectify.method = taa::RectifyMethod::Clamp;
  EXPECT_EQ(judge(ghostOf(5, 3), settings).stage, Stage::RectifyHistory);
  settings.validate.depth = taa::Switch::On; // it ran, and let it pass
  EXPECT_EQ(judge(ghostOf(5, 3), settings).stage, Stage::ValidateHistory);
  settings.reproject.method = taa::ReprojectMethod::InPlace;
  EXPECT_EQ(judge(ghostOf(5, 3), settings).stage, Stage::Reproject);
}

TEST(PixelVerdict, BlamesMotionThatIsNotTheSurfaces) {
  VerdictEvidence evidence = ghostOf(5, 2);
  evidence.ghostMotion = glm::dvec2(0.0);
  taa::twin::at(evidence.ghostRecord, IntermediateId::dilatedMotion) = {6.0f, 0.0f, 0.0f, 0.0f};
  const Stage guard = judge(ghostOf(5, 2), Settings{}).stage;
  EXPECT_EQ(judge(evidence, Settings{}).stage, guard) << "the surface's own would have led to it as well";
  evidence.error.frames[2].isGhostOfMotion = true;
  EXPECT_EQ(judge(evidence, Settings{}).stage, Stage::Inputs);
  taa::twin::at(evidence.ghostRecord, IntermediateId::dilatedOffset) = {1.0f, 0.0f, 0.0f, 0.0f};
  EXPECT_EQ(judge(evidence, Settings{}).stage, Stage::DilateMotion);
  Settings unguarded;
  unguarded.validate.depth = taa::Switch::Off;
  unguarded.rectify.method = taa::RectifyMethod::None;
  EXPECT_EQ(judge(evidence, unguarded).stage, Stage::ValidateHistory) << "dilation reads amiss beside edges";
  taa::twin::at(evidence.ghostRecord, IntermediateId::motion) = {5.9f, 0.0f, 0.0f, 0.0f};
  for (const Settings& settings : {Settings{}, unguarded})
    EXPECT_EQ(judge(evidence, settings).stage, Stage::Inputs) << "its own is wrong, too";
  taa::twin::at(evidence.ghostRecord, IntermediateId::dilatedOffset) = glm::vec4(0.0f);
  EXPECT_EQ(judge(evidence, unguarded).stage, Stage::Inputs) << "no guard mends a wrong motion";
}

TEST(PixelVerdict, TellsWhatComesAndGoesFromWhatFades) {
  VerdictEvidence flickering = healthy();
  for (std::size_t age = 0; age < flickering.moments.size(); ++age)
    flickering.moments[age].resolved += age % 2 == 0 ? 0.1 : -0.1;
  of(flickering.error.sum, ErrorPart::Rectification) = glm::dvec3(0.1);
  flickering.error.resolved += 0.1;
  EXPECT_EQ(judge(flickering, Settings{}).kind, VerdictKind::Flicker);

  VerdictEvidence fading = healthy();
  addError(fading, ErrorPart::Lag, 6, glm::dvec3(0.2));
  double error = 0.2;
  for (std::size_t age = 0; age <= 6; ++age, error /= 0.9)
    fading.moments[age].resolved = glm::dvec3(0.5 + error);
  const taa::PixelVerdict verdict = judge(fading, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Lag);
  EXPECT_EQ(verdict.since, 34);
}

/// What is shown comes and goes.
VerdictEvidence trembling() {
  VerdictEvidence evidence = healthy();
  for (std::size_t age = 0; age < evidence.moments.size(); ++age)
    evidence.moments[age].resolved += age % 2 == 0 ? 0.1 : -0.1;
  addError(evidence, ErrorPart::Rectification, 0, glm::dvec3(0.1));
  return evidence;
}

TEST(PixelVerdict, CallsNothingFlickerThatTruthDoesAsWell) {
  EXPECT_EQ(judge(trembling(), Settings{}).kind, VerdictKind::Flicker);
  VerdictEvidence moving = trembling(); // a sharp edge that moves, and the same one blurred
  for (std::size_t age = 0; age < moving.moments.size(); ++age)
    moving.moments[age].reference += age % 2 == 0 ? 0.3 : -0.3;
  const taa::PixelVerdict verdict = judge(moving, Settings{});
  EXPECT_EQ(verdict.flicker, 0.0);
  EXPECT_EQ(verdict.kind, VerdictKind::Blur);
}

TEST(PixelVerdict, BlamesRectificationForFlickerWhereItClips) {
  const taa::PixelVerdict followed = judge(trembling(), Settings{});
  EXPECT_EQ(followed.stage, Stage::BlendWeight);
  EXPECT_EQ(followed.rows.size(), 4u);
  EXPECT_EQ(verdictSentence(followed, 40, "", Settings{}),
            "Flicker: each sample shows, for the current frame counts 10 %.");
  VerdictEvidence clipped = trembling();
  for (const std::size_t age : {2u, 5u})
    taa::twin::at(clipped.moments[age].record, IntermediateId::clipAmount).x = 0.9f;
  EXPECT_EQ(judge(clipped, Settings{}).stage, Stage::RectifyHistory);
  VerdictEvidence thrown = trembling();
  const auto rejectAt = [&](std::size_t age, float reason) {
    taa::twin::at(thrown.moments[age].record, IntermediateId::alpha).x = 1.0f;
    taa::twin::at(thrown.moments[age].record, IntermediateId::rejectReason).x = reason;
  };
  rejectAt(15, 1.0f); // there was none
  rejectAt(3, 4.0f);
  EXPECT_EQ(judge(thrown, Settings{}).stage, Stage::BlendWeight) << "once is not again and again";
  rejectAt(9, 4.0f);
  EXPECT_EQ(judge(thrown, Settings{}).stage, Stage::ValidateHistory);
}

TEST(PixelVerdict, CallsNothingFlickerThatMotionOrAFilterDoes) {
  for (const ErrorPart part : {ErrorPart::Lag, ErrorPart::Blur, ErrorPart::Ghost}) {
    VerdictEvidence moved = trembling();
    addError(moved, part, 0, glm::dvec3(0.3));
    EXPECT_NE(judge(moved, Settings{}).kind, VerdictKind::Flicker);
  }
  for (const double direction : {1.0, -1.0}) {
    VerdictEvidence sampled = trembling();
    for (int age = 0; age < 6; ++age)
      addError(sampled, ErrorPart::Aliasing, age, glm::dvec3(age < 4 ? 0.1 : 0.05 * direction));
    EXPECT_EQ(judge(sampled, Settings{}).kind, direction > 0.0 ? VerdictKind::Blur : VerdictKind::Flicker)
        << "all samples are off one way, or not";
  }
}

TEST(PixelVerdict, CallsFlickerOfWhatIsBrighterThanWhiteAHighlights) {
  VerdictEvidence evidence = healthy();
  for (std::size_t age = 0; age < evidence.moments.size(); ++age) {
    evidence.moments[age].resolved += age % 2 == 0 ? 0.1 : -0.1;
    taa::twin::at(evidence.moments[age].record, IntermediateId::color) = {age % 4 == 0 ? 6.0f : 0.2f, 0, 0,
                                                                          0};
  }
  of(evidence.error.sum, ErrorPart::Aliasing) = glm::dvec3(0.1);
  evidence.error.resolved += 0.1;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::HighlightFlicker);
}

/// History was given up three frames ago.
VerdictEvidence restarted(float reason) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Aliasing, 3, glm::dvec3(0.2));
  taa::twin::at(evidence.moments[3].record, IntermediateId::alpha).x = 1.0f;
  taa::twin::at(evidence.moments[3].record, IntermediateId::rejectReason).x = reason;
  return evidence;
}

TEST(PixelVerdict, TellsARestartThatHadToBeFromGoodHistoryThrownAway) {
  VerdictEvidence hidden = restarted(4.0f); // depth
  hidden.moments.resize(4);
  hidden.endsHidden = true;
  const taa::PixelVerdict had = judge(hidden, Settings{});
  EXPECT_EQ(had.kind, VerdictKind::DisocclusionRestart);
  EXPECT_FALSE(had.throwsGoodAway);
  EXPECT_EQ(had.since, 37);

  const taa::PixelVerdict thrown = judge(restarted(4.0f), Settings{});
  EXPECT_EQ(thrown.kind, VerdictKind::Aliasing);
  EXPECT_TRUE(thrown.throwsGoodAway);
  EXPECT_EQ(thrown.stage, Stage::ValidateHistory);
  const std::string sentence = verdictSentence(thrown, 40, "", Settings{});
  EXPECT_NE(sentence.find("although the surface was there"), std::string::npos) << sentence;
}

TEST(PixelVerdict, AsksNoMoreSamplesOfASurfaceThanFramesShowedIt) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Aliasing, 3, glm::dvec3(0.2));
  evidence.moments.resize(4);
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Aliasing);
  evidence.endsHidden = true; // and yet 19 samples are averaged: others' history
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Aliasing);
  taa::twin::at(evidence.moments[0].record, IntermediateId::historyLength).x = 4.0f;
  const taa::PixelVerdict verdict = judge(evidence, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::DisocclusionRestart);
  EXPECT_EQ(verdict.since, 37);
}

TEST(PixelVerdict, TakesWhatLayNearerForWhatHidTheSurface) {
  VerdictEvidence evidence = restarted(4.0f); // seen beside its place
  auto& record = evidence.moments[3].record;
  taa::twin::at(record, IntermediateId::depthExpected).x = 5.0f;
  taa::twin::at(record, IntermediateId::historyDepth).x = 3.0f;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::DisocclusionRestart);
  taa::twin::at(record, IntermediateId::historyDepth).x = 9.0f; // the background of something thin
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Aliasing);
  taa::twin::at(record, IntermediateId::historyDepth).x = 0.0f; // the sky
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Aliasing);
}

TEST(PixelVerdict, NamesWhatTakesDetail) {
  VerdictEvidence read = healthy();
  addError(read, ErrorPart::Blur, 2, glm::dvec3(0.2));
  EXPECT_EQ(judge(read, Settings{}).kind, VerdictKind::Blur);
  EXPECT_EQ(judge(read, Settings{}).stage, Stage::SampleHistory);

  VerdictEvidence filtered = healthy();
  for (int age = 0; age < 10; ++age) addError(filtered, ErrorPart::Aliasing, age, glm::dvec3(0.02));
  EXPECT_EQ(judge(filtered, Settings{}).kind, VerdictKind::Blur);
  EXPECT_EQ(judge(filtered, Settings{}).stage, Stage::FilterCurrent);

  // The filter adds nothing to what its samples have.
  for (taa::SurfaceMoment& moment : filtered.moments)
    for (const IntermediateId row : {IntermediateId::color, IntermediateId::currentFiltered})
      taa::twin::at(moment.record, row) = {0.7f, 0.7f, 0.7f, 0.0f};
  const taa::PixelVerdict still = judge(filtered, Settings{});
  EXPECT_EQ(still.kind, VerdictKind::Aliasing);
  EXPECT_EQ(still.stage, Stage::Jitter);
  EXPECT_TRUE(
      verdictSentence(still, 40, "", Settings{}).ends_with(": all samples are of one place in the pixel."));
  taa::twin::at(filtered.moments[5].record, IntermediateId::color).x = 0.65f;
  EXPECT_EQ(judge(filtered, Settings{}).kind, VerdictKind::Blur);
  EXPECT_EQ(judge(filtered, Settings{}).stage, Stage::Inputs) << "textures that are too soft, say";

  VerdictEvidence pulled = healthy();
  addError(pulled, ErrorPart::Rectification, 1, glm::dvec3(0.2));
  EXPECT_EQ(judge(pulled, Settings{}).stage, Stage::RectifyHistory);
  EXPECT_TRUE(judge(pulled, Settings{}).throwsGoodAway);
}

TEST(PixelVerdict, CallsLagUnderAMaskASmear) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Lag, 1, glm::dvec3(0.2));
  taa::twin::at(evidence.moments[0].record, IntermediateId::responsive).x = 1.0f;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::MaskSmear);
  EXPECT_EQ(judge(evidence, Settings{}).stage, Stage::BlendWeight);
}

TEST(PixelVerdict, CallsLagOfAMaterialThatNoMaskIsDrawnOfASmearToo) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Lag, 1, glm::dvec3(0.2));
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Lag);
  evidence.error.frames[0].isChanging = true;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::MaskSmear);
  EXPECT_EQ(judge(evidence, Settings{}).stage, Stage::Inputs);
}

TEST(PixelVerdict, CallsWhatWasBlendedOverASurfaceAGhost) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Lag, 3, glm::dvec3(0.2));
  evidence.error.frames[5].isBlendedOver = true;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Lag) << "two frames before the change";
  evidence.error.frames[4].isBlendedOver = true;
  const taa::PixelVerdict verdict = judge(evidence, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
  EXPECT_EQ(verdict.causeFrame, 37);
  const std::string sentence = verdictSentence(verdict, 40, "", Settings{});
  EXPECT_TRUE(sentence.starts_with("Ghost, 3 frames ago: it was blended over the surface")) << sentence;
}

TEST(PixelVerdict, SaysWhatAFilterOfHistoryDoes) {
  taa::PixelVerdict verdict;
  verdict.kind = VerdictKind::Blur;
  verdict.stage = Stage::SampleHistory;
  const auto said = [&](taa::HistoryFilter filter) {
    Settings settings;
    settings.history.filter = filter;
    return verdictSentence(verdict, 3, "", settings);
  };
  EXPECT_EQ(said(taa::HistoryFilter::Bilinear), "Blur: reading history between its pixels takes detail.");
  EXPECT_EQ(said(taa::HistoryFilter::Point),
            "Blur: history is read at the nearest pixel, beside where the surface was.");
  EXPECT_EQ(said(taa::HistoryFilter::Cubic), "Blur: reading history between its pixels changes detail.");
}

TEST(PixelVerdict, HasASentenceWithoutPlacesLeftForEveryKindAndStage) {
  for (const taa::VerdictKindInfo& info : taa::kVerdictKinds)
    for (const taa::StageInfo& stage : taa::kStages) {
      taa::PixelVerdict verdict;
      verdict.kind = info.kind;
      verdict.stage = stage.stage;
      const std::string sentence = verdictSentence(verdict, 3, "fan", Settings{});
      for (const char* place : {"%1", "%2", "%3"})
        EXPECT_EQ(sentence.find(place), std::string::npos) << sentence;
      EXPECT_EQ(sentence.find(": ."), std::string::npos) << sentence;
      EXPECT_TRUE(sentence.ends_with('.')) << sentence;
    }
}

} // namespace
