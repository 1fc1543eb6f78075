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

constexpr std::size_t kVariants = 10, kPixels = 20; ///< of each scene
constexpr std::size_t kFewPixels = 3;               ///< of every variant
constexpr glm::ivec2 kSize{96, 54};

class FormulasOnScenesTest : public test::GlTest, public testing::WithParamInterface<std::size_t> {
 protected:
  /// At random pixels of the scene, under each of the variants.
  void check(const std::vector<test::Variant>& variants, std::size_t pixels) {
    if (!isExact()) GTEST_SKIP() << "this driver rounds its own way";
    const std::string scene = "builtin:" + std::string(builtinScenes()[GetParam()].id);
    Inspector inspector;
    inspector.shot().setSize(kSize.x, kSize.y);
    inspector.shot().open(scene);
    inspector.shot().seek(5);
    const Settings own = inspector.shot().settings();
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    for (test::Variant variant : variants) {
      variant.settings.jitter = own.jitter;
      variant.settings.inputs = own.inputs;
      variant.settings.history.dither = Switch::Off;  // what it chooses is said beside the formula
      inspector.shot().setSettings(variant.settings); // on the history at hand
      for (std::size_t count = 0; count < pixels; ++count)
        checkPixel(inspector, {static_cast<int>(random() % kSize.x), static_cast<int>(random() % kSize.y)},
                   scene + " with " + variant.name);
    }
    EXPECT_GT(formulas_, 10000);
  }
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

std::vector<test::Variant> allVariants() {
  std::vector<test::Variant> all = test::presetsAndChoices();
  for (test::Variant& variant : test::randomCombinations()) all.push_back(std::move(variant));
  return all;
}

} // namespace

// Every scene has others.
TEST_P(FormulasOnScenesTest, GiveTheValuesOfTheShader) {
  const std::vector<test::Variant> all = allVariants();
  std::vector<test::Variant> variants;
  for (std::size_t i = 0; i < kVariants; ++i) variants.push_back(all[(GetParam() + i * 37) % all.size()]);
  check(variants, kPixels);
}

// All of them on all scenes, which takes an hour: what only meets there is found here alone.
TEST_P(FormulasOnScenesTest, GiveThemUnderPresetsChoicesAndRandomCombinations) {
  check(allVariants(), kFewPixels);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FormulasOnScenesTest, testing::Range<std::size_t>(0, 13));
