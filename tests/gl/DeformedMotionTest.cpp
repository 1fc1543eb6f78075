// Motion of skinned, morphed, cached and swaying vertices, and of objects whose motion is chosen or unknown:
// invariants 9, 14, 15 and 16, against closed forms and against the analytic projection of every pixel.
#include "core/base/Error.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/scene/gltf/GltfLoader.h"
#include "tests/support/frames/AnalyticMotion.h"
#include "tests/support/frames/MotionFixture.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;

using test::addQuad;
using test::emptyScene;
using test::jump;
using test::kHeight;
using test::kP11;
using test::kRight;
using test::kUp;
using test::kWidth;

/// Pixels on the screen of a meter, 10 m away.
constexpr float kPxPerMeter = kP11 * kHeight / 2 / 10.0f;
/// Interpolated 32-bit clip positions have 24 bits of 320 px.
constexpr float kTolerancePx = 2e-4f;
constexpr double kStep = 1.0 / 60.0;

class DeformedMotionTest : public test::MotionFixture {
 protected:
  static void expectMotion(const Image& field, const glm::vec2& expectedPx, float tolerance = kTolerancePx) {
    for (const glm::ivec2 pixel : {glm::ivec2(30, 20), glm::ivec2(160, 90), glm::ivec2(300, 150)}) {
      EXPECT_NEAR(field.texel(pixel.x, pixel.y).x, expectedPx.x, tolerance);
      EXPECT_NEAR(field.texel(pixel.x, pixel.y).y, expectedPx.y, tolerance);
    }
  }
  static void expectNoMotion(const Scene& scene) {
    for (const int frame : {1, 2, 7})
      for (const float value : motion(scene, frame).pixels) ASSERT_EQ(value, 0.0f) << "frame " << frame;
  }
  static void expectAnalytic(const Scene& scene, int frame, double fastest) {
    const test::MotionAgreement agreement = test::compareMotion(scene, draw(scene, request(), frame));
    EXPECT_GT(agreement.compared, 2000);
    EXPECT_GT(agreement.fastestPx, fastest);
    EXPECT_LT(agreement.worstPx, 1e-3) << agreement.worst; // 32-bit positions and matrices, of 320 px
  }
};

Primitive& primitiveOf(Scene& scene, int node) {
  return scene.meshes[static_cast<std::size_t>(scene.nodes[static_cast<std::size_t>(node)].mesh)]
      .primitives[0];
}

int addJoint(Scene& scene, const glm::vec3& place = glm::vec3(0.0f)) {
  scene.nodes.emplace_back().translation = place;
  return static_cast<int>(scene.nodes.size()) - 1;
}

/// Puts the mesh of `node` under two joints: `share` of each vertex follows the second one.
void skin(Scene& scene, int node, const std::vector<int>& joints, float share) {
  Primitive& primitive = primitiveOf(scene, node);
  primitive.influenceSets = 1;
  primitive.influences.assign(primitive.vertices.size(),
                              {glm::vec4(0, 1, 0, 0), glm::vec4(1.0f - share, share, 0, 0)});
  scene.skins.push_back({joints, std::vector<glm::mat4>(joints.size(), glm::mat4(1.0f))});
  scene.nodes[static_cast<std::size_t>(node)].skin = static_cast<int>(scene.skins.size()) - 1;
}

/// A morph target that moves all vertices of `node` by `delta`.
void addTarget(Scene& scene, int node, const glm::vec3& delta, float weight) {
  Primitive& primitive = primitiveOf(scene, node);
  primitive.targets.emplace_back(primitive.vertices.size(), MorphDelta{delta, {}, {}});
  if (primitive.targets.size() == 1)
    scene.nodes[static_cast<std::size_t>(node)].firstWeight = static_cast<int>(scene.morphWeights.size());
  scene.morphWeights.push_back(weight);
}

void animateWeights(Scene& scene, int node, const std::vector<float>& before,
                    const std::vector<float>& after) {
  jump(scene, node, AnimationPath::Weights, {}, {});
  AnimationChannel& channel = scene.animations.front().channels.back();
  channel.values.clear();
  channel.weightCount = static_cast<int>(before.size());
  channel.weights = before;
  channel.weights.insert(channel.weights.end(), after.begin(), after.end());
}

void addVelocity(Scene& scene, int node, const glm::vec3& velocity) {
  Primitive& primitive = primitiveOf(scene, node);
  primitive.cache.frames = 1;
  for (const Vertex& vertex : primitive.vertices)
    primitive.cache.entries.push_back({vertex.position, vertex.normal, velocity});
}

