// The camera paths of any scene.
#include "core/base/Error.h"
#include "core/scene/Pose.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace taa {
namespace {

const float kNaN = std::numeric_limits<float>::quiet_NaN();
const char* const kFitted[] = {"still", "pan", "orbit", "dolly"};

Scene boxScene(const glm::vec3& min, const glm::vec3& max) {
  Scene scene;
  scene.name = "box";
  scene.bounds.add(min);
  scene.bounds.add(max);
  return scene;
}

bool isFinite(const glm::mat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(matrix[column][row])) return false;
  return true;
}

float depthOf(const glm::mat4& clip, float distance) {
  const glm::vec4 point = clip * glm::vec4(0, 0, -distance, 1);
  return point.z / point.w;
}

/// How far the farthest corner of the bounds lies from the middle of the picture; 1 is the picture's edge.
float extentInView(const Scene& scene, const CameraState& camera) {
  float extent = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 point(corner & 1 ? scene.bounds.max.x : scene.bounds.min.x,
                          corner & 2 ? scene.bounds.max.y : scene.bounds.min.y,
                          corner & 4 ? scene.bounds.max.z : scene.bounds.min.z);
    const glm::vec4 clip = camera.clipFromView * camera.viewFromWorld * glm::vec4(point, 1);
    EXPECT_GT(clip.w, camera.nearPlane);
    extent = std::max({extent, std::abs(clip.x) / clip.w, std::abs(clip.y) / clip.w});
  }
  return extent;
}

TEST(Projection, PutsTheNearPlaneAtOneAndInfinityAtZero) {
  const glm::mat4 clip = perspectiveReversed(0.8f, 1.5f, 0.25f);
  EXPECT_EQ(depthOf(clip, 0.25f), 1.0f);
  EXPECT_EQ(depthOf(clip, 0.5f), 0.5f);
  EXPECT_EQ(depthOf(clip, 1e30f), 0.25f / 1e30f);
  const glm::vec4 infinitelyFar = clip * glm::vec4(0, 0, -1, 0);
  EXPECT_EQ(infinitelyFar.z / infinitelyFar.w, 0.0f);
}

TEST(Projection, FillsThePictureWithTheFieldOfView) {
  const float fovY = 0.8f, aspect = 1.5f;
  const glm::mat4 clip = perspectiveReversed(fovY, aspect, 0.25f);
  const float top = 3.0f * std::tan(0.5f * fovY);
  const glm::vec4 corner = clip * glm::vec4(top * aspect, top, -3.0f, 1.0f);
  EXPECT_NEAR(corner.x / corner.w, 1.0f, 1e-6f); // up is +1: GL clip space
  EXPECT_NEAR(corner.y / corner.w, 1.0f, 1e-6f);
}

TEST(Projection, RunsFromOneToZeroInAnOrthographicView) {
  const glm::mat4 clip = orthographicReversed(4.0f, 2.0f, 1.0f, 9.0f);
  EXPECT_EQ(depthOf(clip, 1.0f), 1.0f);
  EXPECT_EQ(depthOf(clip, 5.0f), 0.5f);
  EXPECT_EQ(depthOf(clip, 9.0f), 0.0f);
  EXPECT_EQ(clip * glm::vec4(4, 2, -1, 1), glm::vec4(1, 1, 1, 1));
}

TEST(CameraPath, NamesTheFittedPathsThenTheScenesOwn) {
  Scene scene;
  scene.cameras.resize(4);
  scene.cameras[1].name = "front";
  scene.cameras[3].name = "front";
  const std::vector<std::string> expected{"still",        "pan",        "orbit",        "dolly",
                                          "gltf:camera0", "gltf:front", "gltf:camera2", "gltf:front#3"};
  EXPECT_EQ(cameraNames(scene), expected);
}

TEST(CameraPath, ShowsTheWholeSceneWhateverTheAspect) {
  for (const float aspect : {0.4f, 1.0f, 16.0f / 9.0f, 4.0f})
    for (const glm::vec3& size :
         {glm::vec3(1), glm::vec3(100, 1, 1), glm::vec3(0.01f, 3, 0.01f), glm::vec3(1e-4f)}) {
      const Scene scene = boxScene(glm::vec3(5), glm::vec3(5) + size);
      for (const std::string name : {"still", "orbit"})
        for (const double time : {0.0, 1.0, 3.3}) {
          const float extent = extentInView(scene, cameraAt(scene, name, time, aspect));
          EXPECT_LT(extent, 0.95f) << name << " " << aspect;
          EXPECT_GT(extent, 0.1f) << name << " " << aspect;
        }
    }
}

TEST(CameraPath, LooksAtTheMiddleFromEveryPathThatDoesNotPan) {
  const Scene scene = boxScene({2, 3, 4}, {4, 5, 6});
  for (const std::string name : {"still", "orbit", "dolly"})
    for (const double time : {0.0, 0.7, 2.0}) {
      const glm::vec4 center = cameraAt(scene, name, time, 1.5f).viewFromWorld * glm::vec4(3, 4, 5, 1);
      EXPECT_NEAR(center.x, 0.0f, 1e-5f);
      EXPECT_NEAR(center.y, 0.0f, 1e-5f);
      EXPECT_LT(center.z, -1.0f);
    }
}

