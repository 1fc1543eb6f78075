// What the probe tells: every row has words, and every formula, worked out with the numbers it states, gives
// the value it ends with, which is the row's.
#include "core/inspect/ProbeStory.h"
#include "core/settings/Presets.h"
#include "core/taa/reference/Color.h"
#include "tests/support/SmallInspector.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

using namespace taa;
using ProbeStoryTest = taa::test::small::InspectorTest;

namespace {

/// A number or a tuple; arithmetic is channel by channel, a number goes with each.
using Values = std::vector<double>;

/// Reads the arithmetic that ProbeStory.h describes.
class Calculator {
 public:
  explicit Calculator(const std::string& text) : text_(text) {
    replace("−", "-");
    replace("×", "*");
    replace("√", "sqrt");
  }
  Values result() {
    const Values value = sum();
    skip();
    EXPECT_EQ(place_, text_.size()) << "left over in " << text_;
    return value;
  }

 private:
  void replace(const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text_.find(from, at)) != std::string::npos; at += to.size())
      text_.replace(at, from.size(), to);
  }
  void skip() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
  }
  bool take(char character) {
    skip();
    if (place_ >= text_.size() || text_[place_] != character) return false;
    ++place_;
    return true;
  }
  template <typename Operation>
  static Values apply(const Values& a, const Values& b, Operation operation) {
    const std::size_t count = std::max(a.size(), b.size());
    Values result(count);
    for (std::size_t i = 0; i < count; ++i)
      result[i] = operation(a[a.size() == 1 ? 0 : i], b[b.size() == 1 ? 0 : i]);
    return result;
  }
  Values sum() {
    Values value = product();
    for (;;) {
      if (take('+'))
        value = apply(value, product(), std::plus<>());
      else if (take('-'))
        value = apply(value, product(), std::minus<>());
      else
        return value;
    }
  }
  Values product() {
    Values value = power();
    for (;;) {
      if (take('*'))
        value = apply(value, power(), std::multiplies<>());
      else if (take('/'))
        value = apply(value, power(), std::divides<>());
      else
        return value;
    }
  }
  Values power() {
    if (take('-')) return apply({0.0}, power(), std::minus<>());
    const Values base = atom();
    if (!take('^')) return base;
    return apply(base, atom(), [](double a, double b) { return std::pow(a, b); });
  }
  std::vector<Values> arguments() {
    std::vector<Values> list{sum()};
    while (take(',')) list.push_back(sum());
    EXPECT_TRUE(take(')')) << text_.substr(place_);
    return list;
  }
  Values atom() {
    if (take('|')) {
      const Values inside = sum();
      EXPECT_TRUE(take('|'));
      return apply(inside, {0.0}, [](double a, double) { return std::fabs(a); });
    }
    if (take('(')) {
      Values tuple;
      for (const Values& part : arguments()) tuple.insert(tuple.end(), part.begin(), part.end());
      return tuple;
    }
    skip();
    if (place_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[place_])) != 0)
      return called();
    char* end = nullptr;
    const double number = std::strtod(text_.c_str() + place_, &end);
    const std::size_t length = static_cast<std::size_t>(end - text_.c_str()) - place_;
    EXPECT_GT(length, 0u) << "no number at " << text_.substr(place_);
    if (length == 0) place_ = text_.size();
    place_ += length;
    return {number};
  }
  Values called() {
    std::string name;
    while (std::isalpha(static_cast<unsigned char>(text_[place_])) != 0) name += text_[place_++];
    EXPECT_TRUE(take('(')) << name;
    std::vector<Values> list = arguments();
    const auto fold = [&](auto operation) {
      Values value = list.front();
      for (std::size_t i = 1; i < list.size(); ++i) value = apply(value, list[i], operation);
      return value;
    };
    const auto each = [&](auto function) {
      return apply(list.front(), {0.0}, [&](double a, double) { return function(a); });
    };
    if (name == "max") return fold([](double a, double b) { return std::max(a, b); });
    if (name == "min") return fold([](double a, double b) { return std::min(a, b); });
    if (name == "clamp") {
      const Values low = apply(list[0], list[1], [](double a, double b) { return std::max(a, b); });
      return apply(low, list[2], [](double a, double b) { return std::min(a, b); });
    }
    if (name == "sqrt") return each([](double a) { return std::sqrt(a); });
    if (name == "exp") return each([](double a) { return std::exp(a); });
    if (name == "smooth")
      return each([](double a) {
        const double x = std::clamp(a, 0.0, 1.0);
        return x * x * (3 - 2 * x);
      });
    if (name == "length") {
      double squares = 0;
      for (const double part : list.front()) squares += part * part;
      return {std::sqrt(squares)};
    }
    ADD_FAILURE() << "unknown function " << name;
    return {0.0};
  }

  std::string text_;
  std::size_t place_ = 0;
};

