// What the renderer draws against closed forms: whole-pixel warps, hidden motion, 16-bit motion, coverage of
// an edge, and noise averaged (invariants 17 to 19, 45, 49).
#include "core/taa/TaaPass.h"

#include "tests/support/frames/Frames.h"
#include "tests/support/frames/MotionFixture.h"
#include "tests/support/frames/TwinInputs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace taa {
namespace {

using test::addColor;
using test::addQuad;
using test::emptyScene;
using test::jump;
using test::kHeight;
using test::kP11;
using test::kWidth;

using RenderedNumbersTest = test::MotionFixture;

/// World units of a pixel at the distance of 10 m that z = 0 has.
constexpr float kPixel = 10.0f / (kP11 * 0.5f * kHeight);

/// World position at z = 0 of a place in the picture.
glm::vec3 worldOf(float x, float y) {
  return {(x - 0.5f * kWidth) * kPixel, (0.5f * kHeight - y) * kPixel, 0.0f};
}

/// A parallelogram that covers the pixels of a rectangle; its edges lie a quarter of a pixel off theirs.
int addRectangle(Scene& scene, float left, float top, float width, float height, int material) {
  const glm::vec3 low = worldOf(left + 0.25f, top + height + 0.25f),
                  high = worldOf(left + width + 0.25f, top + 0.25f);
  return addQuad(scene, 0.5f * (low + high), {high.x - low.x, 0, 0}, {0, high.y - low.y, 0}, material);
}

TEST_F(RenderedNumbersTest, AMoveByWholePixelsIsThePreviousPictureBitForBit) {
  Scene scene = emptyScene();
  std::mt19937 random(17);
  for (int k = 0; k < 60; ++k) { // a mosaic that moves as one
    const auto level = [&random] { return static_cast<float>(random() % 256) / 256.0f; };
    const int material = addColor(scene, {level(), level(), level(), 1.0f});
    const int node =
        addRectangle(scene, float(20 + 28 * (k % 10)), float(10 + 26 * (k / 10)), 28, 26, material);
    const glm::vec3 from = scene.nodes[std::size_t(node)].translation,
                    to = from + worldOf(165, 87) - worldOf(160, 90);
    jump(scene, node, AnimationPath::Translation, glm::vec4(from, 0), glm::vec4(to, 0));
  }
  FrameRequest asked = request();
  asked.jitter.sequence = JitterSequence::None;
  const Image before = draw(scene, asked, 0).color.download();
  const FrameInputs now = draw(scene, asked, 1);
  const Image color = now.color.download(), motion = now.motion.download(), ids = now.objectId.download();
  int compared = 0;
  for (int y = 8; y < kHeight - 8; ++y)
    for (int x = 8; x < kWidth - 8; ++x) {
      if (ids.texel(x, y).x == 0.0f) continue; // disoccluded ground and sky
      const glm::vec4 v = motion.texel(x, y);
      ASSERT_NEAR(v.x, 5.0f, 2e-4f);
      ASSERT_NEAR(v.y, -3.0f, 2e-4f);
      ASSERT_EQ(color.texel(x, y), before.texel(x - 5, y + 3)) << x << ", " << y;
      ++compared;
    }
  EXPECT_GT(compared, 40000);
}

TEST_F(RenderedNumbersTest, AHiddenThingsMotionStaysHidden) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {40, 0, 0}, {0, 40, 0}); // a wall before everything
  const int hidden = addQuad(scene, {0, 0, -2}, {6, 0, 0}, {0, 6, 0});
  jump(scene, hidden, AnimationPath::Translation, {0, 0, -2, 0}, {2, 1, -2, 0});
  for (const float component : motion(scene).pixels) ASSERT_EQ(component, 0.0f);
  scene.nodes[std::size_t(hidden)].translation.z = 0.0f; // the same thing before the wall does show
  scene.animations.clear();
  jump(scene, hidden, AnimationPath::Translation, {0, 0, 1, 0}, {2, 1, 1, 0});
  const Image shown = motion(scene);
  EXPECT_GT(std::fabs(shown.texel(kWidth / 2, kHeight / 2).x), 10.0f);
}

TEST_F(RenderedNumbersTest, MotionInHalvesIsOffByHalfAStepAtMost) {
  for (const float speed : {1.0f, 10.0f, 100.0f}) {
    Scene scene = emptyScene();
    const int plane = addQuad(scene, {0, 0, 0}, {60, 0, 0}, {0, 60, 0});
    jump(scene, plane, AnimationPath::Translation, {0, 0, 0, 0}, {1.037f * speed * kPixel, 0, 0, 0});
    FrameRequest asked = request();
    const Image exact = motion(scene, asked);
    asked.inputs.precision = Precision::Half;
    const Image half = motion(scene, asked);
    const float step = std::ldexp(1.0f, std::ilogb(1.037f * speed) - 10); // of a half float there
    float worst = 0.0f;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i)
      worst = std::max(worst, std::fabs(half.pixels[i] - exact.pixels[i]));
    EXPECT_LE(worst, 0.5f * step) << speed;
    EXPECT_GT(worst, 0.0f) << speed;
  }
}

