// Formulas of every row against what the GLSL made, at 200 random pixels of every built-in scene, under
// presets and random settings: what a reader of nine digits would work out.
#include "core/scene/builtin/SceneSource.h"
#include "core/taa/twin/Traced.h"
#include "tests/support/FormulaChecks.h"
#include "tests/support/SmallInspector.h"
#include "tests/support/frames/Variants.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace taa;

namespace {

constexpr int kVariants = 10, kPixels = 20; ///< of each scene

class FormulasOnScenesTest : public test::GlTest, public testing::WithParamInterface<std::size_t> {
 protected:
  void checkPixel(Inspector& inspector, const glm::ivec2& pixel, const std::string& where) {
    const twin::PixelRecord record = inspector.probes().probe(pixel.x, pixel.y);
    const twin::Details details = inspector.probes().details(pixel.x, pixel.y);
    const Settings& settings = inspector.shot().settings();
    for (const Intermediate& row : kResolveRows)
      for (int channel = 0; channel < row.channels; ++channel) {
        const double value = twin::at(record, row.id)[channel];
        if (!std::isfinite(value)) continue;
        ++formulas_;
        const auto difference = test::differenceOfFormula(*details.trace, row.id, channel, value, settings);
        EXPECT_FALSE(difference) << row.name << " at " << pixel.x << ' ' << pixel.y << " of " << where << ": "
                                 << difference.value_or("");
      }
  }
  int formulas_ = 0;
};

/// Those of this scene: every scene has others.
std::vector<test::Variant> variantsOfScene(std::size_t scene, const Settings& own) {
  std::vector<test::Variant> all = test::presetsAndChoices(), out;
  for (const test::Variant& variant : test::randomCombinations()) all.push_back(variant);
  for (std::size_t i = 0; i < kVariants; ++i) {
    test::Variant variant = all[(scene + i * 37) % all.size()];
    variant.settings.jitter = own.jitter;
    variant.settings.inputs = own.inputs;
    variant.settings.history.dither = Switch::Off; // what it chooses is said beside the formula
    out.push_back(std::move(variant));
  }
  return out;
}

} // namespace

TEST_P(FormulasOnScenesTest, GiveTheValuesOfTheShader) {
  if (!isExact()) GTEST_SKIP() << "this driver rounds its own way";
  const std::string scene = "builtin:" + std::string(builtinScenes()[GetParam()].id);
  Inspector inspector;
  inspector.shot().setSize(96, 54);
  inspector.shot().open(scene);
  inspector.shot().seek(5);
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  for (const test::Variant& variant : variantsOfScene(GetParam(), inspector.shot().settings())) {
    inspector.shot().setSettings(variant.settings); // on the history at hand
    for (int count = 0; count < kPixels; ++count)
      checkPixel(inspector, {static_cast<int>(random() % 96), static_cast<int>(random() % 54)},
                 scene + " with " + variant.name);
  }
  EXPECT_GT(formulas_, 10000);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FormulasOnScenesTest, testing::Range<std::size_t>(0, 13));
