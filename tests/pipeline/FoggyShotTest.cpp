// Fog through the whole pipeline: what TAA makes of its bands and its noise, and an 8-bit history of both
// (source 001, "improving banding").
#include "core/settings/Parameters.h"
#include "tests/support/Frames.h"
#include "tests/support/GlTest.h"

#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 96, kHeight = 54;
constexpr int kLeftHalf = 50; ///< where the lamp that rests is

class FoggyShotTest : public test::GlTest {
 protected:
  static Settings with(std::initializer_list<const char*> assignments) {
    Settings settings;
    for (const char* assignment : assignments) applyAssignment(settings, assignment);
    return settings;
  }
  /// Mean of what frames `first` to `last` resolve to.
  static Image meanOf(const Settings& settings, int first, int last) {
    TaaPass pass;
    test::Player player("builtin:fog", "gltf:front", kWidth, kHeight, settings);
    Image mean(kWidth, kHeight, 4);
    for (int frame = 0; frame <= last; ++frame) {
      player.step(pass);
      if (frame < first) continue;
      const Image resolved = player.history().color.download();
      for (std::size_t i = 0; i < mean.pixels.size(); ++i)
        mean.pixels[i] += resolved.pixels[i] / static_cast<float>(last - first + 1);
    }
    return mean;
  }
  /// Root of the mean squared difference around the beam that rests.
  static double rmse(const Image& a, const Image& b) {
    double sum = 0.0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kLeftHalf; ++x)
        for (int channel = 0; channel < 3; ++channel) {
          const double difference =
              static_cast<double>(a.at(x, y)[channel]) - static_cast<double>(b.at(x, y)[channel]);
          sum += difference * difference;
        }
    return std::sqrt(sum / (3.0 * kHeight * kLeftHalf));
  }
};

// The source's figure as numbers: how far a frame is from the same one with the fog's integral.
TEST_F(FoggyShotTest, IsIntegratedFromNoiseThatMovesAndFromNoOther) {
  constexpr int kFrame = 24;
  const Image truth = meanOf(with({"inputs.fogSteps=0"}), kFrame, kFrame);
  const auto error = [&](std::initializer_list<const char*> assignments) {
    return rmse(meanOf(with(assignments), kFrame, kFrame), truth);
  };
  const double bands = error({"inputs.fogNoise=none"});
  const double still = error({"inputs.fogNoise=blueNoise", "inputs.fogAnimated=off"});
  const double moving = error({"inputs.fogNoise=blueNoise"});
  const double white = error({"inputs.fogNoise=whiteNoise"});
  RecordProperty("bands", std::to_string(bands));
  RecordProperty("still", std::to_string(still));
  RecordProperty("moving", std::to_string(moving));
  RecordProperty("white", std::to_string(white));
  EXPECT_LT(moving, 0.5 * bands);
  EXPECT_LT(moving, 0.5 * still);
  EXPECT_LT(moving, white);
}

// Catalogue 20.6: without dither a history of 8 bits stops up to 5 of their steps before its goal at α = 0.1,
// so that what the first frames' noise was stays; rounded at random it does not.
TEST_F(FoggyShotTest, AnEightBitHistoryKeepsItsNoiseUnlessItIsDithered) {
  constexpr int kFirst = 24, kLast = 39; // a period of the jitter
  const Image wanted = meanOf(with({"history.precision=full"}), kFirst, kLast);
  const double rounded = rmse(meanOf(with({"history.precision=unorm8"}), kFirst, kLast), wanted);
  const double dithered =
      rmse(meanOf(with({"history.precision=unorm8", "history.dither=on"}), kFirst, kLast), wanted);
  RecordProperty("rounded", std::to_string(255.0 * rounded));
  RecordProperty("dithered", std::to_string(255.0 * dithered));
  EXPECT_GT(255.0 * rounded, 1.0);
  EXPECT_LT(dithered, 0.3 * rounded);
}

} // namespace
} // namespace taa
