// What the probe tells: every row has words, and every formula, worked out with the numbers it states, gives
// the value it ends with, which is the row's.
#include "core/story/ProbeStory.h"
#include "core/settings/Presets.h"
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Known.h"
#include "core/taa/twin/Traced.h"
#include "tests/support/Calculator.h"
#include "tests/support/SmallInspector.h"
#include "tests/support/StoryPhrases.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace taa;
using ProbeStoryTest = taa::test::small::InspectorTest;

namespace {

/// Relative; the resolve rounds every step to 32 bits, and a spread is a small difference of large sums.
constexpr double kPrecision = 1e-4;

using test::Calculator;
using test::Values;
using Id = IntermediateId;
using test::expectTrue;

/// Whether both sides of the last "=" are the same. What is rounded may lie at the middle between two steps:
/// there the last digits of the numbers decide.
bool holds(const std::string& formula) {
  const std::size_t split = formula.rfind(" = ");
  if (split == std::string::npos) return false;
  const Values right = Calculator(formula.substr(split + 3)).result();
  std::vector<bool> isSame(right.size(), false);
  for (const double bias : {0.0, -1e-6, 1e-6}) {
    const Values left = Calculator(formula.substr(0, split), bias).result();
    if (left.size() != right.size()) return false;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (std::fabs(left[i] - right[i]) <= kPrecision * std::max(0.05, std::fabs(right[i]))) isSame[i] = true;
  }
  return std::ranges::all_of(isSame, [](bool same) { return same; });
}

/// The value the formula ends with is the row's, or what its subject says.
void expectEndsWithTheValue(IntermediateId id, const RowStory& story, const ProbedPixel& probed) {
  const Values stated = Calculator(story.formula.substr(story.formula.rfind(" = ") + 3)).result();
  glm::vec4 value = twin::at(probed.record, id);
  double precision = 1e-6;
  if (story.subject == "in box space")
    value = glm::vec4(twin::toBox(glm::vec3(value), probed.settings.space), 0.0f);
  if (story.subject == "compressed as in the box")
    value = glm::vec4(twin::compress(glm::vec3(value), probed.settings.space.tone), 0.0f);
  if (story.subject == "R, as the curve has it") { // before it is stored
    value = glm::vec4(twin::compress(glm::vec3(value), probed.settings.blend), 0.0f);
    precision = probed.settings.history.precision == Precision::Half ? 1e-3 : 1.0 / 255;
  }
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const auto shown = static_cast<double>(value[static_cast<int>(i)]);
    EXPECT_NEAR(stated[i], shown, precision * std::max(1.0, std::fabs(shown)))
        << intermediate(id).name << ": " << story.formula;
  }
}

/// What the resolve reads or searches for, which words say.
bool isComputed(IntermediateId id) {
  switch (id) {
  case Id::dilatedOffset:
  case Id::dilatedDepth:
  case Id::onScreen:
  case Id::depthEdge:
  case Id::historyRawLength:
  case Id::instability:
  case Id::depthExpected:
  case Id::historyDepth:
  case Id::geometricFlicker:
  case Id::historyObjectId:
  case Id::rejectReason:
  case Id::reference:
  case Id::engineOutput:
    return false;
  default:
    return intermediate(id).stage != Stage::Inputs;
  }
}

