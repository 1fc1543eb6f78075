// Motion of what deforms, against the projection of its vertices in both frames (invariants 9, 14), and the
// warp test on real models (invariant 17).
#include "core/render/FrameClock.h"
#include "core/render/SceneRenderer.h"
#include "core/scene/Deform.h"
#include "core/scene/SceneSource.h"
#include "tests/support/GlTest.h"
#include "tests/support/SmallScene.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <filesystem>
#include <functional>

namespace taa {
namespace {

namespace fs = std::filesystem;

using DeformationTest = test::GlTest;

constexpr int kWidth = 320, kHeight = 180;

FrameRequest request(const std::string& camera) {
  FrameRequest request;
  request.camera = camera;
  request.width = kWidth;
  request.height = kHeight;
  request.inputs.precision = Precision::Full;
  return request;
}

/// Every vertex as a point of its own, 3 px wide: all of its pixels have the vertex's own motion.
void showVertices(Scene& scene) {
  for (Mesh& mesh : scene.meshes)
    for (Primitive& primitive : mesh.primitives) {
      primitive.topology = Topology::Points;
      primitive.indices.clear();
      for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
        primitive.indices.push_back(static_cast<std::uint32_t>(i));
    }
}

/// A point in a frame: px from the top left without jitter, and device depth.
struct Projected {
  glm::dvec2 px;
  double depth;
};

Projected project(const glm::mat4& clipFromWorld, const glm::vec3& point) {
  const glm::dvec4 clip = glm::dmat4(clipFromWorld) * glm::dvec4(point, 1.0);
  return {glm::dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * glm::dvec2(kWidth, kHeight),
          clip.z / clip.w};
}

/// Compares the motion of every vertex that can be seen with its projections; says how many were, and the
/// largest difference, px.
struct Comparison {
  int seen = 0, vertices = 0, apart = 0;
  double largestMotion = 0.0;
};

Comparison compareVertices(const Scene& scene, const FrameRequest& asked, int frame) {
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameInputs inputs;
  renderer.draw(asked, frame, inputs);
  const Image motion = inputs.motion.download(), depth = inputs.depth.download();
  const double time = frameTime(scene, frame), before = frameTime(scene, previousFrame(scene, frame));
  const Pose pose = poseAt(scene, time), previousPose = poseAt(scene, before);
  Comparison result;
  for (int node = 0; node < static_cast<int>(scene.nodes.size()); ++node) {
    const int mesh = scene.nodes[static_cast<std::size_t>(node)].mesh;
    if (mesh < 0) continue;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(mesh)].primitives) {
      const Deformer now(scene, node, primitive, pose, time);
      const Deformer then(scene, node, primitive, previousPose, time, time - before);
      for (std::size_t vertex = 0; vertex < primitive.vertices.size(); ++vertex) {
        const Projected at = project(inputs.block.clipFromWorld, now.position(vertex));
        const Projected was = project(inputs.block.previousClipFromWorld, then.position(vertex));
        const glm::ivec2 pixel(glm::floor(at.px + glm::dvec2(inputs.info.jitterPx)));
        ++result.vertices;
        if (pixel.x < 0 || pixel.y < 0 || pixel.x >= kWidth || pixel.y >= kHeight) continue;
        // Another vertex may be before it.
        if (std::abs(depth.texel(pixel.x, pixel.y).x - at.depth) > 1e-6 * at.depth) continue;
        ++result.seen;
        const glm::dvec2 expected = at.px - was.px;
        const glm::dvec2 measured(glm::vec2(motion.texel(pixel.x, pixel.y)));
        result.largestMotion = std::max(result.largestMotion, glm::length(expected));
        // Clip positions have 24 bits, of 320 px; joints add their rounding.
        result.apart += glm::length(measured - expected) > 1e-3 + 1e-4 * glm::length(expected);
      }
    }
  }
  return result;
}

/// A lattice of 9 × 9 points at node 1, two units wide, 10 before the camera.
Scene latticeScene() {
  Scene scene = test::emptyScene();
  const int node = test::addQuad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  Primitive& primitive =
      scene.meshes[static_cast<std::size_t>(scene.nodes[std::size_t(node)].mesh)].primitives[0];
  primitive.vertices.clear();
  for (int i = 0; i < 81; ++i) {
    Vertex vertex;
    vertex.position = {0.5f * float(i % 9 - 4), 0.5f * float(i / 9 - 4), 0.1f * float(i % 5)};
    vertex.uv1 = {0.0f, float(i / 9) / 8.0f};
    primitive.vertices.push_back(vertex);
  }
  showVertices(scene);
  return scene;
}

Primitive& latticeOf(Scene& scene) {
  return scene.meshes.back().primitives.front();
}