/// A plane that sways sideways as a whole: all of its vertices are equally far along the wave.
int addSwayingPlane(Scene& scene, float amplitude, float frequency) {
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  for (Vertex& vertex : primitiveOf(scene, plane).vertices) vertex.uv1.y = 1.0f;
  scene.materials[0].wind = {amplitude, 0.0f, frequency, {1, 0, 0}};
  return plane;
}

TEST_F(DeformedMotionTest, OfASkinWithOneJointIsThatOfARigidThing) {
  for (const float share : {0.0f, 0.5f, 1.0f}) {
    Scene scene = emptyScene();
    const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
    const int first = addJoint(scene), second = addJoint(scene);
    skin(scene, plane, {first, second}, share);
    for (const int joint : {first, second})
      jump(scene, joint, AnimationPath::Translation, {0, 0, 0, 0}, {0.1f, 0.05f, 0, 0});
    expectMotion(motion(scene), {0.1f * kPxPerMeter, -0.05f * kPxPerMeter});
  }
}

// Techniques: 3.4.
TEST_F(DeformedMotionTest, OfAVertexBetweenTwoJointsIsTheirWeightedMean) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  const int first = addJoint(scene), second = addJoint(scene);
  skin(scene, plane, {first, second}, 0.25f);
  jump(scene, second, AnimationPath::Translation, {0, 0, 0, 0}, {0.4f, 0, 0, 0});
  expectMotion(motion(scene), {0.1f * kPxPerMeter, 0.0f});
}

TEST_F(DeformedMotionTest, OfASkinHasTheMotionOfItsRootOnceAndNoneOfItsNode) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  const int root = addJoint(scene), joint = addJoint(scene);
  scene.nodes[static_cast<std::size_t>(joint)].parent = root;
  skin(scene, plane, {joint, joint}, 0.5f);
  jump(scene, root, AnimationPath::Translation, {0, 0, 0, 0}, {0.1f, 0, 0, 0});
  jump(scene, joint, AnimationPath::Translation, {0, 0, 0, 0}, {0, 0.05f, 0, 0});
  jump(scene, plane, AnimationPath::Translation, {0, 0, 0, 0}, {7, 7, 0, 0}); // glTF: does not count
  expectMotion(motion(scene), {0.1f * kPxPerMeter, -0.05f * kPxPerMeter});
}

// Techniques: 3.5.
TEST_F(DeformedMotionTest, OfAMorphTargetIsTheStepOfItsWeight) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  addTarget(scene, plane, {0.4f, 0, 0}, 0.0f);
  addTarget(scene, plane, {0, 0.2f, 0}, 0.0f);
  animateWeights(scene, plane, {0.5f, 1.0f}, {0.75f, 0.5f});
  expectMotion(motion(scene), {0.25f * 0.4f * kPxPerMeter, 0.5f * 0.2f * kPxPerMeter});
}

// Techniques: 3.6.
TEST_F(DeformedMotionTest, OfACachedVertexIsItsVelocityTimesTheStep) {
  for (const double rate : {60.0, 30.0}) { // twice as long a step, twice the motion
    Scene scene = emptyScene();
    scene.shot.framesPerSecond = rate;
    const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
    addVelocity(scene, plane, {3.0f, -1.5f, 0.0f});
    const float step = static_cast<float>(1.0 / rate);
    expectMotion(motion(scene), {3.0f * step * kPxPerMeter, 1.5f * step * kPxPerMeter});
  }
}

TEST_F(DeformedMotionTest, OfACachedVertexFollowsPerspective) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  addVelocity(scene, plane, {0.0f, 0.0f, 60.0f}); // comes 1 m nearer: it was 11 m away
  const FrameInputs inputs = draw(scene, request());
  const Image field = inputs.motion.download();
  const float x = 300.5f - 160.0f - inputs.info.jitterPx.x;
  EXPECT_NEAR(field.texel(300, 90).x, x - x * 10.0f / 11.0f, 1e-3f);
  EXPECT_NEAR(inputs.previousDepth.download().texel(300, 90).x, 11.0f, 1e-5f);
}

// Techniques: 3.7.
TEST_F(DeformedMotionTest, OfSwayingVerticesIsTheFormulaAtBothTimes) {
  constexpr double kAmplitude = 0.3, kFrequency = 9.0;
  Scene scene = emptyScene();
  addSwayingPlane(scene, float(kAmplitude), float(kFrequency));
  for (const int frame : {1, 5, 11}) {
    const double moved = std::sin(kFrequency * frame * kStep) - std::sin(kFrequency * (frame - 1) * kStep);
    // A driver's sine may be off by 2⁻²¹ or so, of 0.3 m: a hundred-thousandth of a pixel.
    expectMotion(motion(scene, frame), {float(kAmplitude * moved) * kPxPerMeter, 0.0f}, 1e-3f);
  }
}