/// Largest error of the accumulated coverage of edges at 32 places within a pixel, after one period.
float coverageError(JitterSequence sequence, int period) {
  constexpr int kEdges = 32, kColumn = 160;
  Scene scene = emptyScene();
  for (int k = 0; k < kEdges; ++k) { // strips of five rows, the middle one free of their upper and lower ends
    const glm::vec3 low = worldOf(100.0f, float(5 * k + 10)),
                    high = worldOf(kColumn + (float(k) + 0.5f) / kEdges, float(5 * k + 5));
    addQuad(scene, 0.5f * (low + high), {high.x - low.x, 0, 0}, {0, high.y - low.y, 0});
  }
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  Settings settings = test::averagingSettings();
  settings.jitter.sequence = sequence;
  settings.jitter.period = period;
  TaaPass pass;
  test::Accumulator accumulator;
  FrameInputs inputs;
  FrameRequest asked;
  asked.camera = test::kEye;
  asked.width = kWidth;
  asked.height = kHeight;
  asked.inputs = settings.inputs;
  asked.jitter = settings.jitter;
  for (int frame = 0; frame < period; ++frame) {
    renderer.draw(asked, frame, inputs);
    accumulator.resolve(pass, inputs, settings);
  }
  const Image color = accumulator.history().color.download();
  float worst = 0.0f;
  for (int k = 0; k < kEdges; ++k) {
    const int row = 5 * k + 7;
    const float ground = color.texel(kColumn + 20, row).x, white = color.texel(kColumn - 20, row).x;
    const float covered = (color.texel(kColumn, row).x - ground) / (white - ground);
    worst = std::max(worst, std::fabs(covered - (float(k) + 0.5f) / kEdges));
  }
  return worst;
}

TEST_F(RenderedNumbersTest, CoverageOfAnEdgeIsWithinAShareOfThePeriod) {
  constexpr float kRounding = 1e-3f; // the sky's shade differs between the columns it is taken from
  EXPECT_LE(coverageError(JitterSequence::Halton, 8), 1.0f / 8.0f + kRounding);
  EXPECT_LE(coverageError(JitterSequence::Halton, 16), 1.0f / 16.0f + kRounding);
  EXPECT_LE(coverageError(JitterSequence::Msaa8, 8), 1.0f / 16.0f + kRounding);
  EXPECT_GT(coverageError(JitterSequence::None, 8), 0.45f) << "one sample is all or nothing";
}

/// A plane with a texture of white noise, one texel a pixel, that is somewhere else each frame, and says it
/// is not.
Scene noiseScene(int frames) {
  constexpr int kSide = 512;
  Scene scene = emptyScene();
  scene.shot.frames = frames;
  std::mt19937 random(45);
  SceneImage image{"noise", kSide, kSide, {}};
  for (int i = 0; i < kSide * kSide; ++i)
    image.rgba.insert(image.rgba.end(), {std::uint8_t(random() >> 24), std::uint8_t(random() >> 24),
                                         std::uint8_t(random() >> 24), 255});
  scene.images.push_back(image);
  scene.materials[0].baseColorTexture.image = 0;
  const int plane = addQuad(scene, {0, 0, 0}, {kSide * kPixel, 0, 0}, {0, kSide * kPixel, 0});
  scene.nodes[std::size_t(plane)].motionMode = MotionMode::None;
  AnimationChannel jumps{plane, AnimationPath::Translation, Interpolation::Step, {}, {}};
  for (int frame = 0; frame < frames; ++frame) {
    jumps.times.push_back(std::max(0.0f, (float(frame) - 0.5f) / 60.0f));
    const float x = kPixel * (float(random() % 180) - 90.0f), y = kPixel * (float(random() % 320) - 160.0f);
    jumps.values.push_back({x, y, 0.0f, 0.0f});
  }
  scene.animations.push_back({"jumps", 1000.0f, {jumps}});
  return scene;
}

/// Mean over the color channels of their variance over the picture.
double variance(const Image& image) {
  double total = 0.0;
  for (int channel = 0; channel < 3; ++channel) {
    double sum = 0.0, squares = 0.0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const double value = image.at(x, y)[channel];
        sum += value;
        squares += value * value;
      }
    const double count = static_cast<double>(image.width) * image.height;
    total += (squares - sum * sum / count) / count / 3.0;
  }
  return total;
}

// The table of source 000: how many samples an average with α = 0.1 is worth. Measured, not computed: the
// variance of rendered noise over that of the picture made of it.
TEST_F(RenderedNumbersTest, NoiseIsAveragedByAsManySamplesAsTheTableSays) {
  constexpr int kFrames = 90;
  SceneRenderer renderer(std::make_shared<const Scene>(noiseScene(kFrames)));
  Settings settings = test::averagingSettings();
  settings.weight = {AlphaSource::Constant, 0.1f, 0.0f};
  settings.jitter.sequence = JitterSequence::None;
  FrameRequest asked = request();
  asked.jitter = settings.jitter;
  TaaPass pass;
  test::Accumulator accumulator;
  FrameInputs inputs;
  double noise = 0.0;
  std::vector<double> samples;
  double settled = 0.0;
  for (int frame = 0; frame < kFrames; ++frame) {
    renderer.draw(asked, frame, inputs);
    accumulator.resolve(pass, inputs, settings);
    noise += variance(inputs.color.download());
    const double left = variance(accumulator.history().color.download());
    samples.push_back(noise / (frame + 1) / left);
    if (frame >= 60) settled += noise / (frame + 1) / left / (kFrames - 60);
  }
  // 57,600 pixels of three channels give a variance within 0.5 %; six times that.
  RecordProperty("samples", std::to_string(samples[4]) + " " + std::to_string(samples[9]) + " " +
                                std::to_string(samples[14]) + " " + std::to_string(settled));
  EXPECT_NEAR(samples[0], 1.0, 1e-5);
  EXPECT_NEAR(samples[4], 2.17, 0.03 * 2.17);
  EXPECT_NEAR(samples[9], 5.13, 0.03 * 5.13);
  EXPECT_NEAR(samples[14], 9.78, 0.03 * 9.78);
  EXPECT_NEAR(settled, 19.0, 0.03 * 19.0);
}

} // namespace
} // namespace taa
