// What the CPU twin shows of a resolved picture (manual §18, 14.4; invariant 62).
#include "tests/support/frames/TwinInputs.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Random.h"
#include "core/taa/twin/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

namespace taa::twin {
namespace {

using Nine = std::array<glm::vec3, 9>;

constexpr Sharpen kSharpens[] = {Sharpen::LumaRatio, Sharpen::Laplacian, Sharpen::Unsharp,    Sharpen::Rcas,
                                 Sharpen::InResolve, Sharpen::Logarithm, Sharpen::Reconstruct};

Nine filled(const glm::vec3& color) {
  Nine nine;
  nine.fill(color);
  return nine;
}

Nine impulse(float around, float center) {
  Nine nine = filled(glm::vec3(around));
  nine[4] = glm::vec3(center);
  return nine;
}

Nine randomNine(std::mt19937& random, float brightest) {
  std::uniform_real_distribution<float> level(0.0f, brightest);
  Nine nine;
  for (glm::vec3& color : nine) color = {level(random), level(random), level(random)};
  return nine;
}

OutputSettings with(Sharpen sharpen, float amount) {
  return {.sharpen = sharpen, .amount = amount};
}

float sharpened(Sharpen sharpen, float amount, const Nine& c) {
  return taa::twin::sharpen(with(sharpen, amount), c, c).x;
}

TEST(TwinOutput, ConstantsStayExactlyWhateverTheAmount) {
  for (const Sharpen method : kSharpens)
    for (const float amount : {0.0f, 0.1f, 0.5f, 1.0f, 4.0f})
      for (const float level : {0.0f, 1e-7f, 1e-4f, 0.3f, 1.0f, 1000.0f, 65504.0f}) {
        const glm::vec3 color(level, 0.7f * level, 0.1f * level);
        EXPECT_EQ(sharpen(with(method, amount), filled(color), filled(color)), color)
            << static_cast<int>(method) << " " << amount << " " << level;
      }
}

TEST(TwinOutput, AmountZeroIsTheIdentity) {
  std::mt19937 random(1);
  for (const Sharpen method : kSharpens)
    for (int i = 0; i < 100; ++i) {
      const Nine c = randomNine(random, i % 2 == 0 ? 1.0f : 60000.0f);
      EXPECT_EQ(sharpen(with(method, 0.0f), c, randomNine(random, 2.0f)), c[4]) << static_cast<int>(method);
    }
}

TEST(TwinOutput, NoneIsTheColorItself) {
  std::mt19937 random(2);
  const Nine c = randomNine(random, 10.0f);
  EXPECT_EQ(sharpen(with(Sharpen::None, 4.0f), c, c), c[4]);
}

// Techniques: 18.3.
TEST(TwinOutput, LinearOnesAddTheirDifferenceToTheMean) {
  const Nine c = impulse(1.0f, 2.0f);
  EXPECT_EQ(sharpened(Sharpen::Laplacian, 0.5f, c), 2.5f);          // 2 + ½(2 − 1)
  EXPECT_EQ(sharpened(Sharpen::Unsharp, 0.5625f, c), 2.5f);         // 2 + 9/16 · (2 − 10/9)
  EXPECT_FLOAT_EQ(sharpened(Sharpen::LumaRatio, 0.5625f, c), 2.5f); // the same for grays
  EXPECT_EQ(sharpened(Sharpen::Laplacian, 4.0f, impulse(1.0f, 0.5f)), 0.0f) << "not below black";
}

// Techniques: 18.1.
TEST(TwinOutput, LumaRatioKeepsTheHueAndBlack) {
  Nine c = filled({0.1f, 0.2f, 0.3f});
  c[4] = {0.4f, 0.2f, 0.1f};
  const glm::vec3 result = sharpen(with(Sharpen::LumaRatio, 1.0f), c, c);
  EXPECT_GT(result.x, c[4].x);
  EXPECT_FLOAT_EQ(result.y / result.x, c[4].y / c[4].x);
  EXPECT_FLOAT_EQ(result.z / result.x, c[4].z / c[4].x);
  const float mean = (luma(c[4]) + 8.0f * luma(c[0])) / 9.0f;
  EXPECT_NEAR(luma(result), 2.0f * luma(c[4]) - mean, 1e-6f);
  EXPECT_EQ(sharpened(Sharpen::LumaRatio, 1.0f, impulse(1.0f, 0.0f)), 0.0f) << "D8: no 0/0";
}

TEST(TwinOutput, RcasStaysWithinItsRange) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const Nine c = randomNine(random, i % 2 == 0 ? 1.0f : 1000.0f);
    const glm::vec3 center = compress(c[4], ToneSpace::MaxChannel);
    const glm::vec3 result = sharpen(with(Sharpen::Rcas, 4.0f), c, c);
    // As its range is 0 to 1 once compressed, the result is a color: neither cut at black nor overflown.
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_GE(result[channel], 0.0f);
      EXPECT_LE(compress(result, ToneSpace::MaxChannel)[channel], 1.0f);
    }
    // lobe ≤ 3/16: e grows by no more than 3/16 Σ(e − n) / (1 − 3/4).
    float most = 0.0f;
    for (const std::size_t k : {1u, 3u, 5u, 7u})
      most += std::fabs(center.x - compress(c[k], ToneSpace::MaxChannel).x);
    const float step = std::fabs(compress(result, ToneSpace::MaxChannel).x - center.x);
    EXPECT_LE(step, 0.75f * most + 1e-5f);
  }
}

