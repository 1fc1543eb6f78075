// What is blended over the picture, and the masks of special content.
#include "core/base/Half.h"
#include "tests/support/CompareImages.h"
#include "tests/support/frames/MotionFixture.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <memory>

namespace taa {
namespace {

using test::addColor;
using test::addQuad;
using test::emptyScene;

constexpr int kMiddleX = test::kWidth / 2, kMiddleY = test::kHeight / 2;
const glm::vec3 kWide(40, 0, 0), kHigh(0, 40, 0), kRight(4, 0, 0), kUp(0, 4, 0);
const glm::vec3 kBehind(0.7f, 0.3f, 0.11f);

constexpr std::array kBlended = {BlendedAs::Mask, BlendedAs::Dithered, BlendedAs::Before,
                                 BlendedAs::BeforeWithMotion, BlendedAs::After};
constexpr std::array kMasks = {MaskSource::None, MaskSource::Material, MaskSource::Opacity,
                               MaskSource::AutoReactive};

class BlendedTest : public test::MotionFixture {
 protected:
  static FrameRequest as(BlendedAs blended, MaskSource mask = MaskSource::None,
                         Precision precision = Precision::Full) {
    FrameRequest asked = request();
    asked.inputs.precision = precision;
    asked.inputs.blended = blended;
    asked.inputs.mask = mask;
    return asked;
  }
  /// A wall behind everything.
  static Scene walled() {
    Scene scene = emptyScene();
    addQuad(scene, {0, 0, -5}, kWide, kHigh, addColor(scene, glm::vec4(kBehind, 1.0f)));
    return scene;
  }
  static int addGlass(Scene& scene, const glm::vec3& place, const glm::vec4& color) {
    const int material = addColor(scene, color);
    scene.materials.back().alphaMode = AlphaMode::Blend;
    scene.materials.back().doubleSided = true;
    return addQuad(scene, place, kRight, kUp, material);
  }
  static glm::vec4 middle(const gl::Texture& texture) { return texture.download().texel(kMiddleX, kMiddleY); }
  static std::array<Image, 6> all(const FrameInputs& inputs) {
    return {inputs.color.download(),  inputs.motion.download(),   inputs.depth.download(),
            inputs.normal.download(), inputs.objectId.download(), inputs.previousDepth.download()};
  }
};

/// The half float at or below a positive value.
float cutToHalf(float value) {
  const float nearest = roundedToHalf(value);
  if (nearest <= value) return nearest;
  const float ulp = std::ldexp(1.0f, std::ilogb(value) - 10);
  return roundedToHalf(nearest - ulp);
}

// c·a + c behind·(1 − a). Halves are cut or rounded as the driver stores what it blends: llvmpipe cuts.
// Techniques: 21.3.
TEST_F(BlendedTest, BlendsByTheEquation) {
  for (const float alpha : {0.25f, 0.5f, 0.6f, 1.0f}) {
    const glm::vec3 glass(0.9f, 0.05f, 0.33f);
    Scene scene = walled();
    addGlass(scene, {0, 0, 0}, glm::vec4(glass, alpha));
    const glm::vec4 full = middle(draw(scene, as(BlendedAs::Before)).color);
    const glm::vec4 half =
        middle(draw(scene, as(BlendedAs::Before, MaskSource::None, Precision::Half)).color);
    for (int channel = 0; channel < 3; ++channel) {
      const float expected = glass[channel] * alpha + kBehind[channel] * (1.0f - alpha);
      EXPECT_FLOAT_EQ(full[channel], expected) << alpha;
      const float blended =
          roundedToHalf(glass[channel]) * alpha + roundedToHalf(kBehind[channel]) * (1.0f - alpha);
      if (isExact())
        EXPECT_EQ(half[channel], cutToHalf(blended)) << alpha;
      else
        EXPECT_NEAR(half[channel], blended, blended / 1024.0f) << alpha;
    }
  }
}

TEST_F(BlendedTest, ComesBackToFrontFromEitherSide) {
  const glm::vec3 red(1, 0, 0), blue(0, 0, 1);
  for (const bool isTurned : {false, true}) {
    Scene scene = emptyScene();
    addQuad(scene, {0, 0, isTurned ? 6.0f : -6.0f}, isTurned ? -kWide : kWide, kHigh,
            addColor(scene, glm::vec4(kBehind, 1.0f)));
    for (const bool isRedFirst : {true, false}) {
      Scene panes = scene;
      for (const bool isRed : {isRedFirst, !isRedFirst})
        addGlass(panes, {0, 0, isRed ? 1.0f : -1.0f}, glm::vec4(isRed ? red : blue, 0.5f));
      if (isTurned) {
        panes.nodes[0].translation = {0, 0, -10};
        panes.nodes[0].rotation = glm::angleAxis(3.14159265f, glm::vec3(0, 1, 0));
      }
      const glm::vec3 near = isTurned ? blue : red, far = isTurned ? red : blue;
      const glm::vec3 expected = 0.5f * near + 0.25f * far + 0.25f * kBehind;
      const glm::vec4 color = middle(draw(panes, as(BlendedAs::Before)).color);
      for (int channel = 0; channel < 3; ++channel) EXPECT_FLOAT_EQ(color[channel], expected[channel]);
    }
  }
}

// Techniques: 21.2.
TEST_F(BlendedTest, BeforeLeavesEverythingButColorWhatIsBehind) {
  const Scene without = walled();
  Scene with = without;
  const int pane = addGlass(with, {0, 0, 0}, {0.2f, 0.9f, 0.4f, 0.5f});
  test::jump(with, pane, AnimationPath::Translation, {-1, 0, 0, 0}, {0, 0, 0, 0});
  const auto behind = all(draw(without, as(BlendedAs::Before)));
  const auto before = all(draw(with, as(BlendedAs::Before)));
  EXPECT_FALSE(test::agree(before[0], behind[0]));
  for (std::size_t i = 1; i < behind.size(); ++i) EXPECT_EQ(test::difference(before[i], behind[i]), "") << i;
  const auto withMotion = all(draw(with, as(BlendedAs::BeforeWithMotion)));
  EXPECT_EQ(test::difference(withMotion[0], before[0]), "");
  for (std::size_t i = 2; i < behind.size(); ++i)
    EXPECT_EQ(test::difference(withMotion[i], behind[i]), "") << i;
  // One meter at 10 m.
  EXPECT_NEAR(withMotion[1].texel(kMiddleX, kMiddleY).x, 0.5f * test::kHeight * test::kP11 / 10.0f, 1e-3f);
  EXPECT_EQ(withMotion[1].texel(4, kMiddleY), behind[1].texel(4, kMiddleY));
}

// Techniques: 21.1.
TEST_F(BlendedTest, AfterLeavesThePictureAndDrawsALayerWithoutJitter) {
  const Scene without = walled();
  Scene with = without;
  addGlass(with, {0.3f, 0.2f, 0}, {0.25f, 0.5f, 1.0f, 0.5f});
  SceneRenderer renderer(std::make_shared<const Scene>(with));
  FrameInputs inputs;
  Image first;
  for (int frame = 0; frame < 4; ++frame) {
    renderer.draw(as(BlendedAs::After), frame, inputs);
    const auto behind = all(draw(without, as(BlendedAs::After), frame));
    const auto pictures = all(inputs);
    for (std::size_t i = 0; i < behind.size(); ++i)
      EXPECT_EQ(test::difference(pictures[i], behind[i]), "") << i << " of frame " << frame;
    const Image layer = inputs.overlay.download();
    EXPECT_EQ(layer.texel(kMiddleX, kMiddleY), glm::vec4(0.125f, 0.25f, 0.5f, 0.5f));
    EXPECT_EQ(layer.texel(4, kMiddleY), glm::vec4(0.0f));
    if (frame == 0)
      first = layer;
    else
      EXPECT_EQ(test::difference(layer, first), "") << frame;
  }
}

TEST_F(BlendedTest, IsHiddenByWhatStandsBeforeIt) {
  Scene scene = emptyScene();
  addGlass(scene, {0, 0, -1}, {1, 1, 1, 0.5f});
  addQuad(scene, {0, 0, 1}, kRight, kUp, addColor(scene, glm::vec4(kBehind, 1.0f)));
  const glm::vec4 seen = middle(draw(scene, as(BlendedAs::Before)).color);
  for (int channel = 0; channel < 3; ++channel) EXPECT_FLOAT_EQ(seen[channel], kBehind[channel]);
  const FrameInputs after = draw(scene, as(BlendedAs::After));
  EXPECT_EQ(middle(after.overlay), glm::vec4(0.0f));
  const FrameInputs masked = draw(scene, as(BlendedAs::Before, MaskSource::Opacity));
  EXPECT_EQ(middle(masked.mask).x, 0.0f);
}

TEST_F(BlendedTest, OpaqueScenesAreTheSameBitsUnderEveryChoice) {
  Scene scene = walled();
  const int mover = addQuad(scene, {0, 0, 0}, kRight, kUp, addColor(scene, {0.2f, 0.5f, 0.1f, 1.0f}));
  scene.materials.back().unlit = false;
  test::jump(scene, mover, AnimationPath::Translation, {-1, 0, 0, 0}, {0, 0, 0, 0});
  const auto expected = all(draw(scene, request()));
  for (const BlendedAs blended : kBlended)
    for (const MaskSource mask : kMasks) {
      const FrameInputs inputs = draw(scene, as(blended, mask));
      const auto pictures = all(inputs);
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(test::difference(pictures[i], expected[i]), "")
            << i << " " << int(blended) << " " << int(mask);
      EXPECT_EQ(bool(inputs.mask), mask != MaskSource::None);
      EXPECT_EQ(bool(inputs.overlay), blended == BlendedAs::After);
      const Image black(test::kWidth, test::kHeight, 2);
      if (inputs.mask) {
        EXPECT_EQ(test::difference(inputs.mask.download(), black), "");
      }
    }
}

// Techniques: 3.8, 21.5.
TEST_F(BlendedTest, MaskSaysWhatIsResponsiveAndHowMuchWasBlendedIn) {
  Scene scene = walled();
  const glm::vec4 glass(1.0f, 0.2f, 0.1f, 0.6f);
  addGlass(scene, {-2.2f, 0, 0}, glass);
  addQuad(scene, {2.2f, 0, 0}, kRight, kUp, addColor(scene, {0.3f, 0.3f, 0.3f, 1.0f}));
  scene.materials.back().responsive = true;
  constexpr int kGlassX = kMiddleX - 35, kScreenX = kMiddleX + 35;
  const auto at = [&](MaskSource source, int x) {
    return draw(scene, as(BlendedAs::Before, source)).mask.download().texel(x, kMiddleY);
  };
  for (const MaskSource source : {MaskSource::Material, MaskSource::Opacity, MaskSource::AutoReactive}) {
    EXPECT_EQ(at(source, kScreenX), glm::vec4(0, 1, 0, 0)) << int(source);
    EXPECT_EQ(at(source, 4), glm::vec4(0.0f)) << int(source);
    EXPECT_EQ(at(source, kGlassX).y, 0.0f) << int(source);
  }
  EXPECT_EQ(at(MaskSource::Material, kGlassX).x, 0.0f);
  EXPECT_FLOAT_EQ(at(MaskSource::Opacity, kGlassX).x, 153.0f / 255.0f); // 0.6 is a whole number of steps
  // Five times what the tone-mapped channels differ by, of which red differs most.
  const float red = 1.0f * 0.6f + kBehind.x * 0.4f;
  EXPECT_NEAR(at(MaskSource::AutoReactive, kGlassX).x,
              5.0f * (red / (1.0f + red) - kBehind.x / (1.0f + kBehind.x)), 1.0f / 255.0f);
  scene.materials[2].baseColor = {0.0f, 1.0f, 1.0f, 0.9f};
  EXPECT_NEAR(at(MaskSource::AutoReactive, kGlassX).x, 0.9f, 0.51f / 255.0f) << "and no more";
}

TEST_F(BlendedTest, ParticlesThatAreBlendedAreResponsiveWhereTheyShow) {
  Scene scene = walled();
  addGlass(scene, {0, 0, 0}, {1, 1, 1, 0.3f});
  scene.materials.back().responsive = true;
  addGlass(scene, {0, 0, 1}, {1, 0, 0, 0.2f});
  const glm::vec4 mask = middle(draw(scene, as(BlendedAs::Before, MaskSource::Opacity)).mask);
  EXPECT_EQ(mask.y, 1.0f);
  EXPECT_NEAR(mask.x, 0.3f, 0.5f / 255.0f) << "the largest of both";
}

// Techniques: 3.8, 21.7.
TEST_F(BlendedTest, FlipBooksAndScrollsChangeThePictureAndNotTheMotion) {
  Scene scene = emptyScene();
  scene.images.push_back({"pages", 2, 1, {255, 0, 0, 255, 0, 255, 0, 255}});
  const int material = addColor(scene, glm::vec4(1.0f));
  scene.materials.back().baseColorTexture.image = 0;
  scene.materials.back().baseColorTexture.sampler = {Filter::Nearest, Filter::Nearest, Mipmaps::None};
  addQuad(scene, {0, 0, 0}, kRight, kUp, material);
  const auto isGreen = [&](int frame) {
    const FrameInputs inputs = draw(scene, request(), frame);
    EXPECT_EQ(middle(inputs.motion), glm::vec4(0.0f));
    return middle(inputs.color).y == 1.0f;
  };
  scene.materials.back().uvAnimation = {2, 1, 20.0f}; // three frames a page
  for (int frame = 0; frame < 12; ++frame) EXPECT_EQ(isGreen(frame), frame / 3 % 2 == 1) << frame;
  scene.materials.back().uvAnimation = {1, 1, 0.0f, {3.75f, 0.0f}}; // a sixteenth a frame, from the border
  scene.materials.back().baseColorTexture.uvFromUv[2] = {-0.03125f, 0.0f, 1.0f};
  for (int frame = 0; frame < 24; ++frame)
    EXPECT_EQ(isGreen(frame), frame > 0 && (frame - 1) / 8 % 2 == 0) << frame;
}

} // namespace
} // namespace taa