/// What storing a color may change.
double storageStep(IntermediateId id, const Settings& settings) {
  if (id != IntermediateId::resolved) return 0.0;
  if (settings.history.precision == Precision::Unorm8) return 1.0 / 255;
  return settings.history.precision == Precision::Unorm10 ? 1.0 / 1023 : 0.0;
}

/// Both sides of the last "=".
void expectHolds(const RowStory& story, double storageStep, const std::string& where) {
  const std::size_t split = story.formula.rfind(" = ");
  ASSERT_NE(split, std::string::npos) << where << ": " << story.formula;
  const Values left = Calculator(story.formula.substr(0, split)).result();
  const Values right = Calculator(story.formula.substr(split + 3)).result();
  ASSERT_EQ(left.size(), right.size()) << where << ": " << story.formula;
  for (std::size_t i = 0; i < left.size(); ++i)
    EXPECT_NEAR(left[i], right[i], storageStep + 2e-3 * std::max(0.05, std::fabs(right[i])))
        << where << ": " << story.formula;
}

/// The value the formula ends with is the row's, or what its subject says.
void expectEndsWithTheValue(IntermediateId id, const RowStory& story, const ProbedPixel& probed) {
  const Values stated = Calculator(story.formula.substr(story.formula.rfind(" = ") + 3)).result();
  glm::vec4 value = reference::at(probed.record, id);
  if (story.subject == "in box space")
    value = glm::vec4(reference::toBox(glm::vec3(value), probed.settings.space), 0.0f);
  if (story.subject == "compressed as in the box")
    value = glm::vec4(reference::compress(glm::vec3(value), probed.settings.space.tone), 0.0f);
  if (story.subject == "R, its highlights bounded" || story.subject == "R, as the curve has it") {
    const glm::vec3 color(value);
    value = glm::vec4(id == IntermediateId::resolved ? reference::compress(color, probed.settings.blend)
                                                     : reference::compress(color, ToneSpace::MaxChannel),
                      0.0f);
  }
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const auto shown = static_cast<double>(value[static_cast<int>(i)]);
    EXPECT_NEAR(stated[i], shown, 1e-6 * std::max(1.0, std::fabs(shown)))
        << intermediate(id).name << ": " << story.formula;
  }
}

/// What the resolve reads or searches for, which words say.
bool isComputed(IntermediateId id) {
  using Id = IntermediateId;
  switch (id) {
  case Id::dilatedOffset:
  case Id::dilatedDepth:
  case Id::onScreen:
  case Id::depthEdge:
  case Id::historyRawLength:
  case Id::instability:
  case Id::depthExpected:
  case Id::historyDepth:
  case Id::historyObjectId:
  case Id::rejectReason:
  case Id::reference:
    return false;
  default:
    return intermediate(id).stage != Stage::Inputs;
  }
}

