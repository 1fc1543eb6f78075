// Fog in beams against the geometry of the cones: the integral, the steps, the noise and its history
// (manual 20.4, 20.5; source 001, "improving banding").
#include "core/measure/References.h"
#include "core/render/passes/SceneRenderer.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/FogTruth.h"
#include "tests/support/frames/SmallScene.h"

#include <glm/geometric.hpp>
#include <glm/gtx/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 32, kHeight = 18;
const glm::dvec3 kEyePlace(0.0, 0.0, 10.0);

/// A cone that hangs before a dim wall with a bright card inside it; the node's −z is its axis.
struct Stage {
  Scene scene = test::emptyScene();
  std::vector<test::PlacedCone> cones;
  int card = 0;

  Stage() {
    test::addQuad(scene, {0, 0, -6}, {80, 0, 0}, {0, 40, 0}, test::addColor(scene, {0.2f, 0.3f, 0.4f, 1.0f}));
    card = test::addQuad(scene, {2.5f, 0.5f, 0.5f}, {3, 0, 0}, {0, 2, 0});
  }
  int add(const FogCone& shape, const glm::vec3& apex, const glm::vec3& axis) {
    Node node;
    node.name = "cone";
    node.translation = apex;
    node.rotation = glm::rotation(glm::vec3(0, 0, -1), glm::normalize(axis));
    scene.nodes.push_back(node);
    FogCone cone = shape;
    cone.node = static_cast<int>(scene.nodes.size()) - 1;
    scene.fog.push_back(cone);
    cones.push_back({cone, glm::dvec3(apex), glm::normalize(glm::dvec3(axis))});
    return cone.node;
  }
  static Stage withCone() {
    Stage stage;
    stage.add({.length = 6.0f,
               .startRadius = 0.3f,
               .endRadius = 2.0f,
               .density = 0.35f,
               .light = {0.8f, 0.6f, 0.3f},
               .fading = 0.7f},
              {-2.0f, 3.0f, -1.0f}, {0.55f, -0.75f, 0.3f});
    return stage;
  }
};

class FogTest : public test::GlTest {
 protected:
  static FrameRequest request() {
    FrameRequest request;
    request.camera = test::kEye;
    request.width = kWidth;
    request.height = kHeight;
    request.jitter.sequence = JitterSequence::None;
    request.inputs.precision = Precision::Full;
    request.inputs.fogSteps = 10;
    request.inputs.fogNoise = InputNoise::None;
    return request;
  }
  static SceneRenderer rendererOf(const Scene& scene) {
    return SceneRenderer(std::make_shared<const Scene>(scene));
  }
  static FrameInputs draw(const Scene& scene, const FrameRequest& request, int frame = 0) {
    SceneRenderer renderer = rendererOf(scene);
    FrameInputs inputs;
    renderer.draw(request, frame, inputs);
    return inputs;
  }
  /// The fog of frames 0 to `count` − 1.
  static std::vector<Image> frames(const Scene& scene, const FrameRequest& request, int count) {
    SceneRenderer renderer = rendererOf(scene);
    FrameInputs inputs;
    std::vector<Image> all;
    for (int frame = 0; frame < count; ++frame) {
      renderer.draw(request, frame, inputs);
      all.push_back(inputs.fog.download());
    }
    return all;
  }
  /// Distance along the ray to what is seen at a pixel: the card, or the wall.
  static double surfaceAt(const glm::ivec2& pixel) {
    const glm::dvec3 ray = test::rayThrough(pixel, {kWidth, kHeight});
    const double toCard = (0.5 - 10.0) / ray.z;
    const glm::dvec3 at = kEyePlace + toCard * ray;
    const bool isOnCard = std::abs(at.x - 2.5) < 1.5 && std::abs(at.y - 0.5) < 1.0;
    return isOnCard ? toCard : (-6.0 - 10.0) / ray.z;
  }
  static test::FogTruth truthAt(const test::PlacedCone& cone, const glm::ivec2& pixel) {
    return test::fogTruth(cone, kEyePlace, test::rayThrough(pixel, {kWidth, kHeight}), surfaceAt(pixel));
  }
  template <class Check>
  static void forEachPixel(Check check) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) check(glm::ivec2(x, y));
  }
};

