// What the renderer draws into the frame's inputs: depth, surfaces, materials, purity.
#include "core/render/passes/SceneRenderer.h"

#include "core/base/Error.h"
#include "core/base/Half.h"
#include "tests/support/GlTest.h"
#include "tests/support/ShaderFolder.h"
#include "tests/support/frames/SmallScene.h"

#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace taa {
namespace {

using test::addColor;
using test::addQuad;
using test::emptyScene;

constexpr int kWidth = 160, kHeight = 90;

class SceneRendererTest : public test::GlTest {
 protected:
  static FrameRequest request() {
    FrameRequest request;
    request.camera = test::kEye;
    request.width = kWidth;
    request.height = kHeight;
    request.jitter.sequence = JitterSequence::None;
    request.inputs.precision = Precision::Full;
    return request;
  }
  static FrameInputs draw(const Scene& scene, const FrameRequest& request, int frame = 0) {
    SceneRenderer renderer(std::make_shared<const Scene>(scene));
    FrameInputs inputs;
    renderer.draw(request, frame, inputs);
    return inputs;
  }
  static FrameInputs draw(const Scene& scene) { return draw(scene, request()); }
};

constexpr int kMiddleX = kWidth / 2, kMiddleY = kHeight / 2;
const glm::vec3 kRight(4, 0, 0), kUp(0, 4, 0);

bool sameBits(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

float objectAt(const FrameInputs& inputs, int x, int y) {
  return inputs.objectId.download().texel(x, y).x;
}

TEST_F(SceneRendererTest, PutsRowZeroAtTheTop) {
  Scene scene = emptyScene();
  addQuad(scene, {-5, 3, 0}, kRight, kUp); // left and up
  const Image ids = draw(scene).objectId.download();
  EXPECT_EQ(ids.texel(kWidth / 4, kHeight / 4).x, 1.0f);
  EXPECT_EQ(ids.texel(kWidth / 4, kHeight - 1).x, 0.0f);
  EXPECT_EQ(ids.texel(kWidth - 1, kHeight / 4).x, 0.0f);
}

TEST_F(SceneRendererTest, GivesTheFormatsItsPrecisionAsksFor) {
  const Scene scene = emptyScene();
  FrameRequest asked = request();
  const FrameInputs full = draw(scene, asked);
  EXPECT_EQ(full.color.format(), gl::Format::RGBA32F);
  EXPECT_EQ(full.motion.format(), gl::Format::RG32F);
  asked.inputs.precision = Precision::Half;
  const FrameInputs half = draw(scene, asked);
  EXPECT_EQ(half.color.format(), gl::Format::RGBA16F);
  EXPECT_EQ(half.motion.format(), gl::Format::RG16F);
  EXPECT_EQ(half.depth.format(), gl::Format::Depth32F);
  EXPECT_EQ(half.objectId.format(), gl::Format::R32UI);
  EXPECT_EQ(half.previousDepth.format(), gl::Format::R32F);
  EXPECT_EQ(half.normal.format(), gl::Format::RGBA16F);
}

TEST_F(SceneRendererTest, KeepsTexturesThatFit) {
  SceneRenderer renderer(std::make_shared<const Scene>(emptyScene()));
  FrameInputs inputs;
  FrameRequest asked = request();
  renderer.draw(asked, 0, inputs);
  const unsigned color = inputs.color.id();
  renderer.draw(asked, 1, inputs);
  EXPECT_EQ(inputs.color.id(), color);
  asked.width = 64;
  renderer.draw(asked, 1, inputs);
  EXPECT_EQ(inputs.width(), 64);
  EXPECT_EQ(inputs.previousDepth.width(), 64);
}

TEST_F(SceneRendererTest, RoundsHalfColorsToNearest) {
  Scene scene = emptyScene();
  const glm::vec4 color(0.1f, 0.3337f, 12.3456f, 1.0f); // truncation would give another value for each
  addQuad(scene, {0, 0, 0}, kRight, kUp, addColor(scene, color));
  FrameRequest asked = request();
  asked.inputs.precision = Precision::Half;
  const glm::vec4 stored = draw(scene, asked).color.download().texel(kMiddleX, kMiddleY);
  for (int channel = 0; channel < 3; ++channel) EXPECT_EQ(stored[channel], roundedToHalf(color[channel]));
  EXPECT_EQ(stored.w, 1.0f);
  const glm::vec4 exact = draw(scene).color.download().texel(kMiddleX, kMiddleY);
  // What is the same at all corners may come back by a last bit from between them (Mesa 25).
  for (int channel = 0; channel < 4; ++channel) EXPECT_FLOAT_EQ(exact[channel], color[channel]);
}

TEST_F(SceneRendererTest, KeepsColorsInsideTheRangeOfHalfFloats) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, kRight, kUp, addColor(scene, {1e9f, -1.0f, std::nanf(""), 1.0f}));
  const glm::vec4 stored = draw(scene).color.download().texel(kMiddleX, kMiddleY);
  EXPECT_EQ(stored, glm::vec4(65504.0f, 0.0f, 0.0f, 1.0f));
}

