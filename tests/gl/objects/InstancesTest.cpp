// Many objects of one small mesh are drawn by few calls, and no bit of the inputs tells of it: the same as
// from meshes of their own, of which each is drawn by itself.
#include "core/render/passes/DrawCalls.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/Pose.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/SmallScene.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

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
  calls.clear();
  EXPECT_TRUE(calls.calls().empty());
}

TEST_F(InstancesTest, AreUploadedInBatchesWhoseBlocksFitABufferOfThreeMiB) {
  constexpr std::size_t kObjects = 30000;
  DrawCalls calls;
  calls.clear();
  for (std::size_t i = 0; i < kObjects; ++i) calls.add(i % 10000 != 0); // three meshes
  std::size_t next = 0, batches = 0;
  for (const DrawCalls::Call& call : calls.calls()) {
    EXPECT_EQ(call.first, next);
    EXPECT_LE(call.offset + call.count * sizeof(shared::DrawBlock), std::size_t(3) << 20);
    next += call.count;
    batches = call.batch + 1;
  }
  EXPECT_EQ(next, kObjects);
  EXPECT_GE(batches, 4u);
  EXPECT_LE(calls.calls().size(), batches + 2) << "a call ends where a mesh or a batch does";
}

/// A node with instances, and one with a node below it for each of them.
enum class InstancedBy { Instances, Nodes };

Scene instancedQuads(InstancedBy by) {
  Scene scene = emptyScene();
  scene.materials[0].unlit = false;
  const int parent = addQuad(scene, {0, 0, 0}, {0.7f, 0, 0}, {0, 0.6f, 0});
  const int mesh = scene.nodes[static_cast<std::size_t>(parent)].mesh;
  test::jump(scene, parent, AnimationPath::Translation, glm::vec4(0.0f), {0.3f, -0.2f, 0.5f, 0.0f});
  if (by == InstancedBy::Instances) {
    scene.nodes[static_cast<std::size_t>(parent)].firstInstance = 0;
    scene.nodes[static_cast<std::size_t>(parent)].instanceCount = kSide * kSide;
  } else {
    scene.nodes[static_cast<std::size_t>(parent)].mesh = -1;
  }
  for (int i = 0; i < kSide * kSide; ++i) {
    Node node;
    node.parent = parent;
    node.mesh = mesh;
    node.translation = {1.3f * static_cast<float>(i % kSide) - 4.5f,
                        0.9f * static_cast<float>(i / kSide) - 3.1f, -0.37f * static_cast<float>(i % 5)};
    node.rotation = glm::angleAxis(0.11f * static_cast<float>(i), glm::normalize(glm::vec3(1, 2, 3)));
    node.scale = {i % 3 == 1 ? -1.0f : 1.0f, 1.0f + 0.01f * static_cast<float>(i), 1.0f};
    if (by == InstancedBy::Instances)
      scene.instances.push_back(instanceTransform(node.translation, node.rotation, node.scale));
    else
      scene.nodes.push_back(node);
  }
  return scene;
}

TEST_F(InstancesTest, OfANodeAreDrawnAsNodesBelowItAre) {
  SceneRenderer instances(std::make_shared<const Scene>(instancedQuads(InstancedBy::Instances)));
  SceneRenderer nodes(std::make_shared<const Scene>(instancedQuads(InstancedBy::Nodes)));
  FrameInputs one, other;
  for (const int frame : {0, 1, 2}) {
    instances.draw(request(BlendedAs::Mask), frame, one);
    nodes.draw(request(BlendedAs::Mask), frame, other);
    expectSameBits(one, other, "frame " + std::to_string(frame));
    EXPECT_EQ(instances.counts().objects, kSide * kSide);
    EXPECT_EQ(instances.counts().drawn, nodes.counts().drawn);
    EXPECT_EQ(instances.counts().triangles, nodes.counts().triangles);
  }
}