bool sameBits(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

/// −ln(1 − opacity) of a pixel.
double opticalDepth(const Image& fog, const glm::ivec2& pixel) {
  return -std::log(1.0 - static_cast<double>(fog.at(pixel.x, pixel.y)[3]));
}

/// Of the march: a sphere around the cone, from its nearest to its farthest point, in equal steps.
double stepLength(const test::PlacedCone& placed, int steps) {
  const auto length = static_cast<double>(placed.cone.length),
             end = static_cast<double>(placed.cone.endRadius);
  return 2.0 * std::sqrt(0.25 * length * length + end * end) / steps;
}

TEST_F(FogTest, WithoutStepsIsTheIntegralAlongEachRay) {
  const Stage stage = Stage::withCone();
  FrameRequest asked = request();
  asked.inputs.fogSteps = 0;
  const Image fog = draw(stage.scene, asked).fog.download();
  int through = 0;
  forEachPixel([&](const glm::ivec2& pixel) {
    const test::FogTruth truth = truthAt(stage.cones[0], pixel);
    const glm::vec4 got = fog.texel(pixel.x, pixel.y);
    // Both ends of the finely sampled stretch are off by half a part at most: 23 m / 4000 · 0.35/m.
    ASSERT_NEAR(static_cast<double>(got.w), truth.opacity, 0.0021) << pixel.x << ", " << pixel.y;
    for (int channel = 0; channel < 3; ++channel)
      ASSERT_NEAR(static_cast<double>(got[channel]), truth.light[channel], 0.0021);
    through += truth.length > 0.5;
  });
  EXPECT_GT(through, 30) << "of 576 pixels";
}

// Along cones that lie crosswise, the camera in one of them, from the side and end on: where the quadratic of
// the side turns over.
TEST_F(FogTest, IsTheIntegralFromInsideAlongAndAcross) {
  const FogCone shape{.length = 5.0f, .endRadius = 1.5f, .density = 0.2f};
  const std::pair<glm::vec3, glm::vec3> places[] = {{{0.2f, 0.1f, 12.0f}, {0.05f, 0.02f, -1}},
                                                    {{0.3f, 0.2f, -2.0f}, {0.02f, 0.03f, 1}},
                                                    {{-3.0f, 0.1f, 0.0f}, {1, 0, 0}},
                                                    {{0.1f, 3.0f, 9.5f}, {0, -1, 0}},
                                                    {{0.2f, -0.3f, 6.0f}, {0.0f, 0.0f, -1}}};
  for (const auto& [apex, axis] : places) {
    Stage stage;
    stage.add(shape, apex, axis);
    FrameRequest asked = request();
    asked.inputs.fogSteps = 0;
    const Image fog = draw(stage.scene, asked).fog.download();
    double most = 0.0;
    forEachPixel([&](const glm::ivec2& pixel) {
      const double wanted = truthAt(stage.cones[0], pixel).opacity;
      most = std::max(most, wanted);
      ASSERT_NEAR(static_cast<double>(fog.at(pixel.x, pixel.y)[3]), wanted, 0.003)
          << pixel.x << ", " << pixel.y << ", apex at z = " << apex.z;
    });
    EXPECT_GT(most, 0.05);
  }
}

// Where two cones cross their densities add up: transmittances multiply, whatever lies before what.
TEST_F(FogTest, MultipliesTheTransmittancesOfConesThatCross) {
  Stage stage = Stage::withCone();
  stage.add({.length = 7.0f, .endRadius = 1.2f, .density = 0.5f, .light = {0.1f, 0.2f, 0.9f}}, {3, 3, 0},
            {-0.6f, -0.8f, 0});
  FrameRequest asked = request();
  asked.inputs.fogSteps = 0;
  const Image exact = draw(stage.scene, asked).fog.download();
  asked.inputs.fogSteps = 128;
  const Image marched = draw(stage.scene, asked).fog.download();
  int crossed = 0;
  forEachPixel([&](const glm::ivec2& pixel) {
    const test::FogTruth first = truthAt(stage.cones[0], pixel), second = truthAt(stage.cones[1], pixel);
    const glm::vec4 got = exact.texel(pixel.x, pixel.y), near = marched.texel(pixel.x, pixel.y);
    ASSERT_NEAR(static_cast<double>(got.w), 1.0 - (1.0 - first.opacity) * (1.0 - second.opacity), 0.004);
    for (int channel = 0; channel < 4; ++channel) // 13 m / 128 · 0.85/m, and as much at the other end
      ASSERT_NEAR(got[channel], near[channel], 0.09f);
    crossed += first.length > 0.3 && second.length > 0.3;
  });
  EXPECT_GT(crossed, 10);
}

TEST_F(FogTest, ScalesItsDensityByTheSetting) {
  Stage stage = Stage::withCone();
  FrameRequest asked = request();
  asked.inputs.fogSteps = 0;
  asked.inputs.fogDensity = 2.5f;
  const Image fog = draw(stage.scene, asked).fog.download();
  stage.cones[0].cone.density *= 2.5f;
  forEachPixel([&](const glm::ivec2& pixel) {
    ASSERT_NEAR(static_cast<double>(fog.at(pixel.x, pixel.y)[3]), truthAt(stage.cones[0], pixel).opacity,
                0.006);
  });
}

// The banding of the source's figure: as many levels as steps fit into the cone, and no others.
// Techniques: 20.4.
TEST_F(FogTest, WithoutNoiseHasOneLevelForEachStepInTheCone) {
  const Stage stage = Stage::withCone();
  for (const int steps : {5, 10, 40}) {
    FrameRequest asked = request();
    asked.inputs.fogSteps = steps;
    const Image fog = draw(stage.scene, asked).fog.download();
    const double length = stepLength(stage.cones[0], steps);
    std::set<int> levels;
    std::set<float> values;
    double longest = 0.0;
    forEachPixel([&](const glm::ivec2& pixel) {
      const double count = opticalDepth(fog, pixel) / (0.35 * length);
      const int whole = static_cast<int>(std::lround(count));
      ASSERT_NEAR(count, whole, 2e-4);
      const double inside = truthAt(stage.cones[0], pixel).length;
      ASSERT_LE(std::abs(whole - inside / length), 1.01);
      longest = std::max(longest, inside);
      levels.insert(whole);
      values.insert(fog.at(pixel.x, pixel.y)[3]);
    });
    EXPECT_EQ(levels.size(), values.size()) << "each level is one number";
    EXPECT_EQ(*levels.begin(), 0);
    if (steps <= 10) {
      EXPECT_EQ(*levels.rbegin(), static_cast<int>(levels.size()) - 1) << "none is left out";
    }
    EXPECT_NEAR(*levels.rbegin(), longest / length, 1.01) << "the longest ray has all of them";
  }
}

struct NoiseErrors {
  double ofOneFrame = 0.0, ofMean = 0.0; ///< root of the mean squared error of the optical depth, in steps
};

/// Over pixels whose ray runs through the cone.
NoiseErrors noiseErrors(const std::vector<Image>& frames, const Stage& stage, int steps,
                        const std::vector<double>& truth) {
  const double step = stepLength(stage.cones[0], steps);
  NoiseErrors errors;
  int pixels = 0;
  for (std::size_t at = 0; at < truth.size(); ++at) {
    if (truth[at] == 0.0) continue;
    const glm::ivec2 pixel(static_cast<int>(at) % kWidth, static_cast<int>(at) / kWidth);
    double mean = 0.0;
    for (const Image& frame : frames) {
      const double error = opticalDepth(frame, pixel) / (0.35 * step) - truth[at] / step;
      mean += error / static_cast<double>(frames.size());
      errors.ofOneFrame += error * error / static_cast<double>(frames.size());
    }
    errors.ofMean += mean * mean;
    ++pixels;
  }
  return {std::sqrt(errors.ofOneFrame / pixels), std::sqrt(errors.ofMean / pixels)};
}

// A sample more or less: k is ⌊ℓ/Δ⌋ or ⌈ℓ/Δ⌉, ⌈⌉ as often as the fraction says, so that the mean number is
// that of the integral. One frame is off by √(f(1 − f)), 0.41 over all fractions; 64 frames of white noise by
// an eighth of it.
// Techniques: 20.4.
TEST_F(FogTest, AnimatedNoiseHasTheIntegralsStepsAsItsMeanAndStillNoiseHasNot) {
  const Stage stage = Stage::withCone();
  std::vector<double> truth;
  forEachPixel([&](const glm::ivec2& pixel) { truth.push_back(truthAt(stage.cones[0], pixel).length); });
  const auto errorsOf = [&](InputNoise noise, Switch animated) {
    FrameRequest asked = request();
    asked.inputs.fogNoise = noise;
    asked.inputs.fogAnimated = animated;
    return noiseErrors(frames(stage.scene, asked, 64), stage, asked.inputs.fogSteps, truth);
  };
  for (const InputNoise noise : {InputNoise::White, InputNoise::Gradient, InputNoise::Blue}) {
    const NoiseErrors moving = errorsOf(noise, Switch::On), still = errorsOf(noise, Switch::Off);
    EXPECT_NEAR(moving.ofOneFrame, 0.41, 0.05) << static_cast<int>(noise);
    EXPECT_NEAR(still.ofOneFrame, 0.41, 0.1);
    EXPECT_NEAR(still.ofMean, still.ofOneFrame, 1e-9) << "all frames are the same";
    if (noise == InputNoise::White)
      EXPECT_NEAR(moving.ofMean, 0.41 / 8.0, 0.012);
    else
      EXPECT_LT(moving.ofMean, 0.41 / 16.0) << "spread evenly over time: four times fewer frames do";
  }
}

// Opacity 1 − exp(−kσΔ) is concave in k: the mean of its two values lies below that of their mean, which is
// the integral, by up to (cosh(σΔ/2) − 1) exp(−σℓ).
TEST_F(FogTest, AnimatedNoiseIsLessOpaqueThanTheIntegralByItsStepsAlone) {
  constexpr int kFrames = 64;
  constexpr double kDensity = 0.35;
  const Stage stage = Stage::withCone();
  double lastShortfall = 0.0;
  for (const int steps : {12, 4}) {
    FrameRequest asked = request();
    asked.inputs.fogSteps = steps;
    asked.inputs.fogNoise = InputNoise::White;
    const std::vector<Image> all = frames(stage.scene, asked, kFrames);
    const double ofStep = kDensity * stepLength(stage.cones[0], steps);
    double measured = 0.0, predicted = 0.0, integral = 0.0, variance = 0.0, bound = 0.0;
    forEachPixel([&](const glm::ivec2& pixel) {
      const test::FogTruth truth = truthAt(stage.cones[0], pixel);
      if (truth.length == 0.0) return;
      const double count = kDensity * truth.length / ofStep, fraction = count - std::floor(count);
      const double fewer = std::exp(-ofStep * std::floor(count)), more = fewer * std::exp(-ofStep);
      predicted += 1.0 - (1.0 - fraction) * fewer - fraction * more;
      variance += (fewer - more) * (fewer - more) * fraction * (1.0 - fraction) / kFrames;
      integral += truth.opacity;
      bound += (std::cosh(0.5 * ofStep) - 1.0) * (1.0 - truth.opacity);
      for (const Image& frame : all) measured += static_cast<double>(frame.at(pixel.x, pixel.y)[3]) / kFrames;
    });
    // Noise of the pixels has nothing to do with each other: four deviations. Truth is sampled finely.
    const double deviation = 4.0 * std::sqrt(variance);
    EXPECT_NEAR(measured, predicted, deviation + 0.002 * integral) << steps << " steps";
    const double shortfall = integral - predicted;
    EXPECT_GT(shortfall, 0.0);
    EXPECT_LE(shortfall, bound);
    if (steps == 4) {
      EXPECT_GT(shortfall, deviation + 0.002 * integral) << "four steps are off by more than noise";
      EXPECT_GT(shortfall, 6.0 * lastShortfall) << "nine times, were fog thin";
    }
    lastShortfall = shortfall;
  }
}

TEST_F(FogTest, WithoutNoiseErrsTheSameInEachFrame) {
  const Stage stage = Stage::withCone();
  const std::vector<Image> all = frames(stage.scene, request(), 3);
  EXPECT_TRUE(sameBits(all[0], all[1]));
  EXPECT_TRUE(sameBits(all[0], all[2]));
}

TEST_F(FogTest, LiesOverTheShadedColor) {
  const Stage stage = Stage::withCone();
  FrameRequest asked = request();
  const FrameInputs foggy = draw(stage.scene, asked);
  asked.inputs.fogDensity = 0.0f;
  const FrameInputs clear = draw(stage.scene, asked);
  EXPECT_FALSE(clear.fog);
  const Image fog = foggy.fog.download(), color = foggy.color.download(), surface = clear.color.download();
  EXPECT_TRUE(sameBits(foggy.motion.download(), clear.motion.download()));
  EXPECT_TRUE(sameBits(foggy.depth.download(), clear.depth.download()));
  forEachPixel([&](const glm::ivec2& pixel) {
    const glm::vec4 over = fog.texel(pixel.x, pixel.y), below = surface.texel(pixel.x, pixel.y);
    for (int channel = 0; channel < 3; ++channel)
      ASSERT_NEAR(color.texel(pixel.x, pixel.y)[channel], below[channel] * (1.0f - over.w) + over[channel],
                  1e-6f);
  });
}

TEST_F(FogTest, ScenesWithoutFogKeepTheirBits) {
  const Stage stage;
  FrameRequest asked = request();
  const FrameInputs plain = draw(stage.scene, asked, 3);
  EXPECT_FALSE(plain.fog);
  asked.inputs.fogSteps = 3;
  asked.inputs.fogNoise = InputNoise::White;
  asked.inputs.fogHistory = FogHistory::Kept;
  EXPECT_TRUE(sameBits(draw(stage.scene, asked, 3).color.download(), plain.color.download()));
}

TEST_F(FogTest, IsGoneWithItsNode) {
  Stage stage = Stage::withCone();
  FrameRequest asked = request();
  asked.filter.hidden = {"cone"};
  for (const float value : draw(stage.scene, asked).fog.download().pixels) ASSERT_EQ(value, 0.0f);
}

TEST_F(FogTest, AnOrthographicCameraSeesItAlongParallelRays) {
  Stage stage = Stage::withCone();
  stage.scene.cameras[0].orthographic = true;
  stage.scene.cameras[0].height = 9.0f;
  stage.scene.cameras[0].farPlane = 40.0f;
  FrameRequest asked = request();
  asked.inputs.fogSteps = 0;
  const Image fog = draw(stage.scene, asked).fog.download();
  forEachPixel([&](const glm::ivec2& pixel) {
    const glm::dvec3 from((pixel.x + 0.5 - 16.0) * 0.5, (9.0 - pixel.y - 0.5) * 0.5, 10.0);
    const bool isOnCard = std::abs(from.x - 2.5) < 1.5 && std::abs(from.y - 0.5) < 1.0;
    const test::FogTruth truth = test::fogTruth(stage.cones[0], from, {0, 0, -1}, isOnCard ? 9.5 : 16.0);
    ASSERT_NEAR(static_cast<double>(fog.at(pixel.x, pixel.y)[3]), truth.opacity, 0.003);
  });
}

TEST_F(FogTest, TheReferenceHasTheIntegralAndNothingElseOfTheSettings) {
  FrameRequest asked = request();
  asked.inputs.fogNoise = InputNoise::White;
  asked.inputs.fogHistory = FogHistory::LargestAsPrinted;
  asked.inputs.fogDensity = 1.5f;
  const FrameRequest reference = referenceRequest(asked);
  EXPECT_EQ(reference.inputs.fogSteps, 0);
  EXPECT_EQ(reference.inputs.fogDensity, 1.5f);
  FrameRequest other = asked;
  other.inputs.fogSteps = 99;
  other.inputs.fogNoise = InputNoise::None;
  other.inputs.fogHistory = FogHistory::None;
  EXPECT_EQ(referenceRequest(other), reference);
}

// 20.5: what each constraint makes of the mean of the frames before.
class FogHistoryTest : public FogTest {
 protected:
  /// At frame `frame`, with a history of four frames.
  static Image filtered(const Scene& scene, FogHistory history, int frame) {
    FrameRequest asked = request();
    asked.inputs.fogNoise = InputNoise::White;
    asked.inputs.fogHistory = history;
    asked.inputs.fogFrames = 4;
    return draw(scene, asked, frame).fog.download();
  }
  static std::vector<Image> raw(const Scene& scene, int count) {
    FrameRequest asked = request();
    asked.inputs.fogNoise = InputNoise::White;
    return frames(scene, asked, count);
  }
  static double largestDifference(const Image& a, const Image& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
      most = std::max(most, std::abs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i])));
    return most;
  }
};