/// Rows whose step is off, or whose value is a rule's constant: nothing was computed.
bool isSaidInWords(IntermediateId id, const ProbedPixel& probed) {
  const Settings& s = probed.settings;
  const glm::vec4 value = twin::at(probed.record, id);
  const bool isFirst = probed.details.isFirst;
  switch (id) {
  case Id::dilatedMotion:
    return !isUpsampled(s);
  case Id::historyRaw:
  case Id::historyRectified:
    return isFirst || value == twin::at(probed.record, Id::historyRaw);
  case Id::sampleConfidence:
    return !isUpsampled(s) || s.current.upsample == UpsampleKernel::Hdrp;
  case Id::clipAmount:
  case Id::depthMismatch:
  case Id::velocityChange:
  case Id::alphaDivergence:
  case Id::alphaInvalid:
  case Id::alphaMotion:
  case Id::alphaMask:
  case Id::alphaVelocityChange:
  case Id::sharpenDetail:
  case Id::geometricFlicker:
  case Id::lock:
  case Id::lockLife:
    return value.x == 0.0f || (id == Id::depthMismatch && value.x == 1.0f) ||
           (id == Id::alphaMask && value.x == 1.0f);
  case Id::rectifyStrength:
  case Id::normalAgreement:
  case Id::alphaLumaFlicker:
  case Id::alphaNearClamp:
  case Id::alphaRelax:
  case Id::alphaHistoryContrast:
  case Id::alphaSampleDistance:
  case Id::alphaFlicker:
  case Id::toneWeightCurrent:
  case Id::toneWeightHistory:
  case Id::blurTrust:
    return value.x == 1.0f || (id == Id::rectifyStrength && s.rectify.method == RectifyMethod::None);
  case Id::alphaChannels:
    return s.weight.source != AlphaSource::ContrastPerChannel ||
           twin::at(probed.record, Id::alphaInvalid).x >= 1.0f;
  case Id::referenceError:
  case Id::referenceErrorAbs:
  case Id::relativeError:
    return !twin::isKnown(probed.record, Id::reference);
  case Id::engineDifference:
  case Id::engineDifferenceAbs:
    return !twin::isKnown(probed.record, Id::engineOutput);
  default:
    return taa::isOverTime(id) || taa::needsPixelsAround(id); // of what is not the pixel's own
  }
}

int checkPixel(Inspector& inspector, const glm::ivec2& pixel, const std::string& where) {
  const twin::PixelRecord record = inspector.probes().probe(pixel.x, pixel.y);
  const twin::Details details = inspector.probes().details(pixel.x, pixel.y);
  const ProbedPixel probed{record, details, inspector.shot().settings(), inspector.shot().info(), pixel};
  int formulas = 0;
  for (const Intermediate& row : kIntermediates) {
    const IntermediateId id = row.id;
    const RowStory story = storyOf(id, probed, 9);
    const std::string place = where + " " + std::string(row.name);
    EXPECT_FALSE(story.words.empty()) << place;
    expectTrue(story, probed, place);
    if (story.formula.empty()) {
      EXPECT_FALSE(isComputed(id) && !isSaidInWords(id, probed)) << place << ": " << story.words;
      continue;
    }
    ++formulas;
    EXPECT_TRUE(holds(story.formula)) << place << ": " << story.formula;
    expectEndsWithTheValue(id, story, probed);
  }
  return formulas;
}

} // namespace

TEST_F(ProbeStoryTest, EveryFormulaGivesTheValueOfItsRowWithEveryPreset) {
  std::mt19937 random(15);
  const auto anyPixel = [&random] {
    return glm::ivec2(static_cast<int>(random() % taa::test::small::kWidth),
                      static_cast<int>(random() % taa::test::small::kHeight));
  };
  auto inspector = opened();
  for (const Preset& preset : wholePresets()) {
    inspector->shot().setSettings(preset.settings);
    for (const int frame : {0, 3, 4}) {
      inspector->shot().seek(frame);
      for (int count = frame == 0 ? 2 : 5; count > 0; --count) {
        const std::string where = preset.id + " frame " + std::to_string(frame);
        EXPECT_GT(checkPixel(*inspector, anyPixel(), where), 15) << where;
      }
    }
  }
}

