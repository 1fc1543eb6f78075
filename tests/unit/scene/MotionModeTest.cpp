// Which motion objects are given.
#include "core/scene/MotionMode.h"

#include "core/base/Error.h"
#include "core/scene/Scene.h"
#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <string>

namespace taa {
namespace {

/// A parent that draws nothing, and its child that does.
Scene family() {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[0].name = "parent";
  scene.nodes[1].name = "child";
  scene.nodes[1].parent = 0;
  scene.nodes[1].mesh = 0;
  return scene;
}

std::string refusal(const std::string& text) {
  return test::errorOf([&] { parseMotionOverride(text); });
}

TEST(MotionMode, IsReadFromItsFlag) {
  EXPECT_EQ(parseMotionOverride("fan=none"), (MotionOverride{"fan", MotionMode::None}));
  EXPECT_EQ(parseMotionOverride("a=b=cameraOnly"), (MotionOverride{"a=b", MotionMode::CameraOnly}));
  EXPECT_EQ(parseMotionOverride("fan=perObject"), (MotionOverride{"fan", MotionMode::PerObject}));
  for (const std::string text : {"fan", "=none", "fan=", "fan=None"})
    EXPECT_EQ(refusal(text), "\"" + text + "\" is not NODE=MODE; modes are perObject, cameraOnly and none");
}

TEST(MotionMode, OfAnUnknownObjectIsRefusedWithTheNamesThereAre) {
  EXPECT_NO_THROW(checkMotionOverrides(family(), {{"child", MotionMode::None}}));
  try {
    checkMotionOverrides(family(), {{"parent", MotionMode::None}});
    FAIL() << "a node that draws nothing is no object";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "no object is called \"parent\"; there are child");
  }
}

TEST(MotionMode, OfTheFlagReplacesThatOfTheNode) {
  Scene scene = family();
  scene.nodes[1].motionMode = MotionMode::None;
  EXPECT_EQ(nodeStates(scene, {}, 1.0, 0.9)[1].mode, MotionMode::None);
  EXPECT_EQ(nodeStates(scene, {{"child", MotionMode::CameraOnly}}, 1.0, 0.9)[1].mode, MotionMode::CameraOnly);
  EXPECT_EQ(nodeStates(scene, {{"other", MotionMode::CameraOnly}}, 1.0, 0.9)[1].mode, MotionMode::None);
}

TEST(MotionMode, IsTheCamerasInTheFrameInWhichAnAncestorAppearsOrJumps) {
  Scene scene = family();
  scene.nodes[0].visibleFrom = 1.0;
  scene.nodes[0].visibleUntil = 3.0;
  scene.nodes[0].teleports = {2.0};
  const auto at = [&](double time) { return nodeStates(scene, {}, time, time - 0.5)[1]; };
  EXPECT_FALSE(at(0.5).isVisible);
  EXPECT_TRUE(at(1.0).isVisible);
  EXPECT_EQ(at(1.0).mode, MotionMode::CameraOnly);
  EXPECT_EQ(at(1.5).mode, MotionMode::PerObject);
  EXPECT_EQ(at(2.0).mode, MotionMode::CameraOnly);
  EXPECT_EQ(at(2.5).mode, MotionMode::PerObject);
  EXPECT_FALSE(at(3.0).isVisible);
  EXPECT_EQ(nodeStates(scene, {}, 2.0, 2.0)[1].mode, MotionMode::PerObject) << "where history starts";
}

TEST(MotionMode, LeavesForcedMotionForcedWhenSomethingAppears) {
  Scene scene = family();
  scene.nodes[1].visibleFrom = 1.0;
  scene.nodes[1].motionMode = MotionMode::None;
  EXPECT_EQ(nodeStates(scene, {}, 1.0, 0.5)[1].mode, MotionMode::None);
}

} // namespace
} // namespace taa
