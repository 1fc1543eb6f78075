// The noise that is added to the shaded color (invariants 4 and 64).
#include "core/render/passes/NoisePass.h"
#include "core/taa/twin/Random.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace taa {
namespace {

constexpr int kSize = 64, kFrames = 64;

class NoiseTest : public test::GlTest {
 protected:
  /// The noise of each pixel of frames 0 to kFrames − 1, in the unit of its amount.
  static std::vector<float> noiseOf(InputNoise noise, Switch triangular, float level = 0.5f) {
    InputSettings settings;
    settings.noise = noise;
    settings.noiseTriangular = triangular;
    settings.noiseAmount = 2.0f;
    NoisePass pass;
    const shared::FrameBlock block{}; // colors are kept in 32 bits
    const gl::Buffer frame(sizeof(block), &block, "frame");
    Image flat(kSize, kSize, 4);
    std::ranges::fill(flat.pixels, level);
    std::vector<float> all;
    for (int number = 0; number < kFrames; ++number) {
      FrameInputs out;
      out.info.frame = number;
      out.color = gl::Texture({kSize, kSize}, gl::Format::RGBA32F, "flat");
      out.color.upload(flat);
      pass.draw(settings, frame, out);
      const Image drawn = out.color.download();
      for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
          EXPECT_EQ(drawn.at(x, y)[0], drawn.at(x, y)[2]) << "gray noise";
          all.push_back((drawn.at(x, y)[0] - level) * 127.5f);
        }
    }
    return all;
  }
};

struct Moments {
  double mean = 0.0, variance = 0.0, lowest = 1e9, highest = -1e9;
};

Moments momentsOf(const std::vector<float>& values, std::size_t first, std::size_t step) {
  Moments m;
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t i = first; i < values.size(); i += step, ++count) {
    const auto value = static_cast<double>(values[i]);
    m.mean += value;
    squares += value * value;
    m.lowest = std::min(m.lowest, value);
    m.highest = std::max(m.highest, value);
  }
  m.mean /= static_cast<double>(count);
  m.variance = squares / static_cast<double>(count) - m.mean * m.mean;
  return m;
}

// Techniques: 20.3.
TEST_F(NoiseTest, HasTheMomentsOfItsForm) {
  for (const InputNoise noise : {InputNoise::Gradient, InputNoise::Blue, InputNoise::White}) {
    const Moments uniform = momentsOf(noiseOf(noise, Switch::Off), 0, 1);
    EXPECT_NEAR(uniform.mean, 0.0, 0.002);
    EXPECT_NEAR(uniform.variance, 1.0 / 12.0, 0.002);
    EXPECT_GE(uniform.lowest, -0.5001); // what is added to ½ is rounded
    EXPECT_LE(uniform.highest, 0.5001);
    const Moments triangular = momentsOf(noiseOf(noise, Switch::On), 0, 1);
    EXPECT_NEAR(triangular.mean, 0.0, 0.002);
    EXPECT_NEAR(triangular.variance, 1.0 / 6.0, 0.004);
    EXPECT_GE(triangular.lowest, -1.0001);
    EXPECT_LE(triangular.highest, 1.0001);
    EXPECT_GT(triangular.highest, 0.9);
  }
}

// A pixel sees both noises of the pair change over the frames, and not together.
// Techniques: 20.2.
TEST_F(NoiseTest, AveragesToNothingInEachPixelOverTime) {
  for (const InputNoise noise : {InputNoise::Gradient, InputNoise::Blue}) {
    const std::vector<float> all = noiseOf(noise, Switch::On);
    const std::size_t frame = static_cast<std::size_t>(kSize) * kSize;
    double worst = 0.0;
    Moments mean;
    for (std::size_t pixel = 0; pixel < frame; ++pixel) {
      const Moments m = momentsOf(all, pixel, frame);
      worst = std::max(worst, std::abs(m.mean));
      mean.variance += m.variance / static_cast<double>(frame);
    }
    EXPECT_LT(worst, 0.05) << "white noise: σ = 0.051 after 64 frames, the largest of 4096 about 0.18";
    EXPECT_NEAR(mean.variance, 1.0 / 6.0, 0.01);
  }
}

// The same 13 bits of a hash that what is stored is rounded with, of two other channels.
// Techniques: 20.4.
TEST_F(NoiseTest, IsWhiteByTheHashOfPixelAndFrame) {
  const std::vector<float> all = noiseOf(InputNoise::White, Switch::On);
  for (const int frame : {0, 5, 63})
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const std::size_t at =
            (static_cast<std::size_t>(frame) * kSize + static_cast<std::size_t>(y)) * kSize +
            static_cast<std::size_t>(x);
        const auto bits = twin::randomBits({x, y}, frame, 5) + twin::randomBits({x, y}, frame, 6);
        ASSERT_NEAR(all[at], (static_cast<float>(bits) + 1.0f) / 8192.0f - 1.0f, 1e-4f);
      }
}

// Invariant 4: u(1, 0), u(0, 1) and u(1, 1) of frame 0.
// Techniques: 20.1.
TEST_F(NoiseTest, IsJimenezGradient) {
  const std::vector<float> all = noiseOf(InputNoise::Gradient, Switch::Off);
  EXPECT_NEAR(all[0], -0.5, 1e-4);
  EXPECT_NEAR(all[1], 0.555713 - 0.5, 1e-4);
  EXPECT_NEAR(all[kSize], 0.309269 - 0.5, 1e-4);
  EXPECT_NEAR(all[kSize + 1], 0.864983 - 0.5, 1e-4);
}

// Techniques: 20.4.
TEST_F(NoiseTest, LeavesNothingBelowBlack) {
  for (const float value : noiseOf(InputNoise::Blue, Switch::On, 0.0f)) ASSERT_GE(value, 0.0f);
}

} // namespace
} // namespace taa