TEST_F(ProbeStoryTest, EveryChoiceOfAStageIsToldWithItsOwnFormula) {
  auto inspector = opened();
  inspector->shot().seek(6);
  for (const char* path :
       {"weight.source", "weight.motion", "weight.mask", "weight.sampleDistance", "blend.length",
        "blend.tone", "space.color", "space.tone", "rectify.method", "neighborhood.shape", "neighborhood.box",
        "neighborhood.weights", "current.filter", "current.sharpen", "weight.flickerScale", "history.filter",
        "output.sharpen", "validate.velocity", "reproject.method"})
    for (std::size_t choice = 0; choice < parameter(path).choices.size(); ++choice) {
      Settings settings;
      for (const char* on : {"weight.lumaFlicker=on", "weight.nearClamp=on", "weight.historyContrast=on",
                             "neighborhood.motionGamma=on", "neighborhood.contrastGamma=on"})
        applyAssignment(settings, on);
      parameter(path).set(settings, static_cast<double>(choice));
      inspector->shot().setSettings(settings);
      const std::string where = std::string(path) + "=" + std::string(parameter(path).choices[choice].id);
      checkPixel(*inspector, {30, 11}, where);
      checkPixel(*inspector, {26, 7}, where);
    }
}

TEST_F(ProbeStoryTest, WhatIsDrawnSmallerIsToldSampleBySample) {
  auto inspector = opened();
  inspector->shot().seek(5);
  for (std::size_t choice = 0; choice < parameter("current.upsample").choices.size(); ++choice) {
    Settings settings;
    applyAssignment(settings, "inputs.renderScale=0.5");
    applyAssignment(settings, "current.sharpen=laplacian");
    parameter("current.upsample").set(settings, static_cast<double>(choice));
    inspector->shot().setSettings(settings);
    for (const glm::ivec2 pixel : {glm::ivec2(30, 11), glm::ivec2(27, 8), glm::ivec2(2, 20)})
      checkPixel(*inspector, pixel, "upsample " + std::to_string(choice));
  }
}

TEST_F(ProbeStoryTest, WhatIsOffAtFirstIsToldWhenItIsOn) {
  auto inspector = opened();
  for (const std::vector<const char*>& on :
       {std::vector{"rectify.locks=on", "rectify.instability=on"},
        {"history.bilinearAtEdges=on", "history.dering=on"},
        {"output.motionBlur=on", "output.sharpen=laplacian"},
        {"output.sharpen=logarithm", "output.dering=on"},
        {"validate.normal=on", "validate.velocity=vector", "validate.action=raiseAlpha"},
        {"weight.divergence=on", "weight.velocityChange=on", "weight.mask=responsive"},
        {"weight.source=contrastPerChannel", "weight.motion=doubled"},
        {"weight.source=contrastPerChannel", "blend.tone=luma"},
        {"weight.source=contrastPerChannel", "blend.tone=whitePoint", "blend.white=0.5"},
        {"space.color=yCoCgAsPrinted", "space.tone=linear", "rectify.method=clamp"},
        {"space.color=yCoCgAsPrinted", "space.tone=logarithm", "rectify.method=clipToCenter"},
        {"neighborhood.shape=varying", "neighborhood.unjitter=on", "neighborhood.weights=luma"},
        {"neighborhood.shape=pairs", "neighborhood.weights=distance", "neighborhood.resolutionGamma=on"},
        {"neighborhood.motionGamma=on", "neighborhood.resolutionGamma=on"},
        {"rectify.method=clipToBoth", "space.color=yCbCr"},
        {"rectify.method=select", "rectify.relaxAtRest=on", "rectify.minStrength=0.5"},
        {"rectify.method=select", "rectify.locks=on", "neighborhood.unjitter=on"},
        {"history.precision=unorm8", "history.dither=on", "weight.frameRate=on"},
        {"history.precision=unorm10", "blend.tone=none"},
        {"history.dither=on", "blend.tone=reinhardChannel"},
        {"history.dither=on", "blend.tone=maxChannel", "rectify.method=rayToCurrent"},
        {"history.precision=full", "neighborhood.maskRelax=on", "weight.mask=reactive"},
        {"blend.restart=blurred"}}) {
    Settings settings;
    std::string where;
    for (const char* assignment : on)
      applyAssignment(settings, assignment), where += std::string(assignment) + " ";
    inspector->shot().setSettings(settings);
    inspector->shot().seek(9);
    for (const glm::ivec2 pixel : {glm::ivec2(30, 11), glm::ivec2(24, 8), glm::ivec2(20, 14)})
      checkPixel(*inspector, pixel, where);
  }
}

