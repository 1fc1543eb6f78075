// Many objects of one small mesh are drawn by few calls, and no bit of the inputs tells of it: the same as
// from meshes of their own, of which each is drawn by itself.
#include "core/render/SceneRenderer.h"
#include "core/render/passes/DrawCalls.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/SmallScene.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <cstring>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 96, kHeight = 64, kSide = 8;

using test::addQuad;
using test::emptyScene;
using test::kEye;

enum class Sharing { OneMesh, OwnMeshes };

/// 64 tilted quads before one another, some of them mirrored, below a node that jumps after the first frame,
/// and each of them jumps by itself.
Scene manyQuads(Sharing sharing, AlphaMode mode) {
  Scene scene = emptyScene();
  scene.materials[0].unlit = false;
  scene.materials[0].alphaMode = mode;
  scene.materials[0].baseColor = {0.9f, 0.6f, 0.3f, 0.7f};
  scene.materials[0].alphaCutoff = 0.5f;
  const int parent = static_cast<int>(scene.nodes.size());
  scene.nodes.emplace_back();
  for (int i = 0; i < kSide * kSide; ++i) {
    const glm::vec3 place(1.3f * static_cast<float>(i % kSide) - 4.5f,
                          0.9f * static_cast<float>(i / kSide) - 3.1f, -0.37f * static_cast<float>(i % 5));
    const int node = addQuad(scene, place, {0.7f, 0, 0}, {0, 0.6f, 0});
    Node& quad = scene.nodes[static_cast<std::size_t>(node)];
    quad.parent = parent;
    quad.rotation = glm::angleAxis(0.11f * static_cast<float>(i), glm::normalize(glm::vec3(1, 2, 3)));
    quad.scale = {i % 3 == 1 ? -1.0f : 1.0f, 1.0f + 0.01f * static_cast<float>(i), 1.0f};
    if (sharing == Sharing::OneMesh) quad.mesh = scene.nodes[static_cast<std::size_t>(parent) + 1].mesh;
    const glm::vec4 after(place + glm::vec3(0.02f * static_cast<float>(i), 0.1f, 0.0f), 0.0f);
    test::jump(scene, node, AnimationPath::Translation, glm::vec4(place, 0.0f), after);
  }
  test::jump(scene, parent, AnimationPath::Translation, glm::vec4(0.0f), {0.3f, -0.2f, 0.5f, 0.0f});
  return scene;
}

FrameRequest request(BlendedAs blended) {
  FrameRequest request;
  request.camera = kEye;
  request.width = kWidth;
  request.height = kHeight;
  request.inputs.mask = MaskSource::Material;
  request.inputs.blended = blended;
  return request;
}

void expectSameBits(const FrameInputs& a, const FrameInputs& b, const std::string& what) {
  for (const auto texture :
       {&FrameInputs::color, &FrameInputs::depth, &FrameInputs::motion, &FrameInputs::normal,
        &FrameInputs::objectId, &FrameInputs::previousDepth, &FrameInputs::mask}) {
    const Image left = (a.*texture).download(), right = (b.*texture).download();
    ASSERT_EQ(left.pixels.size(), right.pixels.size()) << what;
    EXPECT_EQ(std::memcmp(left.pixels.data(), right.pixels.data(), left.pixels.size() * sizeof(float)), 0)
        << what << ", texture " << (a.*texture).width();
  }
}

class InstancesTest : public test::GlTest {};

TEST_F(InstancesTest, AreDrawnAsEachByItself) {
  if (!isExact()) GTEST_SKIP() << "two programs, and this driver rounds each as it likes";
  for (const AlphaMode mode : {AlphaMode::Opaque, AlphaMode::Mask, AlphaMode::Blend}) {
    SceneRenderer together(std::make_shared<const Scene>(manyQuads(Sharing::OneMesh, mode)));
    SceneRenderer apart(std::make_shared<const Scene>(manyQuads(Sharing::OwnMeshes, mode)));
    FrameInputs one, other;
    for (const int frame : {0, 1, 2}) {
      FrameRequest asked = request(BlendedAs::BeforeWithMotion);
      together.draw(asked, frame, one);
      apart.draw(asked, frame, other);
      expectSameBits(one, other,
                     "mode " + std::to_string(static_cast<int>(mode)) + ", frame " + std::to_string(frame));
      EXPECT_EQ(together.counts().drawn, apart.counts().drawn);
    }
    std::set<float> ids;
    for (const float id : one.objectId.download().pixels) ids.insert(id);
    EXPECT_GT(ids.size(), mode == AlphaMode::Blend ? 0u : 40u) << "most of them are seen";
  }
}