// Techniques: 18.5.
TEST(TwinOutput, RcasTakesTheLobeOfTheFormula) {
  // Compressed: center 0.5, ring 0.4. Room 0.4/1.6 = 1/4, headroom (1 − 0.5)/(4 − 1.6) = 0.2083: 3/16 it is.
  const Nine c = impulse(0.4f / 0.6f, 1.0f);
  const float expected = (0.5f - 0.1875f * 1.6f) / (1.0f - 0.75f); // 0.8
  EXPECT_NEAR(sharpened(Sharpen::Rcas, 1.0f, c), expected / (1.0f - expected), 1e-4f);
  const float half = (0.5f - 0.09375f * 1.6f) / (1.0f - 0.375f);
  EXPECT_NEAR(sharpened(Sharpen::Rcas, 0.5f, c), half / (1.0f - half), 1e-5f);
  EXPECT_EQ(sharpened(Sharpen::Rcas, 4.0f, c), sharpened(Sharpen::Rcas, 1.0f, c)) << "1 is the most";
}

// Techniques: 18.6.
TEST(TwinOutput, InTheResolveOnlyBrightens) {
  std::mt19937 random(4);
  for (int i = 0; i < 500; ++i) {
    const Nine c = randomNine(random, 3.0f), current = randomNine(random, 3.0f);
    const glm::vec3 result = sharpen(with(Sharpen::InResolve, 0.5f), c, current);
    for (int channel = 0; channel < 3; ++channel) EXPECT_GE(result[channel], c[4][channel]);
  }
  // Grays over 1 + luma: eight of ½ and one of 3/4 have the mean 19/36, which is 19/17.
  const float expected = 3.0f + 1.5f * (3.0f - 19.0f / 17.0f);
  EXPECT_NEAR(sharpened(Sharpen::InResolve, 0.5f, impulse(1.0f, 3.0f)), expected, 1e-5f);
}

// Techniques: 18.7.
TEST(TwinOutput, LogarithmIsTheFormulaOfIntel) {
  std::mt19937 random(5);
  for (const double k : {0.0, 0.25, 0.5, 1.0, 1.75, 4.0})
    for (int i = 0; i < 200; ++i) {
      const Nine c = randomNine(random, i % 2 == 0 ? 1.0f : 50.0f);
      const auto logarithm = [](float x) { return std::log2(1.0 + static_cast<double>(x)); };
      const double around = logarithm(c[1].x) + logarithm(c[3].x) + logarithm(c[5].x) + logarithm(c[7].x);
      const double exponent = (1.0 + k) * logarithm(c[4].x) - 0.25 * k * around;
      const double expected = std::min(std::exp2(std::max(0.0, exponent)) - 1.0, 65504.0);
      EXPECT_NEAR(static_cast<double>(sharpened(Sharpen::Logarithm, static_cast<float>(k), c)), expected,
                  3e-6 * (1.0 + expected))
          << k;
    }
}