TEST_F(SceneRendererTest, WritesReversedDepthWithTheSkyAtZero) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, kRight, kUp);
  const FrameInputs inputs = draw(scene);
  const Image depth = inputs.depth.download();
  const float atQuad = depth.texel(kMiddleX, kMiddleY).x;
  EXPECT_FLOAT_EQ(atQuad, 0.01f); // near / distance
  EXPECT_EQ(depth.texel(0, 0).x, 0.0f);
  const glm::vec4& terms = inputs.block.depthTerms;
  EXPECT_FLOAT_EQ((atQuad * terms.x - terms.y) / (atQuad * terms.z - terms.w), 10.0f);
  EXPECT_FLOAT_EQ(inputs.previousDepth.download().texel(kMiddleX, kMiddleY).x, 10.0f);
  EXPECT_EQ(inputs.previousDepth.download().texel(0, 0).x, 0.0f);
}

TEST_F(SceneRendererTest, DrawsWhatIsNearerWhateverTheOrder) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 1}, kRight, kUp);
  addQuad(scene, {0, 0, 2}, kRight, kUp);
  addQuad(scene, {0, 0, -1}, 3.0f * kRight, 3.0f * kUp);
  const Image ids = draw(scene).objectId.download();
  EXPECT_EQ(ids.texel(kMiddleX, kMiddleY).x, 2.0f);
  EXPECT_EQ(ids.texel(45, kMiddleY).x, 3.0f);
}

TEST_F(SceneRendererTest, DoesNotLetTheJitterTouchTheDepthOfAFrontalPlane) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, 10.0f * kRight, 10.0f * kUp); // fills the picture
  FrameRequest asked = request();
  const Image still = draw(scene, asked).depth.download();
  asked.jitter.sequence = JitterSequence::Halton;
  for (int frame = 1; frame < 5; ++frame)
    EXPECT_TRUE(sameBits(draw(scene, asked, frame).depth.download(), still));
}

TEST_F(SceneRendererTest, SamplesTheSceneWhereTheJitteredInverseSays) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {40, 0, 30}, {0, 40, 10});
  const glm::vec3 normal = glm::normalize(glm::cross(glm::vec3(40, 0, 30), glm::vec3(0, 40, 10)));
  FrameRequest asked = request();
  asked.jitter.sequence = JitterSequence::Halton;
  for (int frame = 0; frame < 4; ++frame) {
    const FrameInputs inputs = draw(scene, asked, frame);
    const Image depth = inputs.depth.download();
    for (const glm::ivec2 pixel : {glm::ivec2(40, 70), glm::ivec2(80, 45), glm::ivec2(60, 10)}) {
      const glm::vec2 ndc(2.0f * (float(pixel.x) + 0.5f) / kWidth - 1.0f,
                          1.0f - 2.0f * (float(pixel.y) + 0.5f) / kHeight);
      glm::vec4 world =
          inputs.block.worldFromJitteredClip * glm::vec4(ndc, depth.texel(pixel.x, pixel.y).x, 1.0f);
      // A tenth of a pixel aside, at 10 m, is 6 mm, and 4 mm off this slope; float depth is exact to 2 µm.
      EXPECT_NEAR(glm::dot(glm::vec3(world) / world.w, normal), 0.0f, 2e-4f) << "frame " << frame;
    }
  }
}

