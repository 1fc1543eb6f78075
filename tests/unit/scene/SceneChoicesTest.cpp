// Flown cameras and hidden objects as data: no GL.
#include "core/base/Error.h"
#include "core/io/CameraTrackJson.h"
#include "core/render/FrameRequest.h"
#include "core/render/View.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/SceneOutline.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/frames/GltfSample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa {
namespace {

CameraPose poseAtX(float x) {
  CameraPose pose;
  pose.position.x = x;
  return pose;
}

/// 0 "house" over 1 "door" and 2 unnamed, which is over 3 "knob"; 4 "tree".
Scene treeScene() {
  Scene scene;
  const auto add = [&](const char* name, int parent) {
    Node node;
    node.name = name;
    node.parent = parent;
    scene.nodes.push_back(node);
  };
  add("house", -1);
  add("door", 0);
  add("", 0);
  add("knob", 2);
  add("tree", -1);
  return scene;
}

TEST(ObjectFilter, HidesAndIsolatesWithWhatIsBelow) {
  using Flags = std::vector<bool>;
  const Scene scene = treeScene();
  EXPECT_EQ(drawnNodes(scene, {}), Flags({1, 1, 1, 1, 1}));
  EXPECT_EQ(drawnNodes(scene, {{"#2"}, {}}), Flags({1, 1, 0, 0, 1}));
  EXPECT_EQ(drawnNodes(scene, {{}, {"#2", "tree"}}), Flags({0, 0, 1, 1, 1}));
  EXPECT_EQ(drawnNodes(scene, {{"knob"}, {"house"}}), Flags({1, 1, 1, 0, 0}));
  EXPECT_EQ(drawnNodes(outlineOf(scene, "x"), {{"knob"}, {"house"}}), Flags({1, 1, 1, 0, 0}));
}

TEST(ObjectClass, IsGivenToAnObjectAndToWhatIsBelowUntilThatHasItsOwn) {
  using Classes = std::vector<std::optional<ObjectClass>>;
  const Scene scene = treeScene();
  constexpr std::nullopt_t kOwn = std::nullopt;
  const auto character = ObjectClass::Character, still = ObjectClass::Still;
  EXPECT_EQ(givenClasses(scene, {}), Classes({kOwn, kOwn, kOwn, kOwn, kOwn}));
  EXPECT_EQ(givenClasses(scene, {{"house", character}}),
            Classes({character, character, character, character, kOwn}));
  EXPECT_EQ(givenClasses(scene, {{"#2", still}, {"house", character}}),
            Classes({character, character, still, still, kOwn}));
  EXPECT_EQ(givenClasses(outlineOf(scene, "x"), {{"#2", still}, {"house", character}}),
            Classes({character, character, still, still, kOwn}));
}

TEST(ObjectClass, IsReadFromAFlag) {
  EXPECT_EQ(parseClassOverride("rotor & hub=character"),
            (ClassOverride{"rotor & hub", ObjectClass::Character}));
  EXPECT_EQ(parseClassOverride("a=b=still"), (ClassOverride{"a=b", ObjectClass::Still}));
  for (const char* wrong : {"fan", "=still", "fan=", "fan=sky", "fan=person"})
    EXPECT_THROW(parseClassOverride(wrong), Error) << wrong;
  EXPECT_NO_THROW(checkClassOverrides(treeScene(), {{"#2", ObjectClass::Still}}));
  EXPECT_THROW(checkClassOverrides(treeScene(), {{"gate", ObjectClass::Still}}), Error);
}

TEST(ObjectFilter, NamesTheObjectsThereAre) {
  const Scene scene = treeScene();
  EXPECT_NO_THROW(checkObjectFilter(scene, {{"#2", "door"}, {"tree"}}));
  try {
    checkObjectFilter(scene, {{}, {"gate"}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "no object is called \"gate\"; there are house, door, #2, knob, tree");
  }
}

TEST(ObjectFilter, ShowsTheBeginningOfALongNameAndWhatThereIs) {
  const std::string name(2000, 'x'), shown = name.substr(0, 100) + "…";
  EXPECT_EQ(test::errorOf([&] {
              checkObjectFilter(treeScene(), {{name}, {}});
            }),
            "no object is called \"" + shown + "\"; there are house, door, #2, knob, tree");
  const std::vector<MotionOverride> overrides{{name, MotionMode::None}};
  EXPECT_EQ(test::errorOf([&] {
              checkMotionOverrides(treeScene(), overrides);
            }).find("no object is called \"" + shown + "\"; there are"),
            0u);
  EXPECT_EQ(test::errorOf([&] { cameraAt(openScene("builtin:fan"), name, 0.0, 1.0f); }),
            "there is no camera \"" + shown +
                "\" in builtin:fan; choose one of: still, pan, orbit, dolly, gltf:front");
}

TEST(SceneOutline, FindsTheNodeOfEachObject) {
  const Scene scene = openScene("builtin:fan");
  const SceneOutline outline = outlineOf(scene, "builtin:fan");
  ASSERT_EQ(outline.nodes.size(), scene.nodes.size());
  int objects = 0;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i)
    for (int object = 0; object < outline.nodes[i].objectCount; ++object) {
      ++objects;
      EXPECT_EQ(outline.nodeOf(outline.nodes[i].firstObject + object), static_cast<int>(i));
    }
  EXPECT_GT(objects, 10);
  EXPECT_EQ(outline.nodeOf(0), -1);
  EXPECT_EQ(outline.nodeOf(objects + 1), -1);
}

TEST(SceneOutline, NumbersTheObjectsOfInstancesOneAfterAnother) {
  Scene scene = treeScene();
  scene.meshes.resize(2);
  scene.meshes[0].primitives.resize(2);
  scene.meshes[1].primitives.resize(1);
  scene.meshes[0].primitives[0].indices.assign(6, 0);
  scene.nodes[1].mesh = 0; // two primitives at three instances
  scene.nodes[1].firstInstance = 0;
  scene.nodes[1].instanceCount = 3;
  scene.instances.resize(3);
  scene.nodes[2].mesh = 1;
  scene.nodes[2].firstInstance = 3; // none
  scene.nodes[4].mesh = 1;
  const SceneOutline outline = outlineOf(scene, "x");
  EXPECT_EQ(outline.nodes[1].firstObject, 1);
  EXPECT_EQ(outline.nodes[1].objectCount, 6);
  EXPECT_EQ(outline.nodes[1].triangles, 6u);
  EXPECT_EQ(outline.nodes[2].objectCount, 0);
  EXPECT_EQ(outline.nodes[4].firstObject, 7);
  std::vector<int> nodes;
  for (int object = 0; object <= 8; ++object) nodes.push_back(outline.nodeOf(object));
  EXPECT_EQ(nodes, (std::vector<int>{-1, 1, 1, 1, 1, 1, 1, 4, -1}));
  EXPECT_EQ(outline.objectsBelow(0), (std::vector<int>{1, 2, 3, 4, 5, 6}));
}

TEST(CameraTrack, HoldsItsEnds) {
  CameraTrack track{"t", 5, {poseAtX(1)}};
  track.put(8, poseAtX(2));
  EXPECT_EQ(track.at(0), poseAtX(1));
  EXPECT_EQ(track.at(7), poseAtX(1));
  EXPECT_EQ(track.at(8), poseAtX(2));
  EXPECT_EQ(track.at(100), poseAtX(2));
  CameraTrack other = track;
  EXPECT_FALSE(firstDifference(track, other));
  other.put(6, poseAtX(3)); // and all after it
  EXPECT_EQ(other.at(8), poseAtX(3));
  EXPECT_EQ(firstDifference(track, other), 6);
  // A longer one that rests is the same.
  other = track;
  other.put(20, poseAtX(2));
  EXPECT_FALSE(firstDifference(track, other));
}

TEST(CameraTrack, LooksWhereItSays) {
  const Scene scene = openScene("builtin:fan");
  CameraPose pose{{1, 2, 3}, 90.0f, 0.0f, 60.0f}; // along +x
  const CameraState camera = cameraAt(scene, pose, 2.0f);
  const glm::vec4 ahead = camera.viewFromWorld * glm::vec4(5, 2, 3, 1),
                  right = camera.viewFromWorld * glm::vec4(1, 2, 4, 1);
  EXPECT_NEAR(ahead.z, -4.0f, 1e-5f);
  EXPECT_NEAR(ahead.x, 0.0f, 1e-5f);
  EXPECT_NEAR(right.x, 1.0f, 1e-5f);
  const CameraPose read = poseOf(camera);
  EXPECT_NEAR(glm::length(read.position - pose.position), 0.0f, 1e-5f);
  EXPECT_NEAR(read.yaw, pose.yaw, 1e-4f);
  EXPECT_NEAR(read.pitch, pose.pitch, 1e-4f);
  EXPECT_NEAR(read.fovY, pose.fovY, 1e-4f);
}

// Somebody who takes off from a path sees what they saw.
TEST(CameraTrack, TakesOffWhereACameraIs) {
  const Scene scene = openScene("builtin:fan");
  for (const char* name : {"orbit", "still", "gltf:front"}) {
    const CameraState camera = cameraAt(scene, name, 0.3, 1.5f),
                      flown = cameraAt(scene, poseOf(camera), 1.5f);
    const glm::mat4 wanted = camera.clipFromView * camera.viewFromWorld,
                    got = flown.clipFromView * flown.viewFromWorld;
    for (int column = 0; column < 4; ++column)
      for (int row : {0, 1, 3}) // depth may start elsewhere
        EXPECT_NEAR(got[column][row], wanted[column][row], 2e-4f * (1.0f + std::abs(wanted[column][row])))
            << name;
  }
}

TEST(CameraTrack, RefusesByName) {
  const auto path = [](const std::string& poses, const std::string& more = "",
                       const std::string& name = "\"x\"", const std::string& first = "0") {
    return "{\"name\": " + name + ", \"firstFrame\": " + first + ", \"poses\": " + poses + more + "}";
  };
  const std::string one = "[[0, 0, 0, 0, 0]]", longName(5000, 'n');
  const std::pair<std::string, std::string> cases[] = {
      {path(one, "", "\"x\"", "1e20"), "\"firstFrame\" wants a whole number from 0 to 1000000"},
      {path(one, "", "7"), "\"name\" is not text"},
      {path(one, "", "\"\""), "a camera path needs a name"},
      {path(one, ", \"pose\": 1"), "there is no key \"pose\"; near it is \"poses\""},
      {path("3"), "\"poses\" is not a list"},
      {path(R"({"a": [0, 0, 0, 0, 0]})"), "\"poses\" is not a list"},
      {path("[]"), "the camera path \"x\" has no pose"},
      {path("[]", "", "\"" + longName + "\""),
       "the camera path \"" + std::string(100, 'n') + "…\" has no pose"},
      {path("[[0, 0, 0, 0, 0], 3]"), "\"poses[1]\" is not a list"},
      {path("[[0, 0, 0, 0, 0], [0, 0, 0, 0]]"),
       "\"poses[1]\" has 4 numbers; a pose is [x, y, z, yaw, pitch, fov]"},
      {path("[[0, 0, 0, 0, 0, 45, 1]]"), "\"poses[0]\" has 7 entries, more than the 6 allowed"},
      {path("[[0, 0, 0, 0, 0], [0, 0, null, 0, 0]]"), "\"poses[1][2]\" is not a number"},
      {path("[[0, 0, 0, 0, 0], [0, 1e9, 0, 0, 0]]"),
       "the camera path \"x\" has a pose 1 that is out of range: positions within a million units, pitch "
       "within 89 degrees, field of view 1 to 160 degrees"},
      {"[]", "what the file holds is not an object"},
      {"{}", "the key \"name\" is missing"},
      {"{\"name\":\n", "it ends in line 2, column 1, before it is whole"},
  };
  for (const auto& [text, reason] : cases) {
    const std::filesystem::path file = test::writeTemporary("path.json", text);
    EXPECT_EQ(test::errorOf([&] { readCameraTrack(file); }),
              "cannot read the camera path " + file.string() + ": " + reason);
  }
  EXPECT_EQ(test::errorOf([] { readCameraTrack("/nowhere/a.json"); }),
            "cannot open /nowhere/a.json: No such file or directory");
}

TEST(CameraTrack, ReadsWhatItWrites) {
  CameraTrack track{"Recorded 1", 3, {{{0.1f, 1.0f / 3.0f, -7e-5f}, 12.3f, -45.6f, 31.7f}, poseAtX(9)}};
  EXPECT_EQ(cameraTrackFrom(nlohmann::ordered_json::parse(cameraTrackJson(track).dump())), track);
  EXPECT_EQ(parseCameraPose(poseText(track.poses[0])), track.poses[0]);
  EXPECT_EQ(parseCameraPose("1,2,3,4,5").fovY, CameraPose{}.fovY);
  for (const char* wrong : {"", "1,2,3,4", "1,2,3,4,5,6,7", "1,2,3,4,five", "1,2,3,4,5,", "1 2 3 4 5",
                            "1,2,3,4,90", "nan,0,0,0,0", "1e9,0,0,0,0"})
    EXPECT_THROW(parseCameraPose(wrong), Error) << wrong;
}

TEST(View, HiddenObjectsAreNotDrawnAndATrackIsLookedThrough) {
  const Scene scene = openScene("builtin:fan");
  FrameRequest request{.camera = "orbit", .jitter = {}, .inputs = {}};
  request.filter.hidden = {"rotor"};
  request.track = std::make_shared<const CameraTrack>(CameraTrack{"t", 0, {poseAtX(1), poseAtX(2)}});
  const View view = viewAt(scene, request, 1);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i)
    if (scene.nodes[i].name == "rotor") {
      EXPECT_FALSE(view.nodes[i].isVisible);
    }
  EXPECT_EQ(view.block.cameraPosition.x, 2.0f);
  const glm::vec4 previous = glm::inverse(view.block.previousViewFromWorld)[3];
  EXPECT_EQ(previous.x, 1.0f);
}

} // namespace
} // namespace taa
