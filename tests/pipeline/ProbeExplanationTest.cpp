// What the probe tells: every row has words, and every formula, worked out with the numbers it states, gives
// the value it ends with, which is the row's.
#include "core/explanation/Decisions.h"
#include "core/explanation/FormulaText.h"
#include "core/explanation/RowExplanation.h"
#include "core/explanation/RowsOff.h"
#include "core/settings/Presets.h"
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Known.h"
#include "core/taa/twin/Stages.h"
#include "core/taa/twin/Traced.h"
#include "tests/support/Calculator.h"
#include "tests/support/ExplanationPhrases.h"
#include "tests/support/SmallInspector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace taa;
using ProbeExplanationTest = taa::test::small::InspectorTest;

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
void expectEndsWithTheValue(IntermediateId id, const RowExplanation& explanation, const ProbedPixel& probed) {
  const Values stated = Calculator(explanation.formula.substr(explanation.formula.rfind(" = ") + 3)).result();
  glm::vec4 value = twin::at(probed.record, id);
  double precision = 1e-6;
  if (explanation.subject == "in box space")
    value = glm::vec4(twin::toBox(glm::vec3(value), probed.settings.space), 0.0f);
  if (explanation.subject == "compressed as in the box")
    value = glm::vec4(twin::compress(glm::vec3(value), probed.settings.space.tone), 0.0f);
  if (explanation.subject == "R, as the curve has it") { // before it is stored
    value = glm::vec4(twin::compress(glm::vec3(value), probed.settings.blend), 0.0f);
    precision = probed.settings.history.precision == Precision::Half ? 1e-3 : 1.0 / 255;
  }
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const auto shown = static_cast<double>(value[static_cast<int>(i)]);
    EXPECT_NEAR(stated[i], shown, precision * std::max(1.0, std::fabs(shown)))
        << intermediate(id).name << ": " << explanation.formula;
  }
}

/// A row that the twin computed has a formula, but for history that was kept as it is.
bool isFormulaMissing(const RowExplanation& explanation, IntermediateId id, const ProbedPixel& probed) {
  if (!explanation.formula.empty() || !explanation::isComputed(*probed.details.trace, id)) return false;
  if (isRowOff(id, probed.settings) || (isOfHistory(id) && probed.details.isFirst)) return false;
  if (isOfReference(id)) return false; // told where it is known
  // Of another row it is no more than the number.
  const std::string first = explanation::formulaText(*probed.details.trace, id, 0, {9, id == Id::alpha});
  if (first.find_first_of(" (|") == std::string::npos) return false;
  return id != Id::historyRectified || twin::at(probed.record, id) != twin::at(probed.record, Id::historyRaw);
}

/// Whether anything that was read of the frame is in it.
bool dependsOnPixel(const twin::Trace& trace, const twin::Operand& of) {
  if (of.node == 0) return false;
  const twin::TraceNode& node = trace.at(of);
  return node.operation == twin::Operation::Read ||
         std::ranges::any_of(node.from, [&](const twin::Operand& x) { return dependsOnPixel(trace, x); });
}

/// What is called off is the same in every pixel: the twin makes it of nothing that it read, and nothing that
/// it read decided it.
void expectOffIsConstant(IntermediateId id, const ProbedPixel& probed, const std::string& where) {
  if (!isRowOff(id, probed.settings) || !isTaaOn(probed.settings)) return;
  const twin::Trace& trace = *probed.details.trace;
  const twin::Operand value = trace.of(id)[0];
  const bool isOfItself = value.node != 0 && trace.at(value).operation == twin::Operation::Minus &&
                          trace.at(value).from[0].value == trace.at(value).from[1].value; // less itself
  EXPECT_TRUE(isOfItself || !dependsOnPixel(trace, value)) << where;
  EXPECT_EQ(explanation::decisionTexts(trace, id, probed.settings, 4), std::vector<std::string>()) << where;
}