TEST_F(SceneRendererTest, DrawsTheSameBitsWithoutJitterAndWithScaleZero) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, {4, 1, 0}, {-1, 4, 0});
  FrameRequest asked = request();
  const FrameInputs without = draw(scene, asked, 3);
  asked.jitter = {JitterSequence::Halton, 16, 1, 0.0f};
  const FrameInputs scaled = draw(scene, asked, 3);
  EXPECT_TRUE(sameBits(without.color.download(), scaled.color.download()));
  EXPECT_TRUE(sameBits(without.depth.download(), scaled.depth.download()));
}

// Techniques: 1.8.
TEST_F(SceneRendererTest, IsAPureFunctionOfTheFrame) {
  Scene scene = emptyScene();
  const int mover = addQuad(scene, {0, 0, 0}, kRight, kUp);
  addQuad(scene, {2, 1, -3}, kRight, kUp, addColor(scene, {0.2f, 0.5f, 0.1f, 1.0f}));
  scene.materials.back().unlit = false;
  scene.animations.push_back({"slide",
                              1.0f,
                              {{mover,
                                AnimationPath::Translation,
                                Interpolation::Linear,
                                {0.0f, 1.0f},
                                {glm::vec4(-8, 0, 0, 0), glm::vec4(8, 0, 0, 0)}}}});
  FrameRequest asked = request();
  asked.jitter.sequence = JitterSequence::Halton;
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameInputs inputs, again;
  const auto images = [&](FrameInputs& out, int frame) {
    renderer.draw(asked, frame, out);
    return std::array{out.color.download(),  out.motion.download(),   out.depth.download(),
                      out.normal.download(), out.objectId.download(), out.previousDepth.download()};
  };
  const auto five = images(inputs, 5), nine = images(inputs, 9), fiveAgain = images(inputs, 5);
  asked.inputs.motion = MotionSource::CameraFromDepth;
  images(again, 7);
  asked.inputs.motion = MotionSource::Objects;
  const auto elsewhere = images(again, 5);
  EXPECT_FALSE(sameBits(five[0], nine[0]));
  for (std::size_t i = 0; i < five.size(); ++i) {
    EXPECT_TRUE(sameBits(five[i], fiveAgain[i])) << "texture " << i;
    EXPECT_TRUE(sameBits(five[i], elsewhere[i])) << "texture " << i;
  }
}

TEST_F(SceneRendererTest, LeavesHolesWhereTheMaskIsBelowTheCutoff) {
  Scene scene = emptyScene();
  // Left half opaque, right half not.
  scene.images.push_back({"halves", 2, 1, {255, 255, 255, 255, 255, 255, 255, 100}});
  const int material = addColor(scene, glm::vec4(1.0f));
  scene.materials.back().baseColorTexture.image = 0;
  scene.materials.back().baseColorTexture.sampler = {Filter::Nearest, Filter::Nearest, Mipmaps::None};
  addQuad(scene, {0, 0, 0}, kRight, kUp, material);
  for (const AlphaMode mode : {AlphaMode::Opaque, AlphaMode::Mask, AlphaMode::Blend}) {
    scene.materials.back().alphaMode = mode;
    const FrameInputs inputs = draw(scene);
    EXPECT_EQ(objectAt(inputs, kMiddleX - 8, kMiddleY), 1.0f);
    EXPECT_EQ(objectAt(inputs, kMiddleX + 8, kMiddleY), mode == AlphaMode::Opaque ? 1.0f : 0.0f);
  }
  scene.materials.back().alphaMode = AlphaMode::Mask;
  scene.materials.back().alphaCutoff = 0.25f;
  EXPECT_EQ(objectAt(draw(scene), kMiddleX + 8, kMiddleY), 1.0f);
}

