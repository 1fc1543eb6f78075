// What is concluded from evidence that is made by hand, each with what is true of it.
#include "core/verdict/pixel/PixelVerdict.h"
#include "core/verdict/pixel/VerdictText.h"
#include "tests/support/verdicts/JudgedPixel.h"

#include <gtest/gtest.h>

#include <cmath>
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

void setRow(taa::SurfaceMoment& moment, IntermediateId row, float value) {
  taa::twin::at(moment.record, row) = glm::vec4(value);
}

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
  EXPECT_TRUE(verdictSentence(verdict, 40, "", Settings{}).starts_with("Nothing is wrong. "));
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
  EXPECT_TRUE(sentence.starts_with("Ghost of red bar, here until frame 34: ")) << sentence;
}

TEST(PixelVerdict, NamesTheObjectWhoseSamplesMakeTheErrorOfAGhost) {
  VerdictEvidence evidence = ghostOf(1, 2);
  evidence.error.outliers = {{38, 2, {-0.3, 0.0, 0.0}, 0.2}, // the other way
                             {38, 5, {0.03, 0.0, 0.0}, 0.2}, // hardly seen
                             {37, 5, {0.1, 0.0, 0.0}, 0.2},  {36, 5, {0.15, 0.0, 0.0}, 0.2},
                             {35, 5, {0.3, 0.0, 0.0}, 0.8}, // of much, as where history starts
                             {35, 1, {0.4, 0.0, 0.0}, 0.8},  {35, 3, {0.0, 0.9, 0.0}, 0.8}}; // across
  const taa::PixelVerdict verdict = judge(evidence, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
  EXPECT_EQ(verdict.causeObject, 5) << "1 has what does most, 5 does more together";
  EXPECT_EQ(verdict.causeFrame, 37) << "the latest that shows it half as far off as any";
  const std::string sentence = verdictSentence(verdict, 40, "blade", Settings{});
  EXPECT_TRUE(sentence.starts_with("Ghost of blade, here until frame 37: ")) << sentence;
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
            "Flicker: the current frame has a weight (α) of 10 %, so each frame's jittered sample shows.");
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

/// One color of 20 in the frame before, as the filter has it and, where `row` is the color, as the sample
/// itself is: it is all of the error.
VerdictEvidence glinted(IntermediateId row) {
  VerdictEvidence evidence = healthy();
  for (taa::SurfaceMoment& moment : evidence.moments)
    for (const IntermediateId color : {IntermediateId::color, IntermediateId::currentFiltered})
      setRow(moment, color, 0.4f);
  setRow(evidence.moments[1], row, 20.0f);
  setRow(evidence.moments[1], IntermediateId::currentFiltered, 20.0f);
  addError(evidence, ErrorPart::Aliasing, 1, glm::dvec3(0.4));
  return evidence;
}

// One sample of many outweighs the others, and once in sixteen frames is no quarter of them.
TEST(PixelVerdict, CallsASingleSampleBrighterThanWhiteAHighlightsFlicker) {
  const taa::PixelVerdict glint = judge(glinted(IntermediateId::color), Settings{});
  EXPECT_EQ(glint.kind, VerdictKind::HighlightFlicker);
  EXPECT_EQ(glint.stage, Stage::Blend);
  EXPECT_EQ(glint.repeated.events, 1);
  const taa::PixelVerdict neighbors = judge(glinted(IntermediateId::currentFiltered), Settings{});
  EXPECT_EQ(neighbors.kind, VerdictKind::HighlightFlicker);
  EXPECT_EQ(neighbors.stage, Stage::FilterCurrent) << "no sample of the pixel itself is as bright";
  VerdictEvidence clipped = glinted(IntermediateId::color);
  setRow(clipped.moments[0], IntermediateId::clipAmount, 1.0f);
  setRow(clipped.moments[3], IntermediateId::clipAmount, 1.0f);
  EXPECT_EQ(judge(clipped, Settings{}).stage, Stage::RectifyHistory);
  VerdictEvidence lamp = glinted(IntermediateId::color);
  for (taa::SurfaceMoment& moment : lamp.moments) setRow(moment, IntermediateId::color, 20.0f);
  EXPECT_NE(judge(lamp, Settings{}).kind, VerdictKind::HighlightFlicker) << "it is always as bright";
}

/// History was given up three frames ago.
VerdictEvidence restarted(float reason) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Aliasing, 3, glm::dvec3(0.2));
  taa::twin::at(evidence.moments[3].record, IntermediateId::alpha).x = 1.0f;
  taa::twin::at(evidence.moments[3].record, IntermediateId::rejectReason).x = reason;
  taa::twin::at(evidence.moments[0].record, IntermediateId::historyLength).x = 4.0f;
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
  EXPECT_NE(sentence.find("although the surface was visible before"), std::string::npos) << sentence;
}