int addJoint(Scene& scene, const glm::vec3& place) {
  Node node;
  node.translation = place;
  scene.nodes.push_back(node);
  return static_cast<int>(scene.nodes.size()) - 1;
}

/// Two joints, each vertex between them by its x.
Scene skinnedScene() {
  Scene scene = latticeScene();
  Skin skin;
  skin.joints = {addJoint(scene, {-1, 0, 0}), addJoint(scene, {1, 0, 0})};
  for (const int joint : skin.joints) {
    glm::mat4 inverse(1.0f);
    inverse[3] = glm::vec4(-scene.nodes[std::size_t(joint)].translation, 1.0f);
    skin.inverseBinds.push_back(inverse);
  }
  scene.skins.push_back(skin);
  Primitive& primitive = latticeOf(scene);
  primitive.influenceSets = 1;
  for (const Vertex& vertex : primitive.vertices) {
    const float right = 0.25f * (vertex.position.x + 2.0f);
    primitive.influences.push_back({{0, 1, 0, 0}, {1.0f - right, right, 0, 0}});
  }
  scene.nodes[1].skin = 0;
  scene.nodes[1].translation = {100, 0, 0}; // glTF ignores it
  return scene;
}

glm::vec4 turned(float degrees) {
  const glm::quat q = glm::angleAxis(glm::radians(degrees), glm::vec3(0, 0, 1));
  return {q.x, q.y, q.z, q.w};
}

void expectAllExact(const Scene& scene, double atLeastPx) {
  const Comparison result = compareVertices(scene, request(test::kEye), 1);
  EXPECT_EQ(result.seen, 81);
  EXPECT_EQ(result.apart, 0);
  EXPECT_GT(result.largestMotion, atLeastPx) << "nothing moves, so nothing is shown";
  const Comparison start = compareVertices(scene, request(test::kEye), 0);
  EXPECT_EQ(start.largestMotion, 0.0);
}

TEST_F(DeformationTest, OfASkinIsThatOfItsJoints) {
  Scene scene = skinnedScene();
  test::jump(scene, scene.skins[0].joints[1], AnimationPath::Rotation, turned(0), turned(20));
  test::jump(scene, scene.skins[0].joints[0], AnimationPath::Translation, {-1, 0, 0, 0}, {-1, 0.25f, 0, 0});
  expectAllExact(scene, 5.0);
}

TEST_F(DeformationTest, OfASkinWithOneJointIsThatOfARigidNode) {
  Scene rigid = latticeScene();
  Scene skinned = skinnedScene();
  for (Influence& influence : latticeOf(skinned).influences) influence = {{0, 0, 0, 0}, {0.5f, 0.5f, 0, 0}};
  test::jump(rigid, 1, AnimationPath::Translation, {0, 0, 0, 0}, {0.25f, 0.5f, 0, 0});
  test::jump(skinned, skinned.skins[0].joints[0], AnimationPath::Translation, {-1, 0, 0, 0},
             {-0.75f, 0.5f, 0, 0});
  std::array<Image, 2> fields;
  for (const bool isSkinned : {false, true}) {
    SceneRenderer renderer(std::make_shared<const Scene>(isSkinned ? skinned : rigid));
    FrameInputs inputs;
    renderer.draw(request(test::kEye), 1, inputs);
    fields[isSkinned] = inputs.motion.download();
  }
  for (std::size_t i = 0; i < fields[0].pixels.size(); ++i)
    ASSERT_NEAR(fields[0].pixels[i], fields[1].pixels[i], 1e-3f); // matrices are multiplied in another order
}

TEST_F(DeformationTest, OfMorphTargetsIsThatOfTheirWeights) {
  Scene scene = latticeScene();
  Primitive& primitive = latticeOf(scene);
  primitive.targets.resize(2);
  for (const Vertex& vertex : primitive.vertices) {
    primitive.targets[0].push_back({0.5f * vertex.position, {}});
    primitive.targets[1].push_back({{0, 0.25f * vertex.position.x, 0.3f}, {}});
  }
  scene.nodes[1].firstWeight = 0;
  scene.morphWeights = {0.0f, 0.0f};
  test::jump(scene, 1, AnimationPath::Translation, {0, 0, 0, 0}, {0.1f, 0, 0, 0});
  AnimationChannel channel;
  channel.node = 1;
  channel.path = AnimationPath::Weights;
  channel.interpolation = Interpolation::Step;
  channel.times = scene.animations[0].channels[0].times;
  channel.weightCount = 2;
  channel.weights = {0.25f, 0.0f, 0.5f, 1.0f};
  scene.animations[0].channels.push_back(channel);
  expectAllExact(scene, 5.0);
}