TEST_F(SceneRendererTest, ShowsBackFacesOfDoubleSidedMaterialsOnlyTurnedToTheCamera) {
  Scene scene = emptyScene();
  const int quad = addQuad(scene, {0, 0, 0}, -kRight, kUp); // faces −z, away from the camera
  EXPECT_EQ(objectAt(draw(scene), kMiddleX, kMiddleY), 0.0f);
  scene.materials[0].doubleSided = true;
  const FrameInputs inputs = draw(scene);
  EXPECT_EQ(objectAt(inputs, kMiddleX, kMiddleY), 1.0f);
  EXPECT_EQ(glm::vec3(inputs.normal.download().texel(kMiddleX, kMiddleY)), glm::vec3(0, 0, 1));
  scene.nodes[static_cast<std::size_t>(quad)].scale.x = -1.0f; // a mirrored back face is a front face
  scene.materials[0].doubleSided = false;
  EXPECT_EQ(objectAt(draw(scene), kMiddleX, kMiddleY), 0.0f) << "mirroring along x turns no side";
}

TEST_F(SceneRendererTest, KeepsSidesAndNormalsOfMirroredObjects) {
  Scene scene = emptyScene();
  const int quad = addQuad(scene, {0, 0, 0}, kRight, kUp);
  for (const bool doubleSided : {false, true}) {
    scene.materials[0].doubleSided = doubleSided;
    scene.nodes[static_cast<std::size_t>(quad)].scale = {-1, 1, 1};
    const FrameInputs inputs = draw(scene);
    EXPECT_EQ(objectAt(inputs, kMiddleX, kMiddleY), 1.0f);
    EXPECT_EQ(glm::vec3(inputs.normal.download().texel(kMiddleX, kMiddleY)), glm::vec3(0, 0, 1));
  }
}

TEST_F(SceneRendererTest, ReadsNormalMapsInTheFrameOfTheTangents) {
  Scene scene = emptyScene();
  scene.images.push_back(
      {"to the right", 1, 1, {255, 128, 128, 255}}); // leans to +x: (1, 0, 0) of the tangent frame
  scene.materials[0].normalTexture.image = 0;
  const int quad = addQuad(scene, {0, 0, 0}, kRight, kUp);
  // 128/255 is not quite the middle.
  glm::vec3 normal(draw(scene).normal.download().texel(kMiddleX, kMiddleY));
  EXPECT_NEAR(normal.x, 1.0f, 0.01f);
  scene.nodes[static_cast<std::size_t>(quad)].scale.x = -1.0f;
  normal = glm::vec3(draw(scene).normal.download().texel(kMiddleX, kMiddleY));
  EXPECT_NEAR(normal.x, -1.0f, 0.01f) << "a mirrored bump leans the other way";
}

TEST_F(SceneRendererTest, NumbersObjectsInTheOrderOfTheNodes) {
  Scene scene = emptyScene();
  addQuad(scene, {-5, 0, 0}, kRight, kUp);
  addQuad(scene, {5, 0, 0}, kRight, kUp);
  scene.nodes[2].mesh = scene.nodes[1].mesh; // an instance of the first
  const FrameInputs inputs = draw(scene);
  EXPECT_EQ(objectAt(inputs, kWidth / 4, kMiddleY), 1.0f);
  EXPECT_EQ(objectAt(inputs, 3 * kWidth / 4, kMiddleY), 2.0f);
}

// Drivers refuse labels from 256 bytes on, and what an object is made with adds to its name.
TEST_F(SceneRendererTest, TakesNamesOfAnyLength) {
  for (const std::size_t length : {241u, 256u, 100000u}) {
    Scene scene = emptyScene();
    addQuad(scene, {0, 0, 0}, kRight, kUp);
    scene.meshes[0].name = std::string(length, 'x');
    EXPECT_EQ(objectAt(draw(scene), kMiddleX, kMiddleY), 1.0f) << length;
  }
}