/// Samples err by `errors`, latest first, and again; each has the weight `alpha`.
VerdictEvidence sampled(const std::vector<double>& errors, float alpha) {
  VerdictEvidence evidence = healthy();
  for (std::size_t age = 0; age < evidence.moments.size(); ++age) {
    const double error = errors[age % errors.size()];
    for (const IntermediateId row : {IntermediateId::color, IntermediateId::currentFiltered})
      setRow(evidence.moments[age], row, static_cast<float>(0.5 + error));
    setRow(evidence.moments[age], IntermediateId::alpha, alpha);
    addError(
        evidence, ErrorPart::Aliasing, static_cast<int>(age),
        glm::dvec3(error * static_cast<double>(alpha) * std::pow(1.0 - static_cast<double>(alpha), age)));
    evidence.moments[age].resolved = glm::dvec3(0.5 + (age % 2 == 0 ? 0.1 : -0.1));
  }
  return evidence;
}

TEST(PixelVerdict, CallsARestartOnlyWhereMoreSamplesCouldNotBeThereYet) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Aliasing, 3, glm::dvec3(0.2));
  evidence.moments.resize(4);
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Aliasing) << "it is not known to have been hidden";
  evidence.endsHidden = true;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Aliasing) << "19 samples: others' history";
  setRow(evidence.moments[0], IntermediateId::historyLength, 4.0f);
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::DisocclusionRestart);
  EXPECT_EQ(judge(evidence, Settings{}).since, 37);
}

TEST(PixelVerdict, BlamesTheWeightWhereAnEvenAverageSinceHistoryStartedWouldBeRight) {
  // Six frames since the start: their mean is right, and what is shown is not.
  VerdictEvidence evidence = sampled({0.3, -0.3}, 0.4f);
  evidence.moments.resize(6);
  setRow(evidence.moments[5], IntermediateId::rejectReason, 1.0f);
  setRow(evidence.moments[5], IntermediateId::alpha, 1.0f);
  setRow(evidence.moments[0], IntermediateId::historyLength, 3.0f);
  const taa::PixelVerdict flickering = judge(evidence, Settings{});
  EXPECT_EQ(flickering.kind, VerdictKind::Flicker);
  EXPECT_EQ(flickering.stage, Stage::BlendWeight);
  for (taa::SurfaceMoment& moment : evidence.moments) // their mean is as wrong
    setRow(moment, IntermediateId::currentFiltered, 0.8f);
  for (taa::SurfaceMoment& moment : evidence.moments) {
    setRow(moment, IntermediateId::color, 0.8f);
    moment.resolved = evidence.moments.front().resolved;
  }
  const taa::PixelVerdict young = judge(evidence, Settings{});
  EXPECT_EQ(young.kind, VerdictKind::DisocclusionRestart);
  EXPECT_NE(verdictSentence(young, 40, "", Settings{}).find("history started 5 frames ago"),
            std::string::npos)
      << verdictSentence(young, 40, "", Settings{});
}

TEST(PixelVerdict, BlamesTheWeightForARestartWhoseSamplesItWeighsUnequally) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Aliasing, 3, glm::dvec3(0.2));
  evidence.moments.resize(4);
  evidence.endsHidden = true;
  setRow(evidence.moments[0], IntermediateId::historyLength, 4.0f);
  for (const bool isEven : {true, false}) {
    for (std::size_t age = 0; age < 4; ++age) // 1/n is an even average; of 0.05 the first has 0.86
      setRow(evidence.moments[age], IntermediateId::alpha,
             age == 3 ? 1.0f
             : isEven ? 1.0f / static_cast<float>(4 - age)
                      : 0.05f);
    const taa::PixelVerdict verdict = judge(evidence, Settings{});
    EXPECT_EQ(verdict.kind, VerdictKind::DisocclusionRestart);
    EXPECT_EQ(verdict.stage, isEven ? Stage::ValidateHistory : Stage::BlendWeight);
    const bool isWeights =
        verdictSentence(verdict, 40, "", Settings{}).find("unequally") != std::string::npos;
    EXPECT_EQ(isWeights, !isEven) << "what the stage is blamed for is said";
  }
}

