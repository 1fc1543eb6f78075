// How textures and transparency are read: mip bias, unjittered texture coordinates, dithered alpha (manual
// §19, 20.7).
#include "core/render/passes/SceneRenderer.h"

#include "tests/support/GlTest.h"
#include "tests/support/frames/SmallScene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

namespace taa {
namespace {

using TextureReadTest = test::GlTest;

constexpr int kWidth = 160, kHeight = 90;

/// A quad that fills the picture with a ramp of `period` texels of 64, linear and repeated.
Scene texturedScene(int period) {
  Scene scene = test::emptyScene();
  SceneImage image{"ramp", 64, 64, {}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto value = static_cast<std::uint8_t>((x + y) % period * 255 / (period - 1));
      image.rgba.insert(image.rgba.end(), {value, value, value, 255});
    }
  scene.images.push_back(image);
  scene.materials[0].baseColorTexture.image = 0;
  test::addQuad(scene, {0, 0, 0}, {24, 0, 0}, {0, 24, 0});
  return scene;
}

Image color(const Scene& scene, const InputSettings& settings, int frame,
            JitterSequence sequence = JitterSequence::Halton) {
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameRequest request;
  request.camera = test::kEye;
  request.width = kWidth;
  request.height = kHeight;
  request.inputs = settings;
  request.inputs.precision = Precision::Full;
  request.jitter.sequence = sequence;
  FrameInputs inputs;
  renderer.draw(request, frame, inputs);
  return inputs.color.download();
}

float largestDifference(const Image& a, const Image& b) {
  float largest = 0.0f;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
  return largest;
}

// Techniques: 19.2.
TEST_F(TextureReadTest, UnjitteredTexturesStandStillUnderJitter) {
  const Scene scene = texturedScene(32);
  InputSettings settings;
  const Image still = color(scene, settings, 0, JitterSequence::None);
  float jittered = 0.0f, unjittered = 0.0f;
  for (const int frame : {1, 2, 5}) {
    settings.unjitterTextures = Switch::Off;
    jittered = std::max(jittered, largestDifference(color(scene, settings, frame), still));
    settings.unjitterTextures = Switch::On;
    unjittered = std::max(unjittered, largestDifference(color(scene, settings, frame), still));
  }
  EXPECT_GT(jittered, 0.02f);
  // Filtering has eight bits of the fraction of a texel, of which a step of the ramp is 1/31.
  EXPECT_LT(unjittered, 0.004f);
}

float contrastOf(const Image& image) {
  float least = 1.0f, most = 0.0f;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      least = std::min(least, image.texel(x, y).x);
      most = std::max(most, image.texel(x, y).x);
    }
  return most - least;
}

// Techniques: 19.1.
TEST_F(TextureReadTest, ABiasChoosesBlurredOrSharperLevels) {
  Scene scene = texturedScene(2);                            // checkers: gone from level 1 on
  scene.materials[0].baseColorTexture.uvFromUv[0][0] = 4.0f; // 64 texels in 34 px: level 0.9
  scene.materials[0].baseColorTexture.uvFromUv[1][1] = 4.0f;
  InputSettings settings;
  const float plain = contrastOf(color(scene, settings, 0));
  settings.mipBias = 2.0f;
  const float blurred = contrastOf(color(scene, settings, 0));
  settings.mipBias = -2.0f;
  const float sharp = contrastOf(color(scene, settings, 0));
  EXPECT_LT(blurred, 0.01f) << "the last levels are plain gray";
  EXPECT_GT(sharp, plain + 0.1f);
  settings.unjitterTextures = Switch::On;
  EXPECT_GT(contrastOf(color(scene, settings, 0)), plain + 0.1f) << "with its own derivatives too";
}

// Techniques: 20.7, 21.6.
TEST_F(TextureReadTest, DitheredAlphaIsDrawnInAsManyOfSixteenFramesAsItSays) {
  Scene scene = test::emptyScene();
  scene.materials[0].alphaMode = AlphaMode::Blend;
  scene.materials[0].baseColor = {1.0f, 1.0f, 1.0f, 0.3f};
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0.0f);
  test::addQuad(scene, {0, 0, 0}, {40, 0, 0}, {0, 40, 0});
  InputSettings settings;
  EXPECT_EQ(contrastOf(color(scene, settings, 0)), 0.0f) << "as a mask it is not there";
  settings.blended = BlendedAs::Dithered;
  Image count(kWidth, kHeight, 4);
  scene.shot.frames = 32;
  for (int frame = 0; frame < 16; ++frame) {
    const Image seen = color(scene, settings, frame);
    for (std::size_t i = 0; i < seen.pixels.size(); i += 4) count.pixels[i] += seen.pixels[i] > 0.5f;
  }
  // Thresholds (i + ½)/16 below 0.3 are those of i = 0 to 4.
  for (std::size_t i = 0; i < count.pixels.size(); i += 4) ASSERT_EQ(count.pixels[i], 5.0f) << i;
}

} // namespace
} // namespace taa
