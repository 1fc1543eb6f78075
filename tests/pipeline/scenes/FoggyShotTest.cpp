// Fog through the whole pipeline: what TAA makes of its bands and its noise, and an 8-bit history of both
// (source 001, "improving banding").
#include "core/settings/Parameters.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/Frames.h"

#include <glm/vec2.hpp>

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
  /// Pixels all around which the beam that rests hides a fifth of the wall or more; they have no edges.
  static std::vector<glm::ivec2> insideOfTheBeam() {
    Settings settings = with({"inputs.fogSteps=0"});
    test::Player player("builtin:fog", "gltf:front", kWidth, kHeight, settings);
    player.draw();
    const Image fog = player.inputs().fog.download(), color = player.inputs().color.download();
    std::vector<glm::ivec2> inside;
    for (int y = 1; y + 1 < kHeight; ++y)
      for (int x = 1; x < kLeftHalf; ++x) {
        bool isInside = true;
        for (int k = 0; k < 9; ++k) {
          const glm::ivec2 at(x + k % 3 - 1, y + k / 3 - 1);
          isInside = isInside && fog.at(at.x, at.y)[3] > 0.2f && color.at(at.x, at.y)[0] < 1.0f;
        }
        if (isInside) inside.emplace_back(x, y);
      }
    return inside;
  }
  /// Root of the mean squared difference there.
  double rmse(const Image& a, const Image& b) const {
    double sum = 0.0;
    for (const glm::ivec2& pixel : inside_)
      for (int channel = 0; channel < 3; ++channel) {
        const double difference = static_cast<double>(a.at(pixel.x, pixel.y)[channel]) -
                                  static_cast<double>(b.at(pixel.x, pixel.y)[channel]);
        sum += difference * difference;
      }
    return std::sqrt(sum / (3.0 * static_cast<double>(inside_.size())));
  }

  /// Values there that are a whole number of steps of 8 bits.
  double shareOfLevels(const Image& image) const {
    double count = 0.0;
    for (const glm::ivec2& pixel : inside_)
      for (int channel = 0; channel < 3; ++channel) {
        const float steps = 255.0f * image.at(pixel.x, pixel.y)[channel];
        count += std::abs(steps - std::round(steps)) < 1e-3f ? 1.0 : 0.0;
      }
    return count / (3.0 * static_cast<double>(inside_.size()));
  }

  void SetUp() override {
    GlTest::SetUp();
    inside_ = insideOfTheBeam();
  }

  std::vector<glm::ivec2> inside_;
};

// The source's figure as numbers: how far a frame is from the same one with the fog's integral.
// Techniques: 20.4.
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
  ASSERT_GT(inside_.size(), 100u);
  RecordProperty("bands", std::to_string(bands));
  RecordProperty("still", std::to_string(still));
  RecordProperty("moving", std::to_string(moving));
  RecordProperty("white", std::to_string(white));
  EXPECT_LT(moving, 0.5 * bands);
  EXPECT_LT(moving, 0.5 * still);
  EXPECT_LT(moving, white);
}

// Manual 20.6: what α = 0.1 changes by less than half a step of 8 bits stays where it is, within 5 steps
// of its goal: smooth fog lies in bands. Rounded at random it moves on, and its mean comes nearer.
// Techniques: 20.6.
TEST_F(FoggyShotTest, AnEightBitHistoryStopsInBandsUnlessItIsDithered) {
  constexpr int kFirst = 24, kLast = 55;
  const auto mean = [](const char* precision, const char* dither, const char* steps) {
    return meanOf(with({precision, dither, steps}), kFirst, kLast);
  };
  const char* const kDithered = "history.dither=on";
  const char* const kPlain = "history.dither=off";
  const Image truth = mean("history.precision=full", kPlain, "inputs.fogSteps=0");
  const Image half = mean("history.precision=half", kPlain, "inputs.fogSteps=64");
  const Image rounded = mean("history.precision=unorm8", kPlain, "inputs.fogSteps=64");
  const Image dithered = mean("history.precision=unorm8", kDithered, "inputs.fogSteps=64");
  EXPECT_GT(rmse(rounded, truth), 4.0 * rmse(half, truth));
  EXPECT_LT(rmse(dithered, truth), 0.8 * rmse(rounded, truth));
  EXPECT_GT(shareOfLevels(rounded), 0.25) << "did not move in 32 frames";
  EXPECT_LT(shareOfLevels(dithered), 0.08) << "one in 32 by chance";
  EXPECT_LT(shareOfLevels(half), 0.03);
}

} // namespace
} // namespace taa
