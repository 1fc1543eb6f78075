// What the driver makes of frames against what GLSL allows it: right shaders lie in their ranges, which are
// narrow, and wrong ones do not.
#include "core/probe/Verification.h"

#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/support/ShaderFolder.h"
#include "tests/support/frames/Frames.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/Variants.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace taa;
using test::FrameShape;

namespace {

/// A line of a shader written otherwise, as one mistakes it, under settings that come there.
struct Mutation {
  const char* file; ///< of shaders/
  const char* from; ///< there once
  const char* to;
  std::vector<const char*> assignments{};
};

std::ostream& operator<<(std::ostream& out, const Mutation& mutation) {
  return out << mutation.file << ": " << mutation.from << " -> " << mutation.to;
}

const std::vector<Mutation>& mutations() {
  static const std::vector<Mutation> all{
      {"taa/dilate_motion.glsl", "depth < found : depth > found", "depth < found : depth >= found"},
      {"taa/dilate_motion.glsl",
       "if (kIsX) return k % 2 == 0;",
       "if (kIsX) return k % 2 == 1;",
       {"dilate.method=closestX"}},
      {"taa/dilate_motion.glsl", "kIsClosestX2 ? 2 : 1", "1", {"dilate.method=closestX2"}},
      {"taa/dilate_motion.glsl",
       "motion.x * motion.x + motion.y * motion.y",
       "motion.x * motion.x + motion.x * motion.y",
       {"dilate.method=longest3x3"}},
      {"taa/reproject.glsl", "position = center - motion;", "position = center + motion;"},
      {"taa/reproject.glsl", "center = vec2(pixel) + 0.5;", "center = vec2(pixel);"},
      {"taa/reproject.glsl", "sqrt(motion.x * motion.x + motion.y * motion.y)",
       "max(abs(motion.x), abs(motion.y))"},
      {"taa/sample_history.glsl",
       "precise vec3 result = top + f.y * (bottom - top);",
       "precise vec3 result = top + f.x * (bottom - top);",
       {"history.filter=bilinear"}},
      {"taa/sample_history.glsl", "(-0.5 + f * (1.0 - 0.5 * f))", "(-0.5 + f * (1.0 + 0.5 * f))"},
      {"taa/sample_history.glsl", "(0.5 + f * (2.0 - 1.5 * f))", "(0.5 + f * (2.0 - 1.25 * f))"},
      {"taa/sample_history.glsl",
       "t + ivec2(2, 0), t + ivec2(2, 1)",
       "t + ivec2(1, 0), t + ivec2(1, 1)",
       {"history.filter=catmullRom5"}},
      {"taa/sample_history.glsl",
       "? weighted : weighted / sum",
       "? weighted : weighted",
       {"history.filter=catmullRom5"}},
      {"taa/sample_history.glsl",
       "ivec2(floor(position))).r;\n  if",
       "ivec2(floor(position)) + 1).r;\n  if",
       {"history.length=reprojected"}},
      {"taa/filter_current.glsl",
       "samples.color[4] + sum / total",
       "samples.color[4] + sum / (total + 1e-4)",
       {"current.filter=blackmanHarris"}},
      {"taa/filter_current.glsl",
       "if (k != 4) sum = sum + sampleWeight(samples.color[k], k)",
       "if (k != 4) sum = sum + sampleWeight(samples.color[k], 8 - k)",
       {"current.filter=blackmanHarris"}},
      {"taa/filter_current.glsl",
       "for (int k = 1; k < 9; ++k)\n    if",
       "for (int k = 1; k < 8; ++k)\n    if",
       {"current.filter=blackmanHarris"}},
      {"taa/filter_current.glsl", "f = abs(landed)", "f = 0.99 * abs(landed)", {"current.filter=unjitter"}},
      {"taa/neighborhood.glsl", "difference = boxed[k] - boxed[4]", "difference = boxed[k] - boxed[3]"},
      {"taa/neighborhood.glsl", "sumOfSquares / total - first * first", "sumOfSquares / total"},
      {"taa/neighborhood.glsl", "result.lowest = minimum(boxed[k], result.lowest);", ""},
      {"taa/neighborhood.glsl",
       "return k == 4 || k % 2 == 1; }",
       "return k % 2 == 1; }",
       {"neighborhood.shape=cross"}},
      {"taa/neighborhood.glsl",
       "above = moments.mean + reach",
       "above = moments.mean - reach",
       {"neighborhood.box=variance"}},
      {"taa/neighborhood.glsl",
       "1.0 + 1.5 * maximum(mask.x, mask.y)",
       "1.0 + 0.5 * maximum(mask.x, mask.y)",
       {"neighborhood.maskRelax=on"}},
      {"taa/neighborhood.glsl",
       "0.5 * (nine.lowest + five.lowest)",
       "0.5 * (nine.lowest + nine.lowest)",
       {"neighborhood.shape=rounded"}},
      {"taa/neighborhood.glsl", "* (rest * rest)", "* rest", {"neighborhood.motionGamma=on"}},
      {"taa/compare_depth.glsl", "abs(expected - stored) / expected", "abs(expected - stored) / stored"},
      {"taa/compare_depth.glsl", "DepthTest(match.mismatch > allowed", "DepthTest(match.mismatch < allowed"},
      {"taa/compare_depth.glsl", "isFirst || mismatch < best.mismatch",
       "isFirst || mismatch > best.mismatch"},
      {"taa/compare_depth.glsl", "goesOn = (toA > 0.0) == (toB > 0.0)", "goesOn = true"},
      {"taa/validate_history.glsl",
       "reprojection.speed > settings.validateSpeedLimit",
       "reprojection.speed < settings.validateSpeedLimit",
       {"validate.speed=on"}},
      {"taa/validate_history.glsl", "if (reprojection.isOutside) reason = kRejectReason_offScreen;", ""},
      {"taa/rectify_history.glsl",
       "0.5 * (box.hi - box.lo) + 1e-8",
       "(box.hi - box.lo) + 1e-8",
       {"rectify.method=clipToCenter"}},
      {"taa/rectify_history.glsl",
       "precise float amount = maximum(maximum(entries.x, entries.y), entries.z);",
       "precise float amount = maximum(entries.x, entries.y);",
       {"rectify.method=clipToFiltered"}},
      {"taa/rectify_history.glsl",
       "fromAbove = (hi - history) / toTarget",
       "fromAbove = (lo - history) / toTarget",
       {"rectify.method=clipToFiltered"}},
      {"taa/rectify_history.glsl",
       "precise vec3 color = clamped(history, box.lo, box.hi);",
       "precise vec3 color = maximum(history, box.lo);",
       {"rectify.method=clamp"}},
      {"taa/rectify_history.glsl",
       "toTarget[axis] != 0.0 && hit >= 0.0 && hit < nearest",
       "toTarget[axis] != 0.0 && hit < nearest",
       {"rectify.method=rayToCurrent"}},
      {"taa/rectify_history.glsl",
       "precise vec3 color = kept ? raw.color : corrected;",
       "precise vec3 color = corrected;",
       {"rectify.method=clamp"}},
      {"taa/rectify_history.glsl",
       "saturated(share * share)",
       "saturated(share)",
       {"rectify.relaxAtRest=on"}},
      {"taa/hold_history.glsl",
       "kSimilarRatio = 1.340095640625",
       "kSimilarRatio = 1.2",
       {"rectify.locks=on"}},
      {"taa/blend_weight.glsl",
       "1.0 / (x.historyLength + 1.0)",
       "1.0 / (x.historyLength + 2.0)",
       {"weight.source=historyLength"}},
      {"taa/blend_weight.glsl", "damped = damped * damping.relax;", "", {"neighborhood.maskRelax=on"}},
      {"taa/blend_weight.glsl", "damped = maximum(damped, result.least);", ""},
      {"taa/blend_weight.glsl",
       "precise float result = 1.0 - (1.0 - a) * (1.0 - b);",
       "precise float result = a + b;",
       {"weight.motion=linear"}},
      {"taa/blend_weight.glsl", "0.001 + largest", "0.01 + largest", {"weight.lumaFlicker=on"}},
      {"taa/blend_weight.glsl", "maximum(maximum(alpha, mask), invalid)", "maximum(alpha, mask)"},
      {"taa/blend_weight.glsl", "toWall = minimum(toLow, toHigh)", "toWall = toLow", {"weight.nearClamp=on"}},
      {"taa/blend_weight.glsl",
       "saturated(speed / settings.weightMotionSpeed)",
       "saturated(speed * settings.weightMotionSpeed)",
       {"weight.motion=linear"}},
      {"taa/blend.glsl",
       "current + (1.0 - alpha) * historyWeight",
       "current + alpha * historyWeight",
       {"blend.tone=luma"}},
      {"taa/blend.glsl",
       "((1.0 - alpha) * (1.0 - alpha)) / lengthBefore",
       "(1.0 - alpha) / lengthBefore",
       {"blend.length=variance"}},
      {"taa/blend.glsl", "(bits + 0xFFFu + ((bits >> 13u) & 1u)) & 0xFFFFE000u); // 11",
       "bits & 0xFFFFE000u); // 11"},
      {"taa/sharpen.glsl", "(sum / 9.0) / center", "(sum / 8.0) / center", {"output.sharpen=lumaRatio"}},
      {"taa/sharpen.glsl", "(4.0 - 4.0 * lowest)", "(4.0 - lowest)", {"output.sharpen=rcas"}},
      {"taa/sharpen.glsl",
       "c.color[4] - settings.outputAmount * (crossDifference(c) / 4.0)",
       "c.color[4] + settings.outputAmount * (crossDifference(c) / 4.0)",
       {"output.sharpen=laplacian"}},
      {"taa/upsample.glsl",
       "precise vec2 x = offset / resolveBlock.renderRatio; // px of the picture\n  precise vec2 weights",
       "precise vec2 x = offset * resolveBlock.renderRatio; // px of the picture\n  precise vec2 weights",
       {"current.upsample=lanczos2", "inputs.renderScale=0.5"}},
      {"include/color_spaces.glsl",
       "co = 0.5 * c.r - 0.5 * c.b",
       "co = 0.5 * c.r + 0.5 * c.b",
       {"space.color=yCoCg"}},
      {"include/color_spaces.glsl",
       "b = (c.x - c.y) - c.z",
       "b = (c.x - c.y) + c.z",
       {"space.color=yCoCg", "rectify.method=clamp"}},
      {"include/color_spaces.glsl",
       "divisor = 1.0 + luma(c)",
       "divisor = 1.0 + largestChannel(c)",
       {"space.tone=reinhardLuma"}},
      {"include/tone_curves.glsl", "78.84375 * log2OfRatio(t)", "78.84 * log2OfRatio(t)", {"space.tone=pq"}},
  };
  return all;
}

constexpr FrameShape kShape{.width = 40, .height = 26};

} // namespace