TEST(PixelVerdict, BlamesAPatternOfFewPlacesWhoseMeanIsNotThePixels) {
  VerdictEvidence evidence = sampled({0.5, -0.1}, 0.1f);
  for (taa::SurfaceMoment& moment : evidence.moments) moment.resolved = glm::dvec3(0.65);
  Settings settings;
  EXPECT_EQ(judge(evidence, settings).stage, Stage::BlendWeight) << "sixteen places";
  settings.jitter.sequence = taa::JitterSequence::Uniform2;
  const taa::PixelVerdict verdict = judge(evidence, settings);
  EXPECT_EQ(verdict.kind, VerdictKind::Aliasing);
  EXPECT_EQ(verdict.stage, Stage::Jitter);
  const std::string sentence = verdictSentence(verdict, 40, "", settings);
  EXPECT_NE(sentence.find("the jitter's 2 places"), std::string::npos) << sentence;
  settings.jitter.scale = 0.0f;
  EXPECT_NE(verdictSentence(verdict, 40, "", settings).find("at one place"), std::string::npos);
  setRow(evidence.moments[5], IntermediateId::color, 0.9f); // once: it is not the pattern
  EXPECT_EQ(judge(evidence, settings).stage, Stage::BlendWeight);
}

TEST(PixelVerdict, BlamesOneClippingForFlickerThatTookMuch) {
  for (const double taken : {0.05, 0.2}) { // of the samples' 0.24
    VerdictEvidence evidence = sampled({0.3, -0.3}, 0.1f);
    setRow(evidence.moments[2], IntermediateId::clipAmount, 0.9f);
    addError(evidence, ErrorPart::Rectification, 2, glm::dvec3(taken));
    const taa::PixelVerdict verdict = judge(evidence, Settings{});
    EXPECT_EQ(verdict.kind, VerdictKind::Flicker);
    EXPECT_EQ(verdict.stage, taken > 0.12 ? Stage::RectifyHistory : Stage::BlendWeight);
  }
}

TEST(PixelVerdict, CallsTheStartOfHistoryNoHistoryThrownAway) {
  VerdictEvidence evidence = sampled({0.3}, 0.1f);
  evidence.moments.resize(12);
  setRow(evidence.moments[11], IntermediateId::alpha, 1.0f);
  setRow(evidence.moments[11], IntermediateId::rejectReason, 1.0f); // RejectReason::NoHistory
  for (taa::SurfaceMoment& moment : evidence.moments) moment.resolved = glm::dvec3(0.65);
  evidence.error.frames.resize(3);
  const taa::PixelVerdict verdict = judge(evidence, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Aliasing);
  EXPECT_EQ(verdict.stage, Stage::BlendWeight);
  EXPECT_FALSE(verdict.throwsGoodAway);
}

TEST(PixelVerdict, CallsNoHistoryThrownAwayThatATestKept) {
  const taa::PixelVerdict verdict = judge(restarted(0.0f), Settings{}); // weighed 1 by its speed, say
  EXPECT_EQ(verdict.kind, VerdictKind::Aliasing);
  EXPECT_EQ(verdict.stage, Stage::BlendWeight);
  EXPECT_FALSE(verdict.throwsGoodAway);
}

TEST(PixelVerdict, TakesGeometrysWordForWhatWasUncovered) {
  VerdictEvidence evidence = restarted(4.0f); // by depth, of a surface that stands still
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Aliasing);
  evidence.moments[3].isUncovered = true;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::DisocclusionRestart);
}

