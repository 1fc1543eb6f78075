// The resolve in GLSL against its CPU twin: every intermediate of whole frames, bit for bit on llvmpipe.
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using taa::test::FrameShape;
using taa::test::Variant;

namespace {

std::vector<taa::Image> twinImages(taa::twin::Inputs inputs, const taa::Image& resolved,
                                   const taa::Settings& settings) {
  inputs.resolved = resolved;
  std::vector<taa::Image> images;
  for (const taa::Intermediate& row : taa::kResolveRows)
    images.emplace_back(inputs.outputWidth(), inputs.outputHeight(), row.channels);
  for (int y = 0; y < inputs.outputHeight(); ++y)
    for (int x = 0; x < inputs.outputWidth(); ++x) {
      const taa::twin::PixelRecord record = taa::twin::resolvePixel(inputs, settings, x, y);
      for (std::size_t row = 0; row < images.size(); ++row)
        for (int channel = 0; channel < images[row].channels; ++channel)
          images[row].at(x, y)[channel] = record[row][channel];
    }
  return images;
}

bool hasOnlyNumbers(const taa::twin::Inputs& frame) {
  const auto isFinite = [](float value) { return std::isfinite(value); };
  return std::ranges::all_of(frame.color.pixels, isFinite) &&
         std::ranges::all_of(frame.motion.pixels, isFinite);
}

} // namespace

class TwinTest : public taa::test::ResolveTest {
 protected:
  // Random frames hold many pixels within rounding of a threshold, where a GPU may decide the other way and
  // everything after it differs: there, one value in a hundred may. A wild frame has NaN and infinity in its
  // pixels: the other decision may read them, or not.
  static void expectTwin(const taa::twin::Inputs& frame, const FrameShape& shape, const Variant& variant,
                         const std::string& what) {
    const taa::test::Exposed exposed = expose(frame, shape, variant.settings);
    const std::vector<taa::Image> twin =
        twinImages(frame, exposed.at(taa::IntermediateId::resolved), variant.settings);
    for (const taa::Intermediate& row : taa::kResolveRows) {
      const taa::Image& expected = twin[static_cast<std::size_t>(row.id)];
      taa::test::Limits limits = taa::test::limitsOf(isExact(), row.tolerance);
      limits.mayLoseFinite = !isExact() && !hasOnlyNumbers(frame);
      const std::string differs = taa::test::difference(exposed.at(row.id), expected, limits);
      EXPECT_EQ(differs, "") << row.name << " of " << what << " with " << variant.name;
      // Everything after the first difference follows from it.
      if (!differs.empty()) return;
    }
  }

  static void expectTwin(const Variant& variant, std::uint32_t seed) {
    FrameShape shape = taa::test::shapeFor(variant.settings);
    shape.inputs = seed % 2 ? taa::Precision::Half : taa::Precision::Full;
    expectTwin(taa::test::randomFrame(shape, seed, false), shape, variant, "a random frame");
    expectTwin(taa::test::randomFrame(shape, seed + 1000, true), shape, variant, "a wild frame");
    taa::twin::Inputs first = taa::test::randomFrame(shape, seed + 2000, true);
    first.historyColor = {};
    first.historySurface = {};
    expectTwin(first, shape, variant, "a first frame");
  }
};

class TwinOfVariants : public TwinTest, public testing::WithParamInterface<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Part, TwinOfVariants, testing::Range(std::size_t{0}, taa::test::kParts));

TEST_P(TwinOfVariants, AgreesWithEachChoiceAlone) {
  auto seed = static_cast<std::uint32_t>(GetParam());
  for (const Variant& variant : taa::test::partOf(taa::test::presetsAndChoices(), GetParam()))
    expectTwin(variant, ++seed);
}

TEST_P(TwinOfVariants, AgreesWithRandomCombinations) {
  std::uint32_t seed = 100;
  for (const Variant& variant : taa::test::partOf(taa::test::randomCombinations(), GetParam()))
    expectTwin(variant, ++seed);
}

// Boxes that are upside down, and history that is read off its place, with each way to go on from there.
TEST_P(TwinOfVariants, AgreesWithFaultsInEachPreset) {
  std::vector<Variant> variants;
  for (const taa::Preset& preset : taa::wholePresets()) {
    variants.push_back({preset.id + " with faults", preset.settings});
    for (const char* assignment : {"fault.boxCorners=on", "fault.historyJitter=on"})
      taa::applyAssignment(variants.back().settings, assignment);
  }
  auto seed = static_cast<std::uint32_t>(900 + GetParam());
  for (const Variant& variant : taa::test::partOf(variants, GetParam())) expectTwin(variant, ++seed);
}

// What one choice alone does not reach: taps beyond the next texel, slabs of every space, samples applied in
// part.
TEST_F(TwinTest, AgreesWhereShapesAndMethodsMeetOthers) {
  std::uint32_t seed = 40;
  for (const std::vector<const char*>& assignments :
       {std::vector{"neighborhood.shape=varying", "neighborhood.unjitter=on", "neighborhood.weights=luma"},
        {"neighborhood.shape=varying", "neighborhood.weights=distance", "inputs.renderScale=0.67"},
        {"neighborhood.shape=varying", "rectify.method=clipToHull", "neighborhood.chromaShrink=on"},
        {"neighborhood.shape=pairs", "neighborhood.unjitter=on", "inputs.renderScale=0.5"},
        {"rectify.method=clipToBoth", "space.color=rgb"},
        {"rectify.method=clipToBoth", "space.color=yCoCgLifting", "neighborhood.unjitter=on"},
        {"rectify.method=clipToBoth", "space.color=yCbCr", "neighborhood.shape=varying"},
        {"rectify.method=select", "space.color=yCbCr", "rectify.relaxAtRest=on"},
        {"rectify.method=select", "neighborhood.unjitter=on", "rectify.locks=on"},
        {"neighborhood.resolutionGamma=on", "neighborhood.contrastGamma=on",
         "neighborhood.motionGamma=on"}}) {
    Variant variant;
    for (const char* assignment : assignments) taa::applyAssignment(variant.settings, assignment);
    variant.name = taa::test::flags(variant.settings);
    expectTwin(variant, ++seed);
  }
}