TEST(CameraPath, MovesAFewPixelsAFrameAndNeverJumps) {
  const Scene scene = boxScene(glm::vec3(-1), glm::vec3(1));
  const glm::vec2 halfSize(640, 360);
  const auto pixel = [&](const std::string& name, int frame) {
    const CameraState camera = cameraAt(scene, name, frame / 60.0, 16.0f / 9.0f);
    const glm::vec4 clip = camera.clipFromView * camera.viewFromWorld * glm::vec4(0.5f, 0.5f, 0.5f, 1);
    return glm::vec2(clip) / clip.w * halfSize;
  };
  for (const std::string name : {"pan", "orbit", "dolly"}) {
    float fastest = 0.0f;
    for (int frame = 0; frame < 960; ++frame)
      fastest = std::max(fastest, glm::distance(pixel(name, frame), pixel(name, frame + 1)));
    EXPECT_GT(fastest, 0.5f) << name;
    EXPECT_LT(fastest, 8.0f) << name;
  }
  EXPECT_EQ(pixel("still", 0), pixel("still", 100));
}

TEST(CameraPath, LoopsWithTheShot) {
  Scene scene = boxScene(glm::vec3(-1), glm::vec3(1));
  for (const std::string name : {"pan", "dolly"})
    EXPECT_EQ(cameraAt(scene, name, 0.0, 1.5f).viewFromWorld, cameraAt(scene, name, 4.0, 1.5f).viewFromWorld)
        << name;
  scene.shot.frames = 480;
  EXPECT_EQ(cameraAt(scene, "orbit", 0.0, 1.5f).viewFromWorld,
            cameraAt(scene, "orbit", 8.0, 1.5f).viewFromWorld);
}

TEST(CameraPath, StaysFiniteForScenesWithoutUsableBounds) {
  const float huge = std::numeric_limits<float>::max(), infinity = std::numeric_limits<float>::infinity();
  const Scene scenes[] = {
      Scene{}, boxScene(glm::vec3(3), glm::vec3(3)), boxScene(glm::vec3(-huge), glm::vec3(huge)),
      boxScene(glm::vec3(0), glm::vec3(infinity)), boxScene(glm::vec3(1e18f), glm::vec3(2e18f))};
  for (Scene scene : scenes)
    for (const std::string name : kFitted)
      for (const float aspect : {1.5f, 0.0f, kNaN}) {
        const CameraState camera = cameraAt(scene, name, 0.3, aspect);
        EXPECT_TRUE(isFinite(camera.viewFromWorld)) << name;
        EXPECT_TRUE(isFinite(camera.clipFromView)) << name;
        scene.bounds.min = glm::vec3(kNaN);
        EXPECT_TRUE(isFinite(cameraAt(scene, name, 0.3, aspect).viewFromWorld)) << name;
      }
}

TEST(CameraPath, FollowsTheNodeOfASceneCameraAndIgnoresItsScale) {
  Scene scene;
  scene.nodes.resize(1);
  scene.nodes[0].scale = {2, 5, 3};
  scene.animations.push_back(
      {"slide",
       2.0f,
       {{0, AnimationPath::Translation, Interpolation::Linear, {0.0f, 2.0f}, {{0, 0, 0, 0}, {8, 0, 0, 0}}}}});
  SceneCamera source;
  source.node = 0;
  source.fovY = 1.0f;
  source.nearPlane = 0.5f;
  scene.cameras.push_back(source);
  const CameraState camera = cameraAt(scene, "gltf:camera0", 0.5, 1.25f);
  EXPECT_EQ(camera.viewFromWorld, glm::translate(glm::mat4(1.0f), glm::vec3(-2, 0, 0)));
  EXPECT_EQ(camera.clipFromView, perspectiveReversed(1.0f, 1.25f, 0.5f));
  EXPECT_EQ(camera.nearPlane, 0.5f);
  EXPECT_FALSE(camera.orthographic);
}

TEST(CameraPath, DrawsAnOrthographicSceneCamera) {
  Scene scene;
  scene.nodes.resize(1);
  SceneCamera source;
  source.node = 0;
  source.orthographic = true;
  source.height = 6.0f;
  source.farPlane = 50.0f;
  scene.cameras.push_back(source);
  const CameraState camera = cameraAt(scene, "gltf:camera0", 0.0, 2.0f);
  EXPECT_TRUE(camera.orthographic);
  EXPECT_EQ(camera.clipFromView, orthographicReversed(6.0f, 2.0f, 0.01f, 50.0f));
}

TEST(CameraPath, SaysWhichPathsThereAreWhenAskedForAnother) {
  Scene scene;
  scene.name = "box.glb";
  try {
    cameraAt(scene, "gltf:top", 0.0, 1.0f);
    FAIL() << "found";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "there is no camera \"gltf:top\" in box.glb; choose one of: still, pan, orbit, dolly");
  }
}

} // namespace
} // namespace taa