/// Many instances at one place and one more somewhere else, which is the farthest, so that its block is of
/// the last batch.
Scene crowdedInstances(int count) {
  Scene scene = emptyScene();
  Node& node = scene.nodes[static_cast<std::size_t>(addQuad(scene, {0, 0, 0}, {2, 0, 0}, {0, 2, 0}))];
  node.firstInstance = 0;
  node.instanceCount = count;
  const glm::quat upright(1, 0, 0, 0);
  for (int i = 0; i + 1 < count; ++i)
    scene.instances.push_back(
        instanceTransform({-4, 0, -1e-4f * static_cast<float>(i)}, upright, glm::vec3(1)));
  scene.instances.push_back(instanceTransform({4, 0, -5}, upright, glm::vec3(1)));
  return scene;
}

TEST_F(InstancesTest, MayBeMoreThanABufferHolds) {
  constexpr int kCount = 20000;
  const auto scene = std::make_shared<const Scene>(crowdedInstances(kCount));
  SceneRenderer renderer(scene), anew(scene);
  FrameInputs inputs, other;
  FrameRequest asked = request(BlendedAs::Mask);
  // 60° from bottom to top: 64 px are 2·10·tan 30° m at 10 m, and 1.5 times as many at 15 m.
  const double pixelsOfMeter = kHeight / (20.0 * std::tan(glm::radians(30.0)));
  const int near = static_cast<int>(kWidth / 2 - 4 * pixelsOfMeter);
  const int far = static_cast<int>(kWidth / 2 + 4 * pixelsOfMeter / 1.5);
  // The second time only the jitter is another: blocks of the first batch are not in the buffer any more.
  for (const glm::vec2 jitter : {glm::vec2(0.0f), glm::vec2(0.25f, -0.25f)}) {
    asked.jitterPx = jitter;
    renderer.draw(asked, 1, inputs);
    const Image ids = inputs.objectId.download();
    EXPECT_EQ(ids.texel(near, kHeight / 2).x, 1.0f);
    EXPECT_EQ(ids.texel(far, kHeight / 2).x, static_cast<float>(kCount));
  }
  anew.draw(asked, 1, other);
  expectSameBits(inputs, other, "drawn again with another jitter");
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// Bytes that are in use, those of llvmpipe's buffers among them.
std::size_t bytesInUse() {
  const struct mallinfo2 use = mallinfo2();
  return use.uordblks + use.hblkhd;
}

/// What a scene of so many instances and its renderer hold once it has been drawn: what is given back with
/// them, which the memory of the driver for its own work is not.
std::size_t bytesToDraw(int count) {
  auto kept = std::make_optional<SceneRenderer>(std::make_shared<const Scene>(crowdedInstances(count)));
  SceneRenderer& renderer = *kept;
  FrameInputs inputs;
  for (int frame = 0; frame < 3; ++frame) renderer.draw(request(BlendedAs::Mask), frame, inputs);
  EXPECT_EQ(renderer.counts().drawn, count);
  // The driver keeps some hundred bytes for each triangle of a frame until it takes up its memory again,
  // which is after as many frames as it may have under way: 64 in llvmpipe on a busy machine.
  constexpr int kFramesOfDriver = 64;
  FrameRequest pixel = request(BlendedAs::Mask);
  pixel.part = gl::Rect{0, 0, 1, 1};
  for (int frame = 3; frame < 4 + kFramesOfDriver; ++frame) {
    renderer.draw(pixel, frame, inputs);
    inputs.color.download();
  }
  const std::size_t full = bytesInUse();
  kept.reset();
  return full - bytesInUse();
}

TEST_F(InstancesTest, TakeLessThan200BytesEach) {
  constexpr std::size_t kCount = 100000;
  bytesToDraw(8); // what is made once
  const std::size_t few = bytesToDraw(8), many = bytesToDraw(kCount);
  const double each = (static_cast<double>(many) - static_cast<double>(few)) / kCount;
  EXPECT_LT(each, 200.0);
  EXPECT_GT(each, 48.0) << "their place in the scene alone";
}
#endif

} // namespace
} // namespace taa
