// Formulas of whole pixels: what the settings make of α, and that every row's gives its value, under presets
// and random settings.
#include "core/settings/Presets.h"
#include "core/taa/twin/Traced.h"
#include "tests/support/FormulaChecks.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/Variants.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

using namespace taa;
using Id = IntermediateId;

namespace {

Settings plainAlpha(MotionAlpha motion) {
  Settings settings;
  settings.weight.source = AlphaSource::HistoryLength;
  settings.weight.minimum = 0.1f;
  settings.weight.motion = motion;
  settings.weight.motionSpeed = 64.0f;
  settings.validate.depth = Switch::Off;
  settings.rectify.method = RectifyMethod::None;
  return settings;
}

struct Checked {
  int formulas = 0;
  std::string first; ///< that is another than its row
};

/// All rows of a pixel, as a reader of nine digits would work them out.
void check(const twin::Inputs& frame, const test::Variant& variant, const glm::ivec2& pixel, Checked& out,
           FormulaDepth depth = FormulaDepth::Rows) {
  const twin::Trace trace = twin::traceOf(frame, variant.settings, pixel);
  for (const Intermediate& row : kResolveRows)
    for (int channel = 0; channel < row.channels; ++channel) {
      const double value = trace.of(row.id)[static_cast<std::size_t>(channel)].value;
      if (!std::isfinite(value)) continue;
      ++out.formulas;
      const auto difference =
          test::differenceOfFormula(trace, row.id, channel, value, variant.settings, depth);
      if (difference && out.first.empty())
        out.first = std::string(row.name) + " of " + variant.name + " at " + std::to_string(pixel.x) + " " +
                    std::to_string(pixel.y) + ": " + *difference;
    }
}

} // namespace

class FormulasTest : public test::ResolveTest {
 protected:
  /// Of a pixel with seven frames of history whose surface came from 3.2 px to the left.
  static std::string alphaText(const Settings& settings, Id id, bool unfolds = true,
                               FormulaDepth depth = FormulaDepth::Rows) {
    const test::FrameShape shape = test::shapeFor(settings, {24, 14, Precision::Full, Precision::Full, {}});
    twin::Inputs frame = rested(shape, settings, 3);
    for (int y = 0; y < 14; ++y)
      for (int x = 0; x < 24; ++x) {
        frame.historySurface.at(x, y)[0] = 7.0f;
        frame.motion.at(x, y)[0] = 3.2f;
      }
    return explanation::formulaText(twin::traceOf(frame, settings, {12, 7}), id, 0,
                                    {.unfolds = unfolds, .depth = depth});
  }
};

TEST_F(FormulasTest, TellsAlphaAsTheSettingsMakeIt) {
  EXPECT_EQ(alphaText(plainAlpha(MotionAlpha::None), Id::alphaBase), "1 / (7 + 1)");
  EXPECT_EQ(alphaText(plainAlpha(MotionAlpha::None), Id::alpha), "max(0.125, 0.1)");
  EXPECT_EQ(alphaText(plainAlpha(MotionAlpha::Linear), Id::alphaMotion), "3.2 / 64");
  EXPECT_EQ(alphaText(plainAlpha(MotionAlpha::Linear), Id::alpha), "1 − (1 − max(0.125, 0.1)) × (1 − 0.05)");
  EXPECT_EQ(alphaText(plainAlpha(MotionAlpha::Added), Id::alpha), "max(0.125, 0.1) + 0.05");
  EXPECT_EQ(alphaText(plainAlpha(MotionAlpha::Linear), Id::alpha, false), "0.1687")
      << "what it is before the mask and rejection asked for more";
}

// "How was α made, as far as this stage goes?" and "of which numbers at all?"
TEST_F(FormulasTest, AreWrittenAsDeepAsAsked) {
  const Settings settings = plainAlpha(MotionAlpha::Linear);
  EXPECT_EQ(alphaText(settings, Id::alpha, true, FormulaDepth::Stage),
            "1 − (1 − max(1 / (7 + 1), 0.1)) × (1 − 3.2 / 64)");
  EXPECT_EQ(alphaText(settings, Id::alpha, true, FormulaDepth::Samples),
            "1 − (1 − max(1 / (7 + 1), 0.1)) × (1 − √(3.2^2) / 64)");
}

TEST_F(FormulasTest, GiveTheValueHoweverDeep) {
  std::mt19937 random(5);
  for (const FormulaDepth depth : {FormulaDepth::Stage, FormulaDepth::Samples}) {
    Checked all;
    for (const Preset& preset : wholePresets()) {
      test::Variant variant{preset.id, preset.settings};
      variant.settings.history.dither = Switch::Off;
      const test::FrameShape shape =
          test::shapeFor(variant.settings, {48, 27, Precision::Full, Precision::Full, {}});
      twin::Inputs frame = rested(shape, variant.settings, 7);
      frame.resolved = frame.historyColor;
      for (int count = 0; count < 2; ++count)
        check(frame, variant, {static_cast<int>(random() % 48), static_cast<int>(random() % 27)}, all, depth);
    }
    EXPECT_EQ(all.first, "");
    EXPECT_GT(all.formulas, 3000);
  }
}

TEST_F(FormulasTest, OfEveryRowGivesItsValue) {
  std::vector<test::Variant> variants;
  for (const Preset& preset : wholePresets()) variants.push_back({preset.id, preset.settings});
  for (std::uint32_t seed = 0; seed < 40; ++seed)
    variants.push_back({"random " + std::to_string(seed), test::randomSettings(seed)});
  std::mt19937 random(4);
  Checked all;
  for (test::Variant& variant : variants) {
    // What dithering chooses is said beside the formula.
    variant.settings.history.dither = Switch::Off;
    const test::FrameShape shape =
        test::shapeFor(variant.settings, {48, 27, Precision::Full, Precision::Full, {}});
    twin::Inputs frame = rested(shape, variant.settings, 7);
    for (std::size_t i = 0; i < frame.motion.pixels.size(); ++i)
      frame.motion.pixels[i] = static_cast<float>(random() % 100) * 0.07f - 3.0f;
    frame.resolved = frame.historyColor;
    for (int count = 0; count < 20; ++count)
      check(frame, variant, {static_cast<int>(random() % 48), static_cast<int>(random() % 27)}, all);
  }
  EXPECT_EQ(all.first, "");
  EXPECT_GT(all.formulas, 50000);
}
