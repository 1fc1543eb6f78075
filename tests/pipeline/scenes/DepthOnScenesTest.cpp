// The depth test on the built-in scenes: what it costs in flicker, what it does against ghosts, and where a
// wire hides the background.
#include "core/inspect/Inspector.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace taa {
namespace {

Settings balanced(const std::vector<std::string>& assignments = {}) {
  Settings settings = preset("balanced").settings;
  for (const std::string& assignment : assignments) applyAssignment(settings, assignment);
  return settings;
}

constexpr int kPeriod = 16; ///< frames after which the jitter repeats

class FlickerOnScenes : public test::GlTest, public testing::WithParamInterface<const char*> {
 protected:
  static constexpr int kWidth = 192, kHeight = 108;

  static float shown(const float* color) {
    const auto encoded = [](float x) {
      x = std::clamp(x, 0.0f, 1.0f);
      return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
    };
    return 0.2126f * encoded(color[0]) + 0.7152f * encoded(color[1]) + 0.0722f * encoded(color[2]);
  }

  struct Sums {
    double sum = 0.0, squares = 0.0;
    bool isAtRest = true;
  };

  /// Of each lane: mean over the pixels at rest of the standard deviation over a period of the jitter.
  static std::vector<double> flicker(const std::string& scene, const std::vector<Settings>& lanes) {
    Inspector inspector;
    inspector.shot().setCheckpointBudget(0);
    inspector.shot().setSize(kWidth, kHeight);
    inspector.shot().setLanes(lanes);
    inspector.shot().open("builtin:" + scene);
    inspector.shot().setCamera("still");
    std::vector<std::vector<Sums>> sums(lanes.size(), std::vector<Sums>(std::size_t{kWidth} * kHeight));
    inspector.shot().seek(5);
    for (int frame = 0; frame < kPeriod; ++frame) {
      inspector.shot().advance();
      const Image motion = inspector.views().image(IntermediateId::motion);
      for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
        const Image output = inspector.views().image(IntermediateId::output, static_cast<int>(lane));
        for (std::size_t i = 0; i < sums[lane].size(); ++i) {
          Sums& of = sums[lane][i];
          const double value = static_cast<double>(shown(&output.pixels[i * 3]));
          of.sum += value;
          of.squares += value * value;
          of.isAtRest = of.isAtRest && motion.pixels[2 * i] == 0.0f && motion.pixels[2 * i + 1] == 0.0f;
        }
      }
    }
    std::vector<double> means;
    for (const std::vector<Sums>& lane : sums) means.push_back(meanDeviation(lane));
    return means;
  }

  static double meanDeviation(const std::vector<Sums>& pixels) {
    double sum = 0.0, count = 0.0;
    for (const Sums& of : pixels) {
      if (!of.isAtRest) continue;
      const double mean = of.sum / kPeriod;
      sum += std::sqrt(std::max(0.0, of.squares / kPeriod - mean * mean));
      ++count;
    }
    return sum / count;
  }
};

// The default preset does not flicker for its depth test: at rest no more than a tenth above what it does
// without.
TEST_P(FlickerOnScenes, OfTheDefaultPresetIsNotTheDepthTests) {
  const std::vector<double> means = flicker(GetParam(), {balanced(), balanced({"validate.depth=off"})});
  EXPECT_GT(means[1], 0.0);
  EXPECT_LE(means[0], 1.1 * means[1]);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FlickerOnScenes,
                         testing::Values("fan", "fence", "disocclusion", "cut", "thin", "text", "fireflies",
                                         "lights", "foliage", "gallery", "glass", "fog", "crowd"));

class DepthOnScenes : public test::GlTest {
 protected:
  static void open(Inspector& inspector, const std::string& scene, const std::vector<Settings>& lanes) {
    inspector.shot().setCheckpointBudget(0);
    inspector.shot().setSize(320, 180);
    inspector.shot().setLanes(lanes);
    inspector.shot().open("builtin:" + scene);
  }
};

// A wire of builtin:fence at 4.70 m, between neighbors at 75 and 59 m, whose history is 55 m deep.
TEST_F(DepthOnScenes, AWireDoesNotTakeTheColorOfWhatIsFarBehindIt) {
  Inspector inspector;
  open(inspector, "fence",
       {balanced({"validate.flicker=off", "validate.depthFootprint=square3x3"}), balanced()});
  inspector.shot().seek(20);
  EXPECT_NEAR(*inspector.views().image(IntermediateId::depthExpected).at(45, 87), 4.70f, 0.01f);
  for (const int lane : {0, 1}) {
    EXPECT_LT(*inspector.views().image(IntermediateId::depthAllowed, lane).at(45, 87), 0.1f);
    const Image mismatch = inspector.views().image(IntermediateId::depthMismatch, lane);
    const Image reason = inspector.views().image(IntermediateId::rejectReason, lane);
    const Image flicker = inspector.views().image(IntermediateId::geometricFlicker, lane);
    // Ground at the horizon may recede by its own depth in a texel; nothing is farther off and yet the same.
    for (std::size_t i = 0; i < mismatch.pixels.size(); ++i)
      EXPECT_FALSE(mismatch.pixels[i] > 1.0f && reason.pixels[i] == 0.0f && flicker.pixels[i] == 0.0f) << i;
  }
}

// Boards that uncover a wall: no worse than the depth test was that rejected wherever depth differed in the
// four texels to the right and below, at rest too.
TEST_F(DepthOnScenes, GhostsAreNoWorseForIt) {
  constexpr int kFirst = 24, kFrames = 4, kSamples = 16;
  constexpr double kBefore = 34.30; // dB
  Inspector inspector;
  open(inspector, "disocclusion", {balanced(), balanced({"validate.depth=off"})});
  inspector.shot().seek(kFirst - 1);
  double with = 0.0, without = 0.0;
  for (int frame = 0; frame < kFrames; ++frame) {
    inspector.shot().advance();
    inspector.reference().refine(kSamples);
    with += inspector.reference().error(0).psnr / kFrames;
    without += inspector.reference().error(1).psnr / kFrames;
  }
  EXPECT_GE(with, kBefore);
  EXPECT_GT(with, without + 0.9) << "what the depth test is for";
}

} // namespace
} // namespace taa
