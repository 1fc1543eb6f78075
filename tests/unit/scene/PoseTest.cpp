// Where everything is at a time.
#include "core/scene/Pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace taa {
namespace {

AnimationChannel channelOf(AnimationPath path, Interpolation interpolation, std::vector<float> times,
                           std::vector<glm::vec4> values) {
  return {0, path, interpolation, std::move(times), std::move(values)};
}

/// One node moved by one channel over two seconds.
Scene sceneWith(const AnimationChannel& channel, float duration = 2.0f) {
  Scene scene;
  scene.nodes.resize(1);
  scene.animations.push_back({"test", duration, {channel}});
  return scene;
}

glm::vec3 positionAt(const Scene& scene, double time) {
  return glm::vec3(poseAt(scene, time).worldFromNode[0][3]);
}

/// The node's x axis in the world.
glm::vec3 axisAt(const Scene& scene, double time) {
  return glm::vec3(poseAt(scene, time).worldFromNode[0][0]);
}

glm::vec4 aboutZ(float degrees) {
  const float half = glm::radians(0.5f * degrees);
  return {0.0f, 0.0f, std::sin(half), std::cos(half)};
}

const std::vector<float> kTimes{0.0f, 1.0f, 2.0f};
const std::vector<glm::vec4> kPlaces{{1, 0, 0, 0}, {3, 8, 0, 0}, {3, 0, 4, 0}};

TEST(Pose, PlacesInstancesBelowTheirNode) {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[0].translation = {10, 0, 0};
  scene.nodes[0].scale = {2, 2, 2};
  scene.nodes[0].mesh = scene.nodes[1].mesh = 0;
  scene.nodes[0].firstInstance = 1;
  scene.nodes[0].instanceCount = 2;
  const glm::quat upright(1, 0, 0, 0);
  for (const float x : {5.0f, 1.0f, 3.0f})
    scene.instances.push_back(instanceTransform({x, 0, 0}, upright, {1, 3, 1}));
  const Pose pose = poseAt(scene, 0.0);
  EXPECT_EQ(worldFromInstance(scene, pose, {0, 0}) * glm::vec4(0, 1, 0, 1), glm::vec4(12, 6, 0, 1));
  EXPECT_EQ(worldFromInstance(scene, pose, {0, 1}) * glm::vec4(0, 0, 0, 1), glm::vec4(16, 0, 0, 1));
  EXPECT_EQ(worldFromInstance(scene, pose, 1), glm::mat4(1.0f)) << "a node without instances";
}

TEST(Pose, HoldsAStepUntilTheNextKey) {
  const Scene scene = sceneWith(channelOf(AnimationPath::Translation, Interpolation::Step, kTimes, kPlaces));
  EXPECT_EQ(positionAt(scene, 0.0), glm::vec3(1, 0, 0));
  EXPECT_EQ(positionAt(scene, 0.999), glm::vec3(1, 0, 0));
  EXPECT_EQ(positionAt(scene, 1.0), glm::vec3(3, 8, 0));
}

TEST(Pose, GoesStraightBetweenLinearKeys) {
  const Scene scene =
      sceneWith(channelOf(AnimationPath::Translation, Interpolation::Linear, kTimes, kPlaces));
  EXPECT_EQ(positionAt(scene, 0.25), glm::vec3(1.5f, 2, 0));
  EXPECT_EQ(positionAt(scene, 1.0), glm::vec3(3, 8, 0));
  EXPECT_EQ(positionAt(scene, 1.75), glm::vec3(3, 2, 3));
}

TEST(Pose, FollowsTheHermiteCurveOfACubicSpline) {
  // In-tangent, value, out-tangent of each key; two seconds apart, so tangents count double.
  const Scene scene = sceneWith(
      channelOf(AnimationPath::Translation, Interpolation::CubicSpline, {0.0f, 2.0f},
                {{9, 9, 9, 0}, {0, 0, 1, 0}, {1, 0, 0, 0}, {0, 4, 0, 0}, {8, 0, 1, 0}, {9, 9, 9, 0}}),
      4.0f);
  // At u = ½ the weights are ½, ⅛·2, ½, −⅛·2.
  EXPECT_EQ(positionAt(scene, 1.0), glm::vec3(4.25f, -1.0f, 1.0f));
  // At u = ¼: 27/32, 9/64·2, 5/32, −3/64·2.
  EXPECT_EQ(positionAt(scene, 0.5), glm::vec3(1.25f + 0.28125f, -0.375f, 1.0f));
  EXPECT_EQ(positionAt(scene, 0.0), glm::vec3(0, 0, 1));
  EXPECT_EQ(positionAt(scene, 2.0), glm::vec3(8, 0, 1));
}

TEST(Pose, HoldsBeforeTheFirstKeyAndAfterTheLast) {
  const Scene scene = sceneWith(channelOf(AnimationPath::Translation, Interpolation::Linear, {0.5f, 1.0f},
                                          {{1, 2, 3, 0}, {5, 6, 7, 0}}));
  EXPECT_EQ(positionAt(scene, 0.25), glm::vec3(1, 2, 3));
  EXPECT_EQ(positionAt(scene, 1.5), glm::vec3(5, 6, 7));
}

TEST(Pose, RepeatsAfterTheDuration) {
  const Scene scene =
      sceneWith(channelOf(AnimationPath::Translation, Interpolation::Linear, kTimes, kPlaces));
  for (const double time : {0.0, 0.25, 1.0, 1.75}) {
    EXPECT_EQ(positionAt(scene, time), positionAt(scene, time + 2.0));
    EXPECT_EQ(positionAt(scene, time), positionAt(scene, time + 2048.0));
    EXPECT_EQ(positionAt(scene, time), positionAt(scene, time - 2.0));
  }
}

TEST(Pose, TurnsAtConstantSpeedTheShorterWayRound) {
  // The second key is the same turn with the opposite sign: 300° if taken literally, 60° the shorter way.
  const Scene scene = sceneWith(
      channelOf(AnimationPath::Rotation, Interpolation::Linear, {0.0f, 2.0f}, {aboutZ(0), -aboutZ(60)}),
      4.0f);
  const glm::vec3 third = axisAt(scene, 2.0 / 3.0), half = axisAt(scene, 1.0);
  const float tolerance = 1e-6f; // sine and cosine of the slerp
  EXPECT_NEAR(third.x, std::cos(glm::radians(20.0f)), tolerance);
  EXPECT_NEAR(third.y, std::sin(glm::radians(20.0f)), tolerance);
  EXPECT_NEAR(half.x, std::cos(glm::radians(30.0f)), tolerance);
  EXPECT_NEAR(half.y, std::sin(glm::radians(30.0f)), tolerance);
}

TEST(Pose, NormalizesASplinedRotation) {
  const glm::vec4 still(0.0f);
  const Scene scene = sceneWith(channelOf(AnimationPath::Rotation, Interpolation::CubicSpline, {0.0f, 2.0f},
                                          {still, aboutZ(0), still, still, aboutZ(90), still}),
                                4.0f);
  EXPECT_NEAR(glm::length(axisAt(scene, 1.0)), 1.0f, 1e-6f);
  EXPECT_NEAR(axisAt(scene, 1.0).x, std::cos(glm::radians(45.0f)), 1e-6f); // halfway by symmetry
}

TEST(Pose, AppliesScaleThenRotationThenTranslationThenTheParent) {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[0].translation = {10, 0, 0};
  scene.nodes[0].scale = {2, 2, 2};
  scene.nodes[1].parent = 0;
  scene.nodes[1].translation = {0, 5, 0};
  scene.nodes[1].rotation = {0, 0, 0, 1}; // half a turn about z: exact
  scene.nodes[1].scale = {3, 1, -1};
  const glm::mat4 world = poseAt(scene, 0.0).worldFromNode[1];
  EXPECT_EQ(world * glm::vec4(1, 1, 1, 1), glm::vec4(10 - 6, 10 - 2, -2, 1));
}

TEST(Pose, TakesTheMatrixOfANodeThatHasOne) {
  Scene scene;
  scene.nodes.resize(1);
  scene.nodes[0].hasMatrix = true;
  scene.nodes[0].matrix[1] = {0.5f, 1.0f, 0.0f,
                              0.0f}; // a shear, which no translation, rotation and scale can say
  EXPECT_EQ(poseAt(scene, 1.0).worldFromNode[0], scene.nodes[0].matrix);
}

TEST(Pose, GivesTheSameBitsForTheSameTime) {
  const Scene scene = sceneWith(channelOf(AnimationPath::Rotation, Interpolation::Linear, {0.0f, 1.0f, 2.0f},
                                          {aboutZ(0), aboutZ(77), aboutZ(11)}));
  for (int frame = 0; frame < 120; ++frame)
    EXPECT_EQ(poseAt(scene, frame / 60.0).worldFromNode, poseAt(scene, frame / 60.0).worldFromNode);
}

TEST(AnimatedUv, ShowsCellsRowByRowAndShifts) {
  EXPECT_EQ(animatedUv({}, 3.7), glm::vec4(1, 1, 0, 0));
  const UvAnimation book{4, 2, 12.0f};
  for (int frame = 0; frame < 240; ++frame) {
    const int cell = frame / 5 % 8;
    EXPECT_EQ(animatedUv(book, frame / 60.0), glm::vec4(0.25f, 0.5f, 0.25f * static_cast<float>(cell % 4),
                                                        0.5f * static_cast<float>(cell / 4)))
        << frame;
  }
  EXPECT_EQ(animatedUv({1, 1, 0.0f, {0.5f, -0.25f}}, 3.0), glm::vec4(1, 1, 0.5f, 0.25f));
}

} // namespace
} // namespace taa