class VerificationTest : public test::ResolveTest {
 protected:
  static std::vector<twin::Inputs> frames(const FrameShape& shape, std::uint32_t seed) {
    return {test::randomFrame(shape, seed, false), test::randomFrame(shape, seed + 1000, true),
            test::stillFrame(shape, seed + 2000)};
  }
};

class VerificationOfVariants : public VerificationTest, public testing::WithParamInterface<std::size_t> {
 protected:
  /// This part of them, each on a frame of its own.
  static void check(const std::vector<test::Variant>& variants, std::uint32_t firstSeed) {
    auto seed = static_cast<std::uint32_t>(firstSeed + 100 * GetParam());
    std::size_t values = 0, open = 0;
    for (const test::Variant& variant : test::partOf(variants, GetParam())) {
      const FrameShape shape = test::shapeFor(variant.settings, kShape);
      const twin::Inputs frame = test::randomFrame(shape, seed, seed % 2 == 0);
      ++seed;
      const std::vector<Image> rows = test::resolveRows(expose(frame, shape, variant.settings));
      const Verification verification = test::verified(frame, variant.settings, rows);
      EXPECT_EQ(test::outsideText(verification), "") << variant.name;
      const RowVerification all = verification.all();
      values += all.values;
      open += all.open;
    }
    EXPECT_LT(open, values / 1000) << "paths that were not all tried";
  }
};
INSTANTIATE_TEST_SUITE_P(Part, VerificationOfVariants, testing::Range(std::size_t{0}, test::kParts));