TEST_F(DeformationTest, OfACacheIsItsVelocityTimesTheStep) {
  Scene scene = latticeScene();
  Primitive& primitive = latticeOf(scene);
  primitive.cache.frames = 2;
  primitive.cache.framesPerSecond = 60.0;
  for (int frame = 0; frame < 2; ++frame)
    for (const Vertex& vertex : primitive.vertices)
      primitive.cache.entries.push_back({vertex.position + glm::vec3(0.2f * float(frame), 0, 0),
                                         {0, 0, 1},
                                         {12.0f, 3.0f * vertex.position.y, 0.0f}});
  expectAllExact(scene, 1.0);
}

TEST_F(DeformationTest, OfWindIsThatOfTheWaveAMomentAgo) {
  Scene scene = latticeScene();
  scene.materials[0].wind = {0.5f, 1.5f, 20.0f, {0.6f, 0.0f, 0.8f}};
  expectAllExact(scene, 1.0);
}

/// Pixels of objects whose previous depth is that of the previous frame's picture at pixel − motion, of those
/// that had a place there.
struct Warp {
  int pixels = 0, agree = 0;
};

Warp warp(const Scene& scene, int frame) {
  FrameRequest asked = request("still");
  asked.jitter.sequence = JitterSequence::None;
  SceneRenderer renderer(std::make_shared<const Scene>(scene));
  FrameInputs before, now;
  renderer.draw(asked, frame - 1, before);
  renderer.draw(asked, frame, now);
  const Image motion = now.motion.download(), expected = now.previousDepth.download(),
              ids = now.objectId.download(), previousIds = before.objectId.download(),
              previousDepth = before.depth.download();
  const glm::vec4 terms = before.block.depthTerms;
  const auto viewDepth = [&](const glm::ivec2& p) {
    const float d = previousDepth.texel(p.x, p.y).x;
    return (d * terms.x - terms.y) / (d * terms.z - terms.w);
  };
  // Off disocclusions and silhouettes: all nine previous pixels around belong to the same object.
  const auto isInside = [&](const glm::ivec2& p, float id) {
    if (p.x < 1 || p.y < 1 || p.x >= kWidth - 1 || p.y >= kHeight - 1) return false;
    for (int i = 0; i < 9; ++i)
      if (previousIds.texel(p.x + i % 3 - 1, p.y + i / 3 - 1).x != id) return false;
    return true;
  };
  const auto agrees = [&](const glm::vec2& place, float depth, float id) {
    const glm::ivec2 p(glm::floor(place));
    if (!isInside(p, id)) return false;
    float least = viewDepth(p), most = least; // the place lies somewhere between these pixels
    for (int i = 0; i < 9; ++i) {
      const float d = viewDepth(p + glm::ivec2(i % 3 - 1, i / 3 - 1));
      least = std::min(least, d);
      most = std::max(most, d);
    }
    return depth >= least * (1.0f - 1e-5f) && depth <= most * (1.0f + 1e-5f);
  };
  Warp result;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const float id = ids.texel(x, y).x;
      const glm::vec2 here(float(x) + 0.5f, float(y) + 0.5f), v(motion.texel(x, y));
      if (id == 0.0f || glm::length(v) < 0.02f || !isInside(glm::ivec2(glm::floor(here - v)), id)) continue;
      ++result.pixels;
      result.agree += agrees(here - v, expected.texel(x, y).x, id);
    }
  return result;
}

class WarpTest : public test::GlTest, public testing::WithParamInterface<const char*> {};

TEST_P(WarpTest, ThePreviousFrameAtPixelMinusMotionIsWhatThePixelWas) {
  const fs::path folder = fs::path(TAA_SHARED_DATA) / "models" / GetParam();
  if (!fs::exists(folder)) GTEST_SKIP() << "no shared data at " << folder;
  fs::path file;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb") file = entry.path();
  Scene scene = openScene(file.string());
  int pixels = 0, agree = 0;
  for (const int frame : {7, 20, 41}) {
    const Warp result = warp(scene, frame);
    pixels += result.pixels;
    agree += result.agree;
  }
  EXPECT_GT(pixels, 300) << "hardly anything moves";
  // What folds over itself (an arm before the chest) is one object with two depths.
  EXPECT_GT(agree, 0.97 * pixels) << agree << " of " << pixels;
  RecordProperty("pixels", pixels);
  showVertices(scene);
  const Comparison vertices = compareVertices(scene, request("orbit"), 20);
  EXPECT_GT(vertices.seen, 20);
  EXPECT_LE(vertices.apart, 0.02 * vertices.seen) << "vertices at one place share a pixel";
}

INSTANTIATE_TEST_SUITE_P(Models, WarpTest,
                         testing::Values("CesiumMan", "Fox", "RiggedSimple", "RecursiveSkeletons",
                                         "AnimatedMorphCube", "MorphStressTest"),
                         [](const auto& model) { return std::string(model.param); });

} // namespace
} // namespace taa