/// What the depth test found decides about the reason that it gives.
void expectReasonIsDecided(const RowExplanation& explanation, const ProbedPixel& probed,
                           const std::string& where) {
  const auto reason = static_cast<twin::RejectReason>(test::valueOf(probed, Id::rejectReason));
  const bool isOther = test::valueOf(probed, Id::depthMismatch) > test::valueOf(probed, Id::depthAllowed);
  const bool isSaid = std::ranges::any_of(explanation.because, [](const std::string& decision) {
    return decision.starts_with("depth mismatch ") && decision.find(" > depth allowed ") != std::string::npos;
  });
  if (reason == twin::RejectReason::Depth) {
    EXPECT_TRUE(isSaid) << where;
  }
  if (!isOn(probed.settings.validate.depth) || (!isOther && !isOn(probed.settings.validate.flicker))) {
    EXPECT_FALSE(isSaid) << where << ": a test that does not run decides nothing";
  }
}

int checkPixel(Inspector& inspector, const glm::ivec2& pixel, const std::string& where) {
  const twin::PixelRecord record = inspector.probes().probe(pixel.x, pixel.y);
  const twin::Details details = inspector.probes().details(pixel.x, pixel.y);
  const ProbedPixel probed{record, details, inspector.shot().settings(), inspector.shot().info(), pixel};
  int formulas = 0;
  for (const Intermediate& row : kIntermediates) {
    const IntermediateId id = row.id;
    const RowExplanation explanation = explainRow(id, probed, FormulaDepth::Rows, 9);
    const std::string place = where + " " + std::string(row.name);
    EXPECT_FALSE(explanation.words.empty()) << place;
    expectTrue(id, explanation, probed, place);
    if (!isTaaOn(probed.settings) && (id == Id::alpha || id == Id::currentFiltered)) {
      EXPECT_TRUE(explanation.words.starts_with("TAA is off")) << place << ": " << explanation.words;
    }
    test::expectDecisionsHold(explanation, probed, place);
    expectOffIsConstant(id, probed, place);
    if (id == Id::rejectReason) expectReasonIsDecided(explanation, probed, place);
    EXPECT_FALSE(isFormulaMissing(explanation, id, probed)) << place << ": " << explanation.words;
    if (explanation.formula.empty()) continue;
    ++formulas;
    EXPECT_TRUE(holds(explanation.formula)) << place << ": " << explanation.formula;
    expectEndsWithTheValue(id, explanation, probed);
  }
  return formulas;
}

} // namespace

TEST_F(ProbeExplanationTest, EveryFormulaGivesTheValueOfItsRowWithEveryPreset) {
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
        EXPECT_GT(checkPixel(*inspector, anyPixel(), where), frame == 0 || !isTaaOn(preset.settings) ? 8 : 10)
            << where;
      }
    }
  }
}

TEST_F(ProbeExplanationTest, EveryChoiceOfAStageIsToldWithItsOwnFormula) {
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

TEST_F(ProbeExplanationTest, WhatIsDrawnSmallerIsToldSampleBySample) {
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

TEST_F(ProbeExplanationTest, WhatIsOffAtFirstIsToldWhenItIsOn) {
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

TEST_F(ProbeExplanationTest, ErrorsAgainstTheReferenceAreDifferencesOfWhatIsShown) {
  auto inspector = opened();
  inspector->shot().seek(3);
  const auto told = [&](IntermediateId id) {
    const twin::PixelRecord record = inspector->probes().probe(24, 8);
    const twin::Details details = inspector->probes().details(24, 8);
    return explainRow(id, {record, details, inspector->shot().settings(), inspector->shot().info(), {24, 8}},
                      FormulaDepth::Rows, 9);
  };
  EXPECT_EQ(told(IntermediateId::referenceError).words, "there is no reference yet");
  inspector->reference().refine(4);
  checkPixel(*inspector, {24, 8}, "with a reference");
  EXPECT_NE(told(IntermediateId::referenceError).formula, "");
  EXPECT_NE(told(IntermediateId::referenceErrorAbs).formula, "");
  EXPECT_NE(told(IntermediateId::relativeError).formula, "");
}

TEST_F(ProbeExplanationTest, WhatThePrintedWayBackCutsOffIsTold) {
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
    return explainRow(IntermediateId::historyRectified, {record, details, settings, {}, {}});
  };
  EXPECT_EQ(told().formula, "clamp((4, 2, 0.5), 0, 1) = (1, 1, 0.5)");
  EXPECT_EQ(told().subject, "compressed as in the box");
  settings.space.color = ColorSpace::YCoCg;
  EXPECT_EQ(told().subject, "in box space");
}