TEST_F(DeformedMotionTest, IsExactlyZeroWhereNothingMoves) {
  Scene skinned = emptyScene();
  const int plane = addQuad(skinned, {0, 0, 0}, {4, 1, 3}, {0, 4, 1});
  const int first = addJoint(skinned, {0.3f, 0.1f, 0.7f}), second = addJoint(skinned, {-0.1f, 0.4f, 0.2f});
  skin(skinned, plane, {first, second}, 0.37f);
  expectNoMotion(skinned);
  Scene morphed = emptyScene();
  addTarget(morphed, addQuad(morphed, {0, 0, 0}, {4, 1, 3}, {0, 4, 1}), {0.123f, 0.456f, 0.789f}, 0.7f);
  expectNoMotion(morphed);
  Scene cached = emptyScene();
  addVelocity(cached, addQuad(cached, {0, 0, 0}, {4, 1, 3}, {0, 4, 1}), glm::vec3(0.0f));
  expectNoMotion(cached);
  Scene frozen = emptyScene();
  addSwayingPlane(frozen, 0.3f, 0.0f);
  frozen.materials[0].wind.waveNumber = 1.7f;
  expectNoMotion(frozen);
}

TEST_F(DeformedMotionTest, AddsTheCameraOnce) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  const int first = addJoint(scene), second = addJoint(scene);
  skin(scene, plane, {first, second}, 0.5f);
  for (const int node : {first, second})
    jump(scene, node, AnimationPath::Translation, {0, 0, 0, 0}, {0.1f, 0, 0, 0});
  jump(scene, 0, AnimationPath::Translation, {0, 0, 10, 0}, {0.1f, 0, 10, 0});
  for (const float value : motion(scene).pixels) ASSERT_NEAR(value, 0.0f, kTolerancePx);
}

/// Something of everything on one bent sheet, with the camera moving.
Scene mixedScene() {
  Scene scene = emptyScene();
  const int sheet = addQuad(scene, {0, 0, 0}, {9, 2, 3}, {-1, 7, 2});
  Primitive& primitive = primitiveOf(scene, sheet);
  scene.materials[0].wind = {0.3f, 0.4f, 7.0f, {0.3f, 0.2f, 0.9f}};
  addTarget(scene, sheet, {0.5f, 0.3f, -0.2f}, 0.0f);
  primitive.targets[0][2].position = {-0.5f, 0.8f, 0.4f};
  animateWeights(scene, sheet, {0.1f}, {0.6f});
  addVelocity(scene, sheet, {2.0f, 3.0f, -4.0f});
  const int first = addJoint(scene, {0.3f, 0.1f, 0.2f}), second = addJoint(scene);
  skin(scene, sheet, {first, second}, 0.5f);
  primitive.influences[0].weights = {0.9f, 0.1f, 0, 0};
  jump(scene, first, AnimationPath::Translation, {0.3f, 0.1f, 0.2f, 0}, {0.6f, 0.2f, -0.2f, 0});
  jump(scene, second, AnimationPath::Rotation, {0, 0, 0, 1}, {0, 0, std::sin(0.05f), std::cos(0.05f)});
  jump(scene, 0, AnimationPath::Translation, {0, 0, 10, 0}, {0.2f, -0.1f, 9.8f, 0});
  return scene;
}

TEST_F(DeformedMotionTest, IsTheAnalyticProjectionOfAllOfThemTogether) {
  expectAnalytic(mixedScene(), 1, 5.0);
}

TEST_F(DeformedMotionTest, IsFoundWrongByTheComparisonWhenItIs) {
  Scene scene = mixedScene();
  FrameRequest asked = request();
  asked.inputs.motion = MotionSource::CameraFromDepth;
  const test::MotionAgreement agreement = test::compareMotion(scene, draw(scene, asked));
  EXPECT_GT(agreement.worstPx, 1.0) << "the camera's motion is not the objects'";
}