/// One channel of a pixel, from the frames that were drawn one by one: the last is of now.
float expectedFog(const std::vector<Image>& frames, FogHistory history, const glm::ivec2& pixel,
                  int channel) {
  const Image& now = frames.back();
  float before = 0.0f;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) before += frames[i].at(pixel.x, pixel.y)[channel];
  const auto count = static_cast<float>(frames.size());
  before /= count - 1.0f;
  const float current = now.at(pixel.x, pixel.y)[channel];
  if (history == FogHistory::LargestAsPrinted) before = std::max(before, current);
  if (history == FogHistory::Clamped) {
    float lowest = current, highest = current;
    for (int y = std::max(pixel.y - 1, 0); y <= std::min(pixel.y + 1, kHeight - 1); ++y)
      for (int x = std::max(pixel.x - 1, 0); x <= std::min(pixel.x + 1, kWidth - 1); ++x) {
        lowest = std::min(lowest, now.at(x, y)[channel]);
        highest = std::max(highest, now.at(x, y)[channel]);
      }
    before = std::clamp(before, lowest, highest);
  }
  return (current + (count - 1.0f) * before) / count;
}

// Techniques: 20.5.
TEST_F(FogHistoryTest, IsTheMeanOfTheFramesBeforeAsItsConstraintSays) {
  const Stage stage = Stage::withCone();
  const std::vector<Image> all = raw(stage.scene, 6);
  const std::vector<Image> four(all.begin() + 2, all.end());
  for (const FogHistory history : {FogHistory::Kept, FogHistory::Clamped, FogHistory::LargestAsPrinted}) {
    const Image got = filtered(stage.scene, history, 5);
    forEachPixel([&](const glm::ivec2& pixel) {
      for (int channel = 0; channel < 4; ++channel)
        ASSERT_NEAR(got.at(pixel.x, pixel.y)[channel], expectedFog(four, history, pixel, channel), 1e-5f)
            << static_cast<int>(history) << " at " << pixel.x << ", " << pixel.y;
    });
  }
}