TEST_F(ProbeStoryTest, ErrorsAgainstTheReferenceAreDifferencesOfWhatIsShown) {
  auto inspector = opened();
  inspector->shot().seek(3);
  const auto told = [&](IntermediateId id) {
    const twin::PixelRecord record = inspector->probes().probe(24, 8);
    const twin::Details details = inspector->probes().details(24, 8);
    return storyOf(id, {record, details, inspector->shot().settings(), inspector->shot().info(), {24, 8}}, 9);
  };
  EXPECT_EQ(told(IntermediateId::referenceError).words, "there is no reference yet");
  inspector->reference().refine(4);
  checkPixel(*inspector, {24, 8}, "with a reference");
  EXPECT_NE(told(IntermediateId::referenceError).formula, "");
  EXPECT_NE(told(IntermediateId::referenceErrorAbs).formula, "");
  EXPECT_NE(told(IntermediateId::relativeError).formula, "");
}

TEST_F(ProbeStoryTest, WordsOfAlphaSayWhatRaisedIt) {
  twin::PixelRecord record{};
  const twin::Details details;
  Settings settings;
  const auto set = [&](IntermediateId id, float value) { twin::at(record, id).x = value; };
  for (const IntermediateId damping : {IntermediateId::alphaLumaFlicker, IntermediateId::alphaNearClamp,
                                       IntermediateId::alphaHistoryContrast, IntermediateId::alphaRelax,
                                       IntermediateId::alphaSampleDistance, IntermediateId::alphaFlicker})
    set(damping, 1.0f);
  set(IntermediateId::alphaBase, 0.125f);
  set(IntermediateId::alphaFloor, 0.1f);
  set(IntermediateId::alphaMotion, 0.2f);
  set(IntermediateId::speed, 4.2f);
  set(IntermediateId::alpha, 0.3f);
  settings.weight.motion = MotionAlpha::Linear;
  const RowStory raised = storyOf(IntermediateId::alpha, {record, details, settings, {}, {}});
  EXPECT_NE(raised.words.find("raised by motion of 4.2 px"), std::string::npos) << raised.words;
  EXPECT_EQ(raised.formula, "") << "what was not traced has none";
}

TEST_F(ProbeStoryTest, WhatThePrintedWayBackCutsOffIsTold) {
  twin::PixelRecord record{};
  twin::Details details;
  Settings settings;
  settings.space = {ColorSpace::YCoCgAsPrinted, ToneSpace::Linear};
  settings.rectify.method = RectifyMethod::Clamp;
  const glm::vec3 wall = twin::toBox({4.0f, 2.0f, 0.5f}, settings.space);
  details.isFirst = false;
  twin::Trace trace;
  for (int i = 0; i < 3; ++i)
    trace.rectifiedBox[static_cast<std::size_t>(i)] = {.value = static_cast<double>(wall[i])};
  details.trace = std::make_shared<const twin::Trace>(trace);
  twin::at(record, IntermediateId::historyRaw) = glm::vec4(8.0f, 2.0f, 0.5f, 0.0f);
  twin::at(record, IntermediateId::historyRectified) = glm::vec4(twin::fromBox(wall, settings.space), 0.0f);
  twin::at(record, IntermediateId::rectifyStrength).x = 1.0f;
  const auto told = [&] {
    return storyOf(IntermediateId::historyRectified, {record, details, settings, {}, {}});
  };
  EXPECT_EQ(told().formula, "clamp((4, 2, 0.5), 0, 1) = (1, 1, 0.5)");
  EXPECT_EQ(told().subject, "compressed as in the box");
  settings.space.color = ColorSpace::YCoCg;
  EXPECT_EQ(told().subject, "in box space");
}