// Depth and number of the object at a pixel are those of the nearest quad, whichever call drew it.
TEST_F(InstancesTest, HaveTransformsOfTheirOwnInBothFrames) {
  Scene scene = emptyScene();
  std::vector<int> nodes;
  for (int i = 0; i < kSide; ++i) {
    const glm::vec3 place(1.5f * static_cast<float>(i) - 5.25f, 0, 0);
    nodes.push_back(addQuad(scene, place, {1, 0, 0}, {0, 1, 0}));
    scene.nodes[static_cast<std::size_t>(nodes.back())].mesh =
        scene.nodes[static_cast<std::size_t>(nodes.front())].mesh;
    // 10 m before the camera, up by i tenths of a meter.
    test::jump(scene, nodes.back(), AnimationPath::Translation, glm::vec4(place, 0.0f),
               glm::vec4(place + glm::vec3(0, 0.1f * static_cast<float>(i), 0), 0.0f));
  }
  SceneRenderer renderer(std::make_shared<const Scene>(std::move(scene)));
  FrameInputs inputs;
  renderer.draw(request(BlendedAs::Mask), 1, inputs);
  const Image ids = inputs.objectId.download(), motion = inputs.motion.download();
  // 60° from bottom to top: the picture is 2·10·tan 30° m high.
  const double pixelsOfMeter = kHeight / (20.0 * std::tan(glm::radians(30.0)));
  for (int i = 0; i < kSide; ++i) {
    const int x = static_cast<int>(kWidth / 2 + pixelsOfMeter * (1.5 * i - 5.25));
    const int y = static_cast<int>(kHeight / 2 - pixelsOfMeter * 0.1 * i);
    EXPECT_EQ(ids.texel(x, y).x, static_cast<float>(i + 1));
    // Up is −y; a half has 11 bits.
    EXPECT_NEAR(motion.texel(x, y).y, -0.1 * i * pixelsOfMeter, 2e-3);
  }
}

TEST_F(InstancesTest, OutsideTheViewAreLeftOutWithoutATrace) {
  Scene scene = manyQuads(Sharing::OneMesh, AlphaMode::Opaque);
  scene.nodes[0].rotation = glm::angleAxis(0.5f, glm::vec3(0, 1, 0)); // the camera's
  SceneRenderer renderer(std::make_shared<const Scene>(std::move(scene)));
  FrameInputs all, culled;
  renderer.setCulling(false);
  renderer.draw(request(BlendedAs::Mask), 1, all);
  EXPECT_EQ(renderer.counts().drawn, kSide * kSide);
  renderer.setCulling(true);
  renderer.draw(request(BlendedAs::Mask), 1, culled);
  EXPECT_LT(renderer.counts().drawn, kSide * kSide);
  EXPECT_GT(renderer.counts().drawn, 0);
  expectSameBits(all, culled, "turned away");
}

TEST_F(InstancesTest, JoinTheCallBeforeThemWhereTheySay) {
  DrawCalls calls;
  calls.clear();
  for (const bool joins : {false, true, true, false, false, true}) calls.add(joins);
  ASSERT_EQ(calls.calls().size(), 3u);
  const std::vector<std::size_t> first{0, 3, 4}, count{3, 1, 2};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(calls.calls()[i].first, first[i]);
    EXPECT_EQ(calls.calls()[i].count, count[i]);
    EXPECT_EQ(calls.calls()[i].offset % gl::uniformAlignment(), 0u);
    EXPECT_EQ(calls.calls()[i].offset % gl::storageAlignment(), 0u);
  }
  EXPECT_GE(calls.calls()[1].offset, 3 * sizeof(shared::DrawBlock));
  calls.fill([](std::size_t) { return shared::DrawBlock{}; });
  calls.clear();
  EXPECT_TRUE(calls.calls().empty());
}

} // namespace
} // namespace taa
