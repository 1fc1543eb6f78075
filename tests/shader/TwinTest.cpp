// The resolve in GLSL against its CPU twin: every intermediate of whole frames, bit for bit on llvmpipe.
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/support/frames/Frames.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/Variants.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using taa::test::FrameShape;
using taa::test::Variant;

class TwinTest : public taa::test::ResolveTest {
 protected:
  static void expectTwin(const taa::twin::Inputs& frame, const FrameShape& shape, const Variant& variant,
                         const std::string& what) {
    const auto rows = taa::test::resolveRows(expose(frame, shape, variant.settings));
    EXPECT_EQ(taa::test::differenceFromTwin(frame, variant.settings, rows, isExact()), "")
        << what << " with " << variant.name;
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