TEST(PixelVerdict, SaysWhereFewerThanThreeSamplesAreAveraged) {
  for (const float alpha : {0.6f, 0.85f, 1.0f}) {
    VerdictEvidence evidence = sampled({0.3, -0.3}, alpha);
    if (alpha < 0.8f) // of more than one sample and a half where it does not come and go
      for (taa::SurfaceMoment& moment : evidence.moments) moment.resolved = glm::dvec3(0.6);
    const taa::PixelVerdict verdict = judge(evidence, Settings{});
    EXPECT_EQ(verdict.kind, VerdictKind::Aliasing);
    EXPECT_EQ(verdict.stage, Stage::BlendWeight);
    const bool isAll = verdictSentence(verdict, 40, "", Settings{}).find("α is 1") != std::string::npos;
    EXPECT_EQ(isAll, alpha == 1.0f);
  }
  for (const float alpha : {0.4f, 0.6f})
    EXPECT_EQ(judge(sampled({0.3, -0.3}, alpha), Settings{}).kind, VerdictKind::Flicker) << alpha;
}

TEST(PixelVerdict, LooksAtNoFlickerOfBeforeAJump) {
  VerdictEvidence evidence = healthy();
  for (std::size_t age = 4; age < evidence.moments.size(); ++age)
    evidence.moments[age].resolved += age % 2 == 0 ? 0.1 : -0.1;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Flicker);
  evidence.moments[3].isJump = true;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::None);
}

TEST(PixelVerdict, SaysNoOnsetBeforeTheErrorCouldBeSeen) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Lag, 12, glm::dvec3(0.2));
  for (std::size_t age = 1; age < 12; ++age) evidence.moments[age].resolved = glm::dvec3(0.5); // made up for
  EXPECT_EQ(judge(evidence, Settings{}).since, 40);
  for (std::size_t age = 1; age < 3; ++age) evidence.moments[age].resolved = glm::dvec3(0.7);
  EXPECT_EQ(judge(evidence, Settings{}).since, 38);
}

TEST(PixelVerdict, AddsUpWhatMotionIsOffOverFrames) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Lag, 4, glm::dvec3(0.2));
  for (taa::SurfaceMoment& moment : evidence.moments) {
    moment.motion = glm::dvec2(-0.2, 0.0);
    moment.resolved = glm::dvec3(0.7);
    taa::twin::at(moment.record, IntermediateId::motion) = {-0.2f, 0.0f, 0.0f, 0.0f};
    taa::twin::at(moment.record, IntermediateId::dilatedMotion) = {-0.2f, 0.0f, 0.0f, 0.0f};
  }
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Lag);
  for (taa::SurfaceMoment& moment : evidence.moments) // five frames: 1 px
    taa::twin::at(moment.record, IntermediateId::dilatedMotion) = glm::vec4(0.0f);
  const taa::PixelVerdict dilated = judge(evidence, Settings{});
  EXPECT_EQ(dilated.kind, VerdictKind::Ghost);
  EXPECT_EQ(dilated.stage, Stage::DilateMotion);
  for (taa::SurfaceMoment& moment : evidence.moments)
    taa::twin::at(moment.record, IntermediateId::motion) = glm::vec4(0.0f);
  EXPECT_EQ(judge(evidence, Settings{}).stage, Stage::Inputs);
}

TEST(PixelVerdict, CallsWhatPassesByAGhostAndNoLagOrBlur) {
  for (const ErrorPart part : {ErrorPart::Lag, ErrorPart::Blur}) {
    VerdictEvidence evidence = healthy();
    addError(evidence, part, 3, glm::dvec3(0.2));
    EXPECT_NE(judge(evidence, Settings{}).kind, VerdictKind::Ghost);
    evidence.error.frames[3].passedBy = 7;
    const taa::PixelVerdict verdict = judge(evidence, Settings{});
    EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
    EXPECT_EQ(verdict.causeObject, 7);
  }
}