TEST_F(FogHistoryTest, StartsAnewWhereTheFramesDo) {
  Stage stage = Stage::withCone();
  stage.scene.shot.cuts = {4};
  const std::vector<Image> all = raw(stage.scene, 6);
  EXPECT_TRUE(sameBits(filtered(stage.scene, FogHistory::Kept, 0), all[0]));
  EXPECT_TRUE(sameBits(filtered(stage.scene, FogHistory::Kept, 4), all[4]));
  const Image next = filtered(stage.scene, FogHistory::Kept, 5);
  forEachPixel([&](const glm::ivec2& pixel) {
    ASSERT_NEAR(next.at(pixel.x, pixel.y)[3], expectedFog({all[4], all[5]}, FogHistory::Kept, pixel, 3),
                1e-6f);
  });
}

TEST_F(FogHistoryTest, StartsAnewWhereSomebodyRestartsIt) {
  const Stage stage = Stage::withCone();
  FrameRequest asked = request();
  asked.inputs.fogNoise = InputNoise::White;
  asked.inputs.fogHistory = FogHistory::Kept;
  asked.restarts = {3};
  EXPECT_TRUE(sameBits(draw(stage.scene, asked, 3).fog.download(), raw(stage.scene, 4)[3]));
}

// A beam that jumps away after frame 0: without a constraint three frames of four still show it, as Raptor's
// largest does; clamped there is none.
// Techniques: 20.5, 24.
TEST_F(FogHistoryTest, OnlyTheClampTakesAwayWhatMovedOn) {
  Stage stage = Stage::withCone();
  const Node cone = stage.scene.nodes.back();
  test::jump(stage.scene, stage.cones[0].cone.node, AnimationPath::Translation,
             glm::vec4(cone.translation, 0.0f), {40.0f, 0.0f, 0.0f, 0.0f});
  const Image first = raw(stage.scene, 1)[0];
  const Image kept = filtered(stage.scene, FogHistory::Kept, 1);
  const Image largest = filtered(stage.scene, FogHistory::LargestAsPrinted, 1);
  const Image clamped = filtered(stage.scene, FogHistory::Clamped, 1);
  double shown = 0.0;
  forEachPixel([&](const glm::ivec2& pixel) {
    const float was = first.at(pixel.x, pixel.y)[3];
    shown = std::max(shown, static_cast<double>(was));
    ASSERT_EQ(clamped.at(pixel.x, pixel.y)[3], 0.0f);
    ASSERT_EQ(kept.at(pixel.x, pixel.y)[3], largest.at(pixel.x, pixel.y)[3]);
  });
  EXPECT_GT(shown, 0.3);
  EXPECT_GT(largestDifference(kept, clamped), 0.1);
}

} // namespace
} // namespace taa