/// Rows whose step is off, or whose value is a rule's constant: nothing was computed.
bool isSaidInWords(IntermediateId id, const ProbedPixel& probed) {
  using Id = IntermediateId;
  const Settings& s = probed.settings;
  const glm::vec4 value = reference::at(probed.record, id);
  const bool isFirst = probed.details.isFirst;
  switch (id) {
  case Id::dilatedMotion:
    return !isUpsampled(s);
  case Id::historyRaw:
  case Id::historyRectified:
    return isFirst || value == reference::at(probed.record, Id::historyRaw);
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
  case Id::lock:
  case Id::lockLife:
    return value.x == 0.0f || (id == Id::depthMismatch && value.x == 1.0f) ||
           (id == Id::alphaMask && value.x == 1.0f);
  case Id::rectifyStrength:
  case Id::normalAgreement:
  case Id::alphaLumaFlicker:
  case Id::alphaNearClamp:
  case Id::alphaHistoryContrast:
  case Id::alphaSampleDistance:
  case Id::toneWeightCurrent:
  case Id::toneWeightHistory:
  case Id::blurTrust:
    return value.x == 1.0f || (id == Id::rectifyStrength && s.rectify.method == RectifyMethod::None);
  case Id::alphaChannels:
    return s.weight.source != AlphaSource::ContrastPerChannel ||
           reference::at(probed.record, Id::alphaInvalid).x >= 1.0f;
  case Id::referenceError:
  case Id::referenceErrorAbs:
    return !reference::hasValue(probed.record, Id::reference);
  case Id::flicker:
  case Id::deviationOverTime:
  case Id::framesFollowed:
    return true; // of other frames
  default:
    return false;
  }
}

int checkPixel(Inspector& inspector, const glm::ivec2& pixel, const std::string& where) {
  const reference::PixelRecord record = inspector.probe(pixel.x, pixel.y);
  const reference::Details details = inspector.details(pixel.x, pixel.y);
  const ProbedPixel probed{record, details, inspector.settings(), inspector.info(), pixel};
  int formulas = 0;
  for (const Intermediate& row : kIntermediates) {
    const IntermediateId id = row.id;
    const RowStory story = storyOf(id, probed, 9);
    const std::string place = where + " " + std::string(row.name);
    EXPECT_FALSE(story.words.empty()) << place;
    if (story.formula.empty()) {
      EXPECT_FALSE(isComputed(id) && !isSaidInWords(id, probed)) << place << ": " << story.words;
      continue;
    }
    ++formulas;
    expectHolds(story, storageStep(id, probed.settings), place);
    expectEndsWithTheValue(id, story, probed);
  }
  return formulas;
}

} // namespace

TEST_F(ProbeStoryTest, EveryFormulaGivesTheValueOfItsRowWithEveryPreset) {
  for (const Preset& preset : wholePresets()) {
    auto inspector = opened({preset.settings});
    for (const int frame : {0, 4}) {
      inspector->seek(frame);
      for (const glm::ivec2 pixel : {glm::ivec2(30, 11), glm::ivec2(24, 8)}) {
        const std::string where = preset.id + " frame " + std::to_string(frame);
        EXPECT_GT(checkPixel(*inspector, pixel, where), 15) << where;
      }
    }
  }
}

TEST_F(ProbeStoryTest, EveryChoiceOfAStageIsToldWithItsOwnFormula) {
  auto inspector = opened();
  inspector->seek(6);
  for (const char* path :
       {"weight.source", "weight.motion", "weight.mask", "weight.sampleDistance", "blend.length",
        "blend.tone", "space.color", "space.tone", "rectify.method", "neighborhood.shape", "neighborhood.box",
        "neighborhood.weights", "current.filter", "current.sharpen", "weight.flickerScale", "history.filter",
        "output.sharpen", "validate.velocity"})
    for (std::size_t choice = 0; choice < parameter(path).choices.size(); ++choice) {
      Settings settings;
      for (const char* on : {"weight.lumaFlicker=on", "weight.nearClamp=on", "weight.historyContrast=on",
                             "neighborhood.motionGamma=on", "neighborhood.contrastGamma=on"})
        applyAssignment(settings, on);
      parameter(path).set(settings, static_cast<double>(choice));
      inspector->setSettings(settings);
      const std::string where = std::string(path) + "=" + std::string(parameter(path).choices[choice].id);
      checkPixel(*inspector, {30, 11}, where);
      checkPixel(*inspector, {26, 7}, where);
    }
}