// What a filter spread over the edge and then read on is not read of something else in the frame that brought
// most.
TEST(PixelVerdict, CallsWhatIsMostlyAnotherObjectsSamplesAGhost) {
  for (const ErrorPart part : {ErrorPart::Lag, ErrorPart::Blur, ErrorPart::Rectification}) {
    VerdictEvidence evidence = healthy();
    addError(evidence, part, 3, glm::dvec3(0.2));
    evidence.object = 4;
    evidence.error.outliers = {{37, 7, glm::dvec3(0.05), 0.1},
                               {36, 7, glm::dvec3(0.045), 0.1}}; // 0.095 of 0.2
    EXPECT_NE(judge(evidence, Settings{}).kind, VerdictKind::Ghost);
    evidence.error.outliers.back().pull = glm::dvec3(0.055);
    const taa::PixelVerdict verdict = judge(evidence, Settings{});
    EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
    EXPECT_EQ(verdict.causeObject, 7);
    evidence.object = 7;
    EXPECT_NE(judge(evidence, Settings{}).kind, VerdictKind::Ghost) << "of itself";
    evidence.object = -1;
    EXPECT_NE(judge(evidence, Settings{}).kind, VerdictKind::Ghost) << "nobody knows whose pixel it is";
  }
}

TEST(PixelVerdict, AddsUpWhatSeveralOthersPull) {
  VerdictEvidence evidence = healthy();
  addError(evidence, ErrorPart::Blur, 3, glm::dvec3(0.2));
  evidence.object = 4;
  evidence.error.outliers = {{37, 7, glm::dvec3(0.06), 0.1}, {37, 8, glm::dvec3(0.03), 0.1}};
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Blur);
  evidence.error.outliers.back().pull = glm::dvec3(0.05); // 0.11 of 0.2
  const taa::PixelVerdict verdict = judge(evidence, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
  EXPECT_EQ(verdict.causeObject, 7);
}

// Step by step a filter's reach hides what changed on the surface: over all frames it does not.
TEST(PixelVerdict, CallsWhatTruthItselfWasLagWhateverPassesOrIsReadBeside) {
  for (const int passedBy : {-1, 7}) {
    VerdictEvidence evidence = healthy();
    for (std::size_t age = 0; age < evidence.error.frames.size(); ++age)
      evidence.error.frames[age].weight = std::pow(0.9, age);
    addError(evidence, ErrorPart::Blur, 3, glm::dvec3(0.2));
    evidence.error.frames[3].passedBy = passedBy;
    const VerdictKind without = judge(evidence, Settings{}).kind;
    EXPECT_EQ(without, passedBy < 0 ? VerdictKind::Blur : VerdictKind::Ghost);
    // What was sampled three frames ago or before has this share today.
    const double share = std::pow(0.9, 3);
    for (std::size_t age = 3; age < evidence.moments.size(); ++age)
      evidence.moments[age].former = glm::dvec3(0.5 + 0.45 * 0.2 / share);
    EXPECT_EQ(judge(evidence, Settings{}).kind, without);
    for (std::size_t age = 3; age < evidence.moments.size(); ++age)
      evidence.moments[age].former = glm::dvec3(0.5 + 0.55 * 0.2 / share);
    EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Lag);
  }
}

TEST(PixelVerdict, CallsWhatBlurAloneExplainsNoFlicker) {
  VerdictEvidence evidence = trembling(); // 0.1 by rectification
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Flicker);
  addError(evidence, ErrorPart::Rectification, 0, glm::dvec3(-0.2));
  addError(evidence, ErrorPart::Blur, 0, glm::dvec3(0.2));
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Blur);
}

TEST(PixelVerdict, FindsAnotherPlaceOfTheSameObjectByItsMotion) {
  VerdictEvidence evidence = healthy();
  evidence.object = 4;
  addError(evidence, ErrorPart::Rectification, 3, glm::dvec3(0.2));
  evidence.error.outliers = {{37, 4, glm::dvec3(0.11), 0.1}};
  for (taa::SurfaceMoment& moment : evidence.moments) {
    moment.motion = glm::dvec2(0.3, 0.0);
    taa::twin::at(moment.record, IntermediateId::dilatedMotion) = glm::vec4(0.3f, 0.0f, 0.0f, 0.0f);
    taa::twin::at(moment.record, IntermediateId::motion) = glm::vec4(0.3f, 0.0f, 0.0f, 0.0f);
  }
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Blur);
  for (taa::SurfaceMoment& moment : evidence.moments) moment.motion = glm::dvec2(0.0, 0.0);
  const taa::PixelVerdict verdict = judge(evidence, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
  EXPECT_EQ(verdict.stage, Stage::Inputs);
}