TEST_P(VerificationOfVariants, FindsNothingOutsideOfPresets) {
  std::vector<test::Variant> variants;
  for (const Preset& preset : wholePresets()) variants.push_back({preset.id, preset.settings});
  check(variants, 5000);
}

// Minutes: what is tested bit by bit on llvmpipe, here on any driver.
TEST_P(VerificationOfVariants, FindsNothingOutsideOfChoicesAndRandomCombinations) {
  std::vector<test::Variant> variants = test::eachChoice();
  for (test::Variant& variant : test::randomCombinations()) variants.push_back(std::move(variant));
  check(variants, 6000);
}

class VerificationOfMutations : public VerificationTest, public testing::WithParamInterface<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Each, VerificationOfMutations, testing::Range(std::size_t{0}, mutations().size()));

TEST_P(VerificationOfMutations, FindsWhatIsWritten) {
  const Mutation& mutation = mutations()[GetParam()];
  Settings settings;
  for (const char* assignment : mutation.assignments) applyAssignment(settings, assignment);
  const FrameShape shape = test::shapeFor(settings, kShape);
  const test::ShaderFolder shaders;
  shaders.replace(mutation.file, mutation.from, mutation.to);
  TaaPass mutated;
  std::size_t outside = 0;
  for (const twin::Inputs& frame : frames(shape, static_cast<std::uint32_t>(GetParam())))
    outside += test::verified(frame, settings, test::resolveRows(expose(frame, shape, settings, &mutated)))
                   .all()
                   .outside;
  EXPECT_GT(outside, 0u) << mutation;
}