TEST_F(ProbeStoryTest, WhatIsDrawnSmallerIsToldSampleBySample) {
  auto inspector = opened();
  inspector->seek(5);
  for (std::size_t choice = 0; choice < parameter("current.upsample").choices.size(); ++choice) {
    Settings settings;
    applyAssignment(settings, "inputs.renderScale=0.5");
    applyAssignment(settings, "current.sharpen=laplacian");
    parameter("current.upsample").set(settings, static_cast<double>(choice));
    inspector->setSettings(settings);
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
        {"rectify.method=select", "rectify.relaxAtRest=on", "rectify.leastStrength=0.5"},
        {"rectify.method=select", "rectify.locks=on", "neighborhood.unjitter=on"},
        {"blend.restart=blurred"}}) {
    Settings settings;
    std::string where;
    for (const char* assignment : on)
      applyAssignment(settings, assignment), where += std::string(assignment) + " ";
    inspector->setSettings(settings);
    inspector->seek(9);
    for (const glm::ivec2 pixel : {glm::ivec2(30, 11), glm::ivec2(24, 8), glm::ivec2(20, 14)})
      checkPixel(*inspector, pixel, where);
  }
}

TEST_F(ProbeStoryTest, ErrorsAgainstTheReferenceAreDifferencesOfWhatIsShown) {
  auto inspector = opened();
  inspector->seek(3);
  const auto told = [&](IntermediateId id) {
    const reference::PixelRecord record = inspector->probe(24, 8);
    const reference::Details details = inspector->details(24, 8);
    return storyOf(id, {record, details, inspector->settings(), inspector->info(), {24, 8}}, 9);
  };
  EXPECT_EQ(told(IntermediateId::referenceError).words, "there is no reference yet");
  inspector->refineReference(4);
  checkPixel(*inspector, {24, 8}, "with a reference");
  EXPECT_NE(told(IntermediateId::referenceError).formula, "");
  EXPECT_NE(told(IntermediateId::referenceErrorAbs).formula, "");
}

TEST_F(ProbeStoryTest, AlphaIsToldAsTheSettingsMakeIt) {
  reference::PixelRecord record{};
  reference::Details details;
  Settings settings;
  const auto set = [&](IntermediateId id, float value) { reference::at(record, id).x = value; };
  for (const IntermediateId calm : {IntermediateId::alphaLumaFlicker, IntermediateId::alphaNearClamp,
                                    IntermediateId::alphaHistoryContrast, IntermediateId::alphaRelax,
                                    IntermediateId::alphaSampleDistance})
    set(calm, 1.0f);
  set(IntermediateId::historyKeptLength, 7.0f);
  set(IntermediateId::alphaBase, 0.125f);
  set(IntermediateId::alphaFloor, 0.1f);
  set(IntermediateId::alpha, 0.125f);
  const ProbedPixel probed{record, details, settings, {}, {}};
  EXPECT_EQ(storyOf(IntermediateId::alpha, probed).formula, "max(1 / (7 + 1), 0.1) = 0.125");
  set(IntermediateId::alphaMotion, 0.2f);
  set(IntermediateId::speed, 4.2f);
  set(IntermediateId::alpha, 0.3f);
  settings.weight.motion = MotionAlpha::Linear;
  const RowStory raised = storyOf(IntermediateId::alpha, probed);
  EXPECT_EQ(raised.formula, "1 − (1 − (max(1 / (7 + 1), 0.1))) × (1 − 0.2) = 0.3");
  EXPECT_NE(raised.words.find("raised by motion of 4.2 px"), std::string::npos) << raised.words;
}

TEST_F(ProbeStoryTest, WhatThePrintedWayBackCutsOffIsTold) {
  reference::PixelRecord record{};
  reference::Details details;
  Settings settings;
  settings.space = {ColorSpace::YCoCgAsPrinted, ToneSpace::Linear};
  settings.rectify.method = RectifyMethod::Clamp;
  const glm::vec3 wall = reference::toBox({4.0f, 2.0f, 0.5f}, settings.space);
  details.isFirst = false;
  details.neighborhood.boxMin = details.neighborhood.boxMax = wall;
  reference::at(record, IntermediateId::historyRaw) = glm::vec4(8.0f, 2.0f, 0.5f, 0.0f);
  const auto told = [&] {
    return storyOf(IntermediateId::historyRectified, {record, details, settings, {}, {}});
  };
  EXPECT_EQ(told().formula, "clamp((4, 2, 0.5), 0, 1) = (1, 1, 0.5)");
  EXPECT_EQ(told().subject, "compressed as in the box");
  settings.space.color = ColorSpace::YCoCg;
  EXPECT_EQ(told().subject, "in box space");
}