bool sameBits(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

TEST_F(DeformedMotionTest, IsThatOfTheCameraAloneWhereTheModeSaysSo) {
  Scene scene = mixedScene();
  scene.nodes[1].name = "sheet";
  FrameRequest asked = request();
  asked.motionModes = {{"sheet", MotionMode::CameraOnly}};
  const FrameInputs only = draw(scene, asked), depth = draw(scene, request(MotionSource::CameraFromDepth));
  const Image a = only.motion.download(), b = depth.motion.download();
  for (std::size_t i = 0; i < a.pixels.size(); ++i) ASSERT_NEAR(a.pixels[i], b.pixels[i], 1e-3f);
  EXPECT_TRUE(sameBits(only.color.download(), draw(scene, request()).color.download()))
      << "only motion is another";
}

TEST_F(DeformedMotionTest, IsNothingWhereTheModeForcesNone) {
  Scene scene = mixedScene();
  scene.nodes[1].motionMode = MotionMode::None;
  const FrameInputs inputs = draw(scene, request());
  const Image field = inputs.motion.download(), ids = inputs.objectId.download();
  int onObject = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      if (ids.at(x, y)[0] == 0.0f) continue;
      ++onObject;
      ASSERT_EQ(field.at(x, y)[0], 0.0f);
      ASSERT_EQ(field.at(x, y)[1], 0.0f);
    }
  EXPECT_GT(onObject, 2000);
}

TEST_F(DeformedMotionTest, OfWhatAppearsOrJumpsIsThatOfTheCamera) {
  Scene scene = emptyScene();
  const int plane = addQuad(scene, {0, 0, 0}, kRight, kUp);
  jump(scene, plane, AnimationPath::Translation, {3, 0, 0, 0}, {0, 0, 0, 0});
  jump(scene, 0, AnimationPath::Translation, {0, 0, 10, 0}, {-0.1f, 0, 10, 0});
  Node& node = scene.nodes[static_cast<std::size_t>(plane)];
  const glm::vec2 camera(0.1f * kPxPerMeter, 0.0f);
  expectMotion(motion(scene), camera - glm::vec2(3.0f * kPxPerMeter, 0.0f), 1e-3f);
  node.teleports = {kStep};
  expectMotion(motion(scene), camera);
  node.teleports.clear();
  node.visibleFrom = kStep;
  expectMotion(motion(scene), camera);
  const Image before = draw(scene, request(), 0).objectId.download();
  for (const float id : before.pixels) ASSERT_EQ(id, 0.0f) << "it is not there yet";
}

// Techniques: 3.3.
TEST_F(DeformedMotionTest, IsTheAnalyticProjectionOfEverySourceInTheGallery) {
  const Scene scene = openScene("builtin:gallery");
  FrameRequest asked = request();
  asked.camera = scene.shot.camera;
  asked.width = 2 * kWidth;
  asked.height = 2 * kHeight;
  for (const int frame : {3, 60, 61}) { // 60: a morph changes its way, the cache starts anew
    const test::MotionAgreement agreement = test::compareMotion(scene, draw(scene, asked, frame));
    EXPECT_GT(agreement.compared, 150000);
    EXPECT_GT(agreement.fastestPx, 1.5);
    EXPECT_LT(agreement.worstPx, 2e-3) << "frame " << frame << " " << agreement.worst;
  }
}

class ModelMotionTest : public DeformedMotionTest, public testing::WithParamInterface<const char*> {};

TEST_P(ModelMotionTest, IsTheAnalyticProjectionOfEveryPixel) {
  const fs::path folder = fs::path(TAA_SHARED_DATA) / "models" / GetParam();
  if (!fs::exists(folder)) GTEST_SKIP() << "no shared data at " << folder;
  fs::path file;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".glb" || (file.empty() && entry.path().extension() == ".gltf"))
      file = entry.path();
  Scene scene = loadGltf(file);      // without a ground, which feet go into
  scene.shot.framesPerSecond = 10.0; // larger steps, motion of many pixels
  FrameRequest asked = request();
  asked.camera = "orbit";
  int compared = 0;
  for (const int frame : {1, 4, 9}) {
    const test::MotionAgreement agreement = test::compareMotion(scene, draw(scene, asked, frame));
    compared += agreement.compared;
    EXPECT_GT(agreement.fastestPx, 0.5) << "frame " << frame;
    // Positions of 32 bits through a few matrices, of 320 px.
    EXPECT_LT(agreement.worstPx, 2e-3) << "frame " << frame << " " << agreement.worst;
  }
  EXPECT_GT(compared, 3000);
}

INSTANTIATE_TEST_SUITE_P(All, ModelMotionTest,
                         testing::Values("CesiumMan", "Fox", "RiggedSimple", "RecursiveSkeletons",
                                         "AnimatedMorphCube", "MorphStressTest", "MorphPrimitivesTest",
                                         "SimpleInstancing", "BoxAnimated"),
                         [](const auto& model) { return std::string(model.param); });

} // namespace
} // namespace taa