TEST_F(SceneRendererTest, LightsAMatteWhitePlaneByTheCosine) {
  Scene scene = emptyScene();
  scene.materials[0].unlit = false;
  scene.materials[0].metallic = 0.0f;
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0.0f);
  addQuad(scene, {0, 0, 0}, kRight, kUp);
  Node lamp;
  lamp.light = 0;
  lamp.rotation = glm::angleAxis(glm::radians(60.0f), glm::vec3(0, 1, 0)); // 60° off the plane's normal
  scene.nodes.push_back(lamp);
  Light light;
  light.node = static_cast<int>(scene.nodes.size()) - 1;
  light.intensity = 2.0f;
  scene.lights.push_back(light);
  const float lit = draw(scene).color.download().texel(kMiddleX, kMiddleY).x;
  // Diffuse E·cos/π, and a little of the rough 4 % mirror.
  EXPECT_GT(lit, 2.0f * 0.5f / 3.14159f);
  EXPECT_LT(lit, 2.0f * 0.5f / 3.14159f * 1.1f);
  scene.lights[0].intensity = 4.0f;
  EXPECT_FLOAT_EQ(draw(scene).color.download().texel(kMiddleX, kMiddleY).x, 2.0f * lit);
}

TEST_F(SceneRendererTest, DrawsLinesAndPoints) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, kRight, kUp);
  Primitive& primitive = scene.meshes[0].primitives[0];
  primitive.topology = Topology::Points;
  primitive.indices = {0, 1, 2, 3};
  primitive.vertices[0].position = glm::vec3(0.0f);
  EXPECT_EQ(objectAt(draw(scene), kMiddleX, kMiddleY), 1.0f);
  primitive.topology = Topology::Lines;
  primitive.indices = {1, 3}; // a diagonal through the middle
  const Image ids = draw(scene).objectId.download();
  int drawn = 0;
  for (const float id : ids.pixels) drawn += id == 1.0f;
  EXPECT_GT(drawn, 30) << "the quad is 31 px wide";
  EXPECT_LT(drawn, 80);
}

TEST_F(SceneRendererTest, SurvivesAScaleOfNothingAndAnEmptyScene) {
  Scene scene = emptyScene();
  const int quad = addQuad(scene, {0, 0, 0}, kRight, kUp);
  scene.nodes[static_cast<std::size_t>(quad)].scale = glm::vec3(0.0f);
  for (const float value : draw(scene).color.download().pixels) ASSERT_TRUE(std::isfinite(value));
  for (const float value : draw(emptyScene()).color.download().pixels) ASSERT_TRUE(std::isfinite(value));
}

TEST_F(SceneRendererTest, KeepsDrawingWithTheOldShadersWhenTheNewOnesDoNotCompile) {
  Scene scene = emptyScene();
  addQuad(scene, {0, 0, 0}, kRight, kUp);
  const test::ShaderFolder shaders;
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameInputs inputs;
  const auto middle = [&] {
    renderer.draw(request(), 0, inputs);
    return inputs.color.download().texel(kMiddleX, kMiddleY);
  };
  EXPECT_EQ(middle(), glm::vec4(1.0f));
  shaders.replace("scene/mesh.frag", "baseColor.rgb);", "0.5 * baseColor.rgb);");
  renderer.reloadShaders();
  EXPECT_EQ(middle(), glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
  shaders.replace("scene/mesh.frag", "0.5 * baseColor.rgb);", "0.25 * nothing);");
  EXPECT_THROW(renderer.reloadShaders(), Error);
  EXPECT_EQ(middle(), glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
}

TEST_F(SceneRendererTest, StopsUploadingWhenToldTo) {
  Scene scene = emptyScene();
  addQuad(scene, {-5, 3, 0}, kRight, kUp);
  const auto shared = std::make_shared<const Scene>(std::move(scene));
  EXPECT_THROW(SceneRenderer(shared, [](std::string_view, int, int) { return false; }), Cancelled);
}

TEST_F(SceneRendererTest, NamesTheCamerasThereAreWhenAskedForAnother) {
  FrameRequest asked = request();
  asked.camera = "gltf:nobody";
  EXPECT_THROW(draw(emptyScene(), asked), Error);
}

} // namespace
} // namespace taa