// Techniques: 18.4.
TEST(TwinOutput, ReconstructIsTheCubicAtThePixelsCenters) {
  // k = 3: −½, 2, −½ each way.
  EXPECT_EQ(sharpened(Sharpen::Reconstruct, 3.0f, impulse(0.0f, 1.0f)), 4.0f);
  Nine beside = filled(glm::vec3(1.0f));
  beside[5] = glm::vec3(1.25f); // weight −½ · 2
  EXPECT_EQ(sharpened(Sharpen::Reconstruct, 3.0f, beside), 0.75f);
  Nine corner = filled(glm::vec3(1.0f));
  corner[8] = glm::vec3(2.0f); // ¼
  EXPECT_EQ(sharpened(Sharpen::Reconstruct, 3.0f, corner), 1.25f);
}

TEST(TwinOutput, DeringingLeavesNothingOutsideTheNine) {
  std::mt19937 random(6);
  for (const Sharpen method : kSharpens)
    for (int i = 0; i < 100; ++i) {
      const Nine c = randomNine(random, 5.0f);
      OutputSettings settings = with(method, 4.0f);
      settings.dering = Switch::On;
      const glm::vec3 result = sharpen(settings, c, c);
      glm::vec3 low = c[0], high = c[0];
      for (const glm::vec3& color : c) {
        low = minimum(low, color);
        high = maximum(high, color);
      }
      EXPECT_EQ(result, clamped(result, low, high)) << static_cast<int>(method);
    }
}

Inputs movingRamp(const glm::vec2& motion) {
  Inputs inputs = test::constantInputs(64, 5, glm::vec3(0.0f));
  inputs.resolved = Image(64, 5, 3);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 64; ++x) {
      test::setColor(inputs.color, x, y, glm::vec3(static_cast<float>(x)));
      test::setColor(inputs.resolved, x, y, glm::vec3(1000.0f));
      inputs.motion.at(x, y)[0] = motion.x;
      inputs.motion.at(x, y)[1] = motion.y;
    }
  return inputs;
}

Settings withBlur() {
  Settings settings;
  settings.output.motionBlur = Switch::On;
  return settings;
}

// Techniques: 14.4.
TEST(TwinOutput, TrustsTheResolvedColorBySpeed) {
  const auto trust = [](const glm::vec2& motion) {
    return showOutput(movingRamp(motion), withBlur(), {32, 2}).trust;
  };
  EXPECT_EQ(trust({0.0f, 0.0f}), 1.0f);
  EXPECT_EQ(trust({0.0f, 2.0f}), 1.0f);
  EXPECT_EQ(trust({8.5f, 0.0f}), 0.5f);
  EXPECT_EQ(trust({-9.0f, 12.0f}), 0.0f);
  EXPECT_EQ(trust({65504.0f, 65504.0f}), 1.0f) << "no motion is known";
  EXPECT_EQ(trust({std::nanf(""), 20.0f}), 1.0f);
  EXPECT_EQ(showOutput(movingRamp({20.0f, 0.0f}), Settings{}, {32, 2}).trust, 1.0f) << "off";
}

// Techniques: 14.4.
TEST(TwinOutput, BlursThisFrameAlongHalfTheMotion) {
  // Seven taps v/6 apart around the pixel: of a ramp their mean is the pixel, moved by the start of the taps,
  // which is less than half of v/6.
  Inputs inputs = movingRamp({24.0f, 0.0f});
  float least = 100.0f, most = 0.0f;
  for (inputs.frame = 0; inputs.frame < 64; ++inputs.frame) {
    const float shown = showOutput(inputs, withBlur(), {32, 2}).color.x;
    least = std::fmin(least, shown);
    most = std::fmax(most, shown);
  }
  EXPECT_GE(least, 30.0f);
  EXPECT_LE(most, 34.0f);
  EXPECT_GT(most - least, 3.0f) << "the start wanders from frame to frame";
  const Inputs half = movingRamp({8.5f, 0.0f});
  EXPECT_NEAR(showOutput(half, withBlur(), {32, 2}).color.x, 0.5f * (1000.0f + 32.0f), 0.4f);
}

TEST(TwinOutput, BlursAsFarInThePictureWhateverIsDrawn) {
  Inputs inputs = movingRamp({24.0f, 0.0f});
  Settings settings = withBlur();
  settings.inputs.renderScale = 0.5f;
  inputs.outputPx = {128, 10};
  inputs.resolved = Image(128, 10, 3);
  float least = 100.0f, most = 0.0f;
  for (inputs.frame = 0; inputs.frame < 64; ++inputs.frame) {
    const float shown = showOutput(inputs, settings, {64, 4}).color.x; // texel 32.25 − ½
    least = std::fmin(least, shown);
    most = std::fmax(most, shown);
  }
  EXPECT_GE(least, 29.75f); // 24 render px are 48 of the picture, taps again 4 render px apart
  EXPECT_LE(most, 33.75f);
  EXPECT_GT(most - least, 3.0f);
}