// Of what is computed without a quotient the range is one float, so that the next one is outside.
TEST_F(VerificationTest, FindsAValueThatIsOffByALastBit) {
  const Settings settings = test::bareSettings();
  const FrameShape shape = test::shapeFor(settings, kShape);
  const twin::Inputs frame = test::randomFrame(shape, 7, false);
  std::vector<Image> rows = test::resolveRows(expose(frame, shape, settings));
  ASSERT_EQ(test::verified(frame, settings, rows).all().outside, 0u);
  float& value = *rows[static_cast<std::size_t>(IntermediateId::alpha)].at(11, 6);
  value = std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) + 1);
  const Verification verification = test::verified(frame, settings, rows);
  for (const RowVerification& row : verification.rows)
    if (row.id == IntermediateId::alpha) {
      ASSERT_TRUE(row.example);
      EXPECT_EQ(row.example->pixel, glm::ivec2(11, 6));
      EXPECT_EQ(row.example->found, value);
    }
}

// A range says nothing where it is wide. Of colors and weights a GPU may differ from another in few last
// bits.
TEST_F(VerificationTest, HasNarrowRanges) {
  // Medians beyond 8 ulp, and why: differences of quotients, of which each may err by itself.
  const std::map<std::string_view, double> wide{
      {"neighborhoodMean", 40.0},                                 // of nine compressed colors
      {"neighborhoodDeviation", 600.0}, {"depthAllowed", 1000.0}, // of depths around
      {"depthMismatch", 16.0},          {"blendFactor", 24.0},    {"clipAmount", 32.0}}; // of two distances
  const Settings settings;
  const FrameShape shape = test::shapeFor(settings, kShape);
  for (const twin::Inputs& frame : frames(shape, 3)) {
    const std::vector<Image> rows = test::resolveRows(expose(frame, shape, settings));
    for (const RowVerification& row : test::verified(frame, settings, rows).rows) {
      const std::string_view name = intermediate(row.id).name;
      EXPECT_LE(row.medianUlp, wide.contains(name) ? wide.at(name) : 9.0) << name;
    }
  }
}
