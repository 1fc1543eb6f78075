// Shaded colors that are clipped before anything is averaged (manual 1.2).
#include "core/render/passes/NoisePass.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/CompareImages.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/SmallScene.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace taa {
namespace {

class DynamicRangeTest : public test::GlTest {
 protected:
  static FrameRequest request(const Scene& scene, Precision precision = Precision::Full) {
    FrameRequest request;
    request.camera = scene.shot.camera;
    request.width = 160;
    request.height = 90;
    request.inputs.precision = precision;
    return request;
  }
};

Image clipped(Image image) {
  for (float& value : image.pixels) value = std::min(value, 1.0f);
  return image;
}

float brightest(const Image& image) {
  float most = 0.0f;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int channel = 0; channel < 3; ++channel) most = std::max(most, image.at(x, y)[channel]);
  return most;
}

// Techniques: 1.1, 1.2.
TEST_F(DynamicRangeTest, OfLdrEndsAtWhiteAndIsTheSameBelow) {
  for (const char* name : {"builtin:lights", "builtin:fireflies"})
    for (const Precision precision : {Precision::Full, Precision::Half})
      for (const BlendedAs blended : {BlendedAs::Mask, BlendedAs::Before, BlendedAs::After}) {
        const auto scene = std::make_shared<const Scene>(openScene(name));
        SceneRenderer renderer(scene);
        FrameRequest asked = request(*scene, precision);
        asked.inputs.blended = blended;
        FrameInputs hdr, ldr;
        renderer.draw(asked, 7, hdr);
        asked.inputs.range = DynamicRange::Ldr;
        renderer.draw(asked, 7, ldr);
        const Image bright = hdr.color.download();
        EXPECT_GT(brightest(bright), 1.0f) << name;
        EXPECT_EQ(brightest(ldr.color.download()), 1.0f) << name;
        EXPECT_EQ(test::difference(ldr.color.download(), clipped(bright)), "") << name;
        // Nothing else knows of it: motion, depth, what is laid over the output.
        EXPECT_EQ(test::difference(ldr.motion.download(), hdr.motion.download()), "");
        EXPECT_EQ(test::difference(ldr.depth.download(), hdr.depth.download()), "");
        if (blended == BlendedAs::After) {
          EXPECT_EQ(test::difference(ldr.overlay.download(), hdr.overlay.download()), "");
        }
      }
}

// Blending is linear and comes before the tone map: bright glass adds what it has above white, too.
// Techniques: 1.2.
TEST_F(DynamicRangeTest, OfLdrIsClippedAfterBlending) {
  Scene scene = test::emptyScene();
  for (const float wall : {0.25f, 0.5f}) {
    const int color = test::addColor(scene, glm::vec4(wall, wall, wall, 1.0f));
    test::addQuad(scene, {wall > 0.3f ? 10 : -10, 0, -1}, {20, 0, 0}, {0, 40, 0}, color);
  }
  const int glass = test::addColor(scene, {3.0f, 2.0f, 0.0f, 0.25f});
  scene.materials.back().alphaMode = AlphaMode::Blend;
  test::addQuad(scene, {0, 0, 0}, {40, 0, 0}, {0, 40, 0}, glass);
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameRequest asked = request(scene);
  asked.inputs.blended = BlendedAs::Before;
  asked.inputs.range = DynamicRange::Ldr;
  FrameInputs inputs;
  renderer.draw(asked, 1, inputs);
  const Image picture = inputs.color.download();
  EXPECT_EQ(glm::vec3(picture.texel(40, 45)), glm::vec3(0.9375f, 0.6875f, 0.1875f)) << "3/4 + 3/4 · 1/4";
  EXPECT_EQ(glm::vec3(picture.texel(120, 45)), glm::vec3(1.0f, 0.875f, 0.375f)) << "3/4 + 3/4 · 1/2 is 9/8";
}

TEST_F(DynamicRangeTest, OfLdrIsClippedBeforeTheNoise) {
  const auto scene = std::make_shared<const Scene>(openScene("builtin:lights"));
  SceneRenderer renderer(scene);
  FrameRequest asked = request(*scene);
  asked.inputs.noise = InputNoise::Blue;
  asked.inputs.noiseAmount = 2.0f;
  FrameInputs hdr, ldr;
  renderer.draw(asked, 7, hdr);
  asked.inputs.range = DynamicRange::Ldr;
  renderer.draw(asked, 7, ldr);
  const Image bright = hdr.color.download(), picture = ldr.color.download();
  const float reach = 2.0f / 255.0f; // a triangle of twice the amount's width
  int above = 0, below = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        const float with = bright.at(x, y)[channel], value = picture.at(x, y)[channel];
        if (with < 1.0f - reach) {
          ASSERT_EQ(value, with);
        }
        if (with <= 1.0f + reach) continue;
        ASSERT_NEAR(value, 1.0f, reach) << "white with noise";
        above += value > 1.0f;
        below += value < 1.0f;
      }
  EXPECT_GT(above, 10) << "what is clipped after the noise has nothing above";
  EXPECT_GT(below, 10);
}

TEST_F(DynamicRangeTest, OfLdrMakesWhatIsNoNumberWhatItIsWithoutIt) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Image flat(4, 1, 4);
  flat.pixels = {kNaN,  0.5f, 2.0f,  1, kInfinity, -kInfinity, 1.0f,  1,
                 -1.0f, 0.0f, 1e30f, 1, 65504.0f,  kNaN,       0.25f, 1};
  InputSettings settings;
  settings.range = DynamicRange::Ldr;
  ASSERT_TRUE(NoisePass::isNeeded(settings));
  EXPECT_FALSE(NoisePass::isNeeded({}));
  const shared::FrameBlock block{}; // colors are kept in 32 bits
  const gl::Buffer frame(sizeof(block), &block, "frame");
  FrameInputs out;
  out.color = gl::Texture({4, 1}, gl::Format::RGBA32F, "flat");
  out.color.upload(flat);
  NoisePass pass;
  pass.draw(settings, frame, out);
  EXPECT_EQ(out.color.download().pixels,
            (std::vector<float>{0, 0.5f, 1, 1, 1, 0, 1, 1, 0, 0, 1, 1, 1, 0, 0.25f, 1}));
}

} // namespace
} // namespace taa