TEST(TwinOutput, BlurKeepsConstantsExactly) {
  Inputs inputs = test::constantInputs(16, 16, {0.3f, 1e-4f, 1000.0f});
  inputs.resolved = inputs.color;
  for (float& value : inputs.motion.pixels) value = 7.3f;
  for (int x = 0; x < 16; ++x)
    EXPECT_EQ(showOutput(inputs, withBlur(), {x, 3}).color, glm::vec3(0.3f, 1e-4f, 1000.0f));
}

Settings withDither() {
  Settings settings;
  settings.output.dither = Switch::On;
  return settings;
}

// Manual 20.8; invariant 64: mean 0, variance 1/6, from −1 to 1.
// Techniques: 20.8.
TEST(TwinOutput, ScreenNoiseIsTriangular) {
  double sum = 0.0, squares = 0.0;
  float most = 0.0f;
  constexpr int kSide = 256;
  for (int k = 0; k < kSide * kSide; ++k) {
    const float noise = triangularNoise({k % kSide, k / kSide}, 7);
    sum += static_cast<double>(noise);
    squares += static_cast<double>(noise) * static_cast<double>(noise);
    most = std::fmax(most, std::fabs(noise));
  }
  const double count = kSide * kSide; // standard errors: √(1/6/65536) = 0.0016, √(7/180/65536) = 0.0008
  EXPECT_NEAR(sum / count, 0.0, 0.008);
  EXPECT_NEAR(squares / count, 1.0 / 6.0, 0.004);
  EXPECT_LT(most, 1.0f);
  EXPECT_GT(most, 0.98f);
  EXPECT_NE(triangularNoise({3, 4}, 7), triangularNoise({3, 4}, 8));
}

// Techniques: 20.8.
TEST(TwinOutput, DitherIsAStepOfSquareRoots) {
  Inputs inputs = test::constantInputs(32, 32, glm::vec3(0.0f));
  inputs.resolved = Image(32, 32, 3);
  for (int k = 0; k < 1024; ++k) test::setColor(inputs.resolved, k % 32, k / 32, {0.25f, 0.0f, 4.0f});
  for (int k = 0; k < 1024; ++k) {
    const glm::ivec2 pixel(k % 32, k / 32);
    const float noise = triangularNoise(pixel, inputs.frame);
    const glm::vec3 color = showOutput(inputs, withDither(), pixel).color;
    EXPECT_NEAR(255.0f * (std::sqrt(color.x) - 0.5f), noise, 1e-4f);
    EXPECT_NEAR(255.0f * std::sqrt(color.y), std::fmax(noise, 0.0f), 1e-4f) << "black has no less";
    EXPECT_NEAR(255.0f * (std::sqrt(color.z) - 2.0f), noise, 2e-4f);
  }
  EXPECT_EQ(showOutput(inputs, Settings{}, {3, 4}).color, glm::vec3(0.25f, 0.0f, 4.0f)) << "off";
}

TEST(TwinOutput, IsAskedForInThePixelsOfTheResolvedPicture) {
  Inputs inputs = test::constantInputs(4, 4, glm::vec3(0.5f));
  inputs.outputPx = {8, 8};
  inputs.resolved = Image(8, 8, 3);
  test::setColor(inputs.resolved, 7, 6, {1.0f, 2.0f, 3.0f});
  Settings settings;
  settings.inputs.renderScale = 0.5f;
  EXPECT_EQ(showOutput(inputs, settings, {7, 6}).color, glm::vec3(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(showOutput(inputs, settings, {6, 6}).color, glm::vec3(0.0f));
}

TEST(TwinOutput, IsNothingWithoutAResolvedPicture) {
  const PixelRecord record =
      resolvePixel(test::constantInputs(4, 4, glm::vec3(0.5f)), test::plainSettings(), 1, 1);
  EXPECT_EQ(at(record, IntermediateId::resolved), glm::vec4(0.5f, 0.5f, 0.5f, 0.0f));
  EXPECT_EQ(at(record, IntermediateId::output), glm::vec4(0.0f));
}

} // namespace
} // namespace taa::twin