// A walker's own shadow: history is of the ground's own place beside it, and something passes.
TEST(PixelVerdict, CallsWhatASurfaceWasBesideItselfLag) {
  VerdictEvidence evidence = ghostOf(4, 3);
  evidence.object = 4;
  evidence.ghostMotion = glm::dvec2(0.0);
  evidence.error.frames[3].passedBy = 7;
  for (std::size_t age = 0; age < evidence.error.frames.size(); ++age)
    evidence.error.frames[age].weight = std::pow(0.9, age);
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Blur);
  for (std::size_t age = 3; age < evidence.moments.size(); ++age)
    evidence.moments[age].former = glm::dvec3(0.9, 0.5, 0.5);
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Lag);
}

// What blur adds and rectification takes back again is not what is wrong.
TEST(PixelVerdict, FindsTheGhostBelowBlurThatIsRectified) {
  VerdictEvidence evidence = ghostOf(5, 3);
  addError(evidence, ErrorPart::Blur, 3, {0.8, 0.0, 0.0});
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Blur);
  addError(evidence, ErrorPart::Rectification, 3, {-0.7, 0.0, 0.0});
  const taa::PixelVerdict verdict = judge(evidence, Settings{});
  EXPECT_EQ(verdict.kind, VerdictKind::Ghost);
  EXPECT_EQ(verdict.causeObject, 5);
}

TEST(PixelVerdict, BlamesTheJitterThatIsNotThereWhereTaaIsOff) {
  Settings off;
  off.jitter.taa = taa::Switch::Off;
  const taa::PixelVerdict verdict = judge(sampled({0.3, -0.3}, 1.0f), off);
  EXPECT_EQ(verdict.kind, VerdictKind::Aliasing);
  EXPECT_EQ(verdict.stage, Stage::Jitter);
}

TEST(PixelVerdict, CallsNoObjectAGhostOfItselfThatIsReadBesideItsPlace) {
  VerdictEvidence evidence = ghostOf(5, 3);
  evidence.object = 5;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Ghost) << "it was not seen before: its own back";
  evidence.ghostMotion = glm::dvec2(1.0, 0.0);
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Blur);
  EXPECT_EQ(judge(evidence, Settings{}).stage, Stage::SampleHistory) << "no test and no box made it";
  taa::twin::at(evidence.ghostRecord, IntermediateId::dilatedOffset) = {1.0f, 0.0f, 0.0f, 0.0f};
  EXPECT_EQ(judge(evidence, Settings{}).stage, Stage::DilateMotion);
  evidence.object = 4;
  EXPECT_EQ(judge(evidence, Settings{}).kind, VerdictKind::Ghost);
}

TEST(PixelVerdict, BlamesTheWeightForFlickerThatItMakesAlone) {
  VerdictEvidence evidence = sampled({0.3, -0.3}, 0.4f); // 0.4 · 0.3 is what is seen of it
  for (taa::SurfaceMoment& moment : evidence.moments) setRow(moment, IntermediateId::clipAmount, 0.9f);
  EXPECT_EQ(judge(evidence, Settings{}).stage, Stage::BlendWeight);
  for (taa::SurfaceMoment& moment : evidence.moments) setRow(moment, IntermediateId::alpha, 0.05f);
  const taa::PixelVerdict clipped = judge(evidence, Settings{});
  EXPECT_EQ(clipped.stage, Stage::RectifyHistory);
  EXPECT_NE(verdictSentence(clipped, 40, "", Settings{}).find("in 16 of the last 16 frames, by up to 90 %"),
            std::string::npos);
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
      verdictSentence(still, 40, "", Settings{}).ends_with(": all samples lie at one place of the pixel."));
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
  EXPECT_TRUE(sentence.starts_with("Ghost since frame 37: it was blended over the surface")) << sentence;
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
  EXPECT_EQ(said(taa::HistoryFilter::Bilinear),
            "Blur: resampling history (Bilinear) loses detail every frame.");
  EXPECT_EQ(said(taa::HistoryFilter::Point),
            "Blur: history is read at the nearest pixel, not where the surface was.");
  EXPECT_EQ(said(taa::HistoryFilter::Cubic), "Blur: resampling history (Cubic) changes detail every frame.");
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
