// What lies outside the view is left out, and no bit of the inputs tells of it.
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/Pose.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/GlTest.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cstring>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 160, kHeight = 90;

/// Turns the scene's own camera around the vertical.
void turnCamera(Scene& scene, float angle) {
  for (const SceneCamera& camera : scene.cameras) {
    Node& node = scene.nodes[std::size_t(camera.node)];
    node.rotation = glm::angleAxis(angle, glm::vec3(0, 1, 0)) * node.rotation;
  }
}

bool isSame(const gl::Texture& a, const gl::Texture& b) {
  if (!a && !b) return true;
  const Image left = a.download(), right = b.download();
  return left.pixels.size() == right.pixels.size() &&
         std::memcmp(left.pixels.data(), right.pixels.data(), left.pixels.size() * sizeof(float)) == 0;
}

void expectSame(const FrameInputs& a, const FrameInputs& b, const std::string& what) {
  EXPECT_TRUE(isSame(a.color, b.color)) << "color, " << what;
  EXPECT_TRUE(isSame(a.depth, b.depth)) << "depth, " << what;
  EXPECT_TRUE(isSame(a.motion, b.motion)) << "motion, " << what;
  EXPECT_TRUE(isSame(a.normal, b.normal)) << "normal, " << what;
  EXPECT_TRUE(isSame(a.objectId, b.objectId)) << "object id, " << what;
  EXPECT_TRUE(isSame(a.previousDepth, b.previousDepth)) << "previous depth, " << what;
  EXPECT_TRUE(isSame(a.mask, b.mask)) << "mask, " << what;
  EXPECT_TRUE(isSame(a.fog, b.fog)) << "fog, " << what;
  EXPECT_TRUE(isSame(a.overlay, b.overlay)) << "overlay, " << what;
}

class CullingTest : public test::GlTest, public testing::WithParamInterface<std::string> {
 protected:
  /// Draws a frame with and without what lies outside, holds them to the same bits and says what was drawn.
  DrawCounts compare(SceneRenderer& renderer, FrameRequest request, int frame, const std::string& what) {
    renderer.setCulling(false);
    renderer.draw(request, frame, all_);
    const DrawCounts whole = renderer.counts();
    EXPECT_EQ(whole.drawn, whole.objects) << what;
    renderer.setCulling(true);
    renderer.draw(request, frame, culled_);
    expectSame(all_, culled_, what + ", frame " + std::to_string(frame));
    EXPECT_EQ(renderer.counts().objects, whole.objects) << what;
    return renderer.counts();
  }
  static FrameRequest request(const Scene& scene) {
    FrameRequest request;
    request.camera = scene.shot.camera;
    request.width = kWidth;
    request.height = kHeight;
    request.inputs.mask = MaskSource::Material;
    request.inputs.blended = BlendedAs::BeforeWithMotion;
    return request;
  }

 private:
  FrameInputs all_, culled_;
};

TEST_P(CullingTest, ChangesNoBitOfAnyCamera) {
  const auto scene = std::make_shared<const Scene>(openScene("builtin:" + GetParam()));
  SceneRenderer renderer(scene);
  FrameRequest asked = request(*scene);
  for (const std::string& camera : cameraNames(*scene)) {
    asked.camera = camera;
    asked.jitter.projection = JitterProjection::Translation;
    for (const int frame : {0, 61, 150}) compare(renderer, asked, frame, camera);
    asked.jitter.projection = JitterProjection::RightAsPrinted; // moves what is near by many pixels
    compare(renderer, asked, 61, camera + ", multiplied from the right");
  }
}

// Scissored, and what lies outside the part is left out.
TEST_P(CullingTest, APartIsAsItIsInTheWhole) {
  const auto scene = std::make_shared<const Scene>(openScene("builtin:" + GetParam()));
  SceneRenderer renderer(scene);
  FrameInputs whole, parted;
  FrameRequest asked = request(*scene);
  renderer.draw(asked, 61, whole);
  const int drawn = renderer.counts().drawn;
  int fewest = drawn;
  for (const gl::Rect& part : {gl::Rect{0, 0, 1, 1}, gl::Rect{70, 40, 20, 10}, gl::Rect{131, 57, 29, 33}}) {
    asked.part = part;
    renderer.draw(asked, 61, parted);
    fewest = std::min(fewest, renderer.counts().drawn);
    for (const auto texture :
         {&FrameInputs::color, &FrameInputs::depth, &FrameInputs::motion, &FrameInputs::normal,
          &FrameInputs::objectId, &FrameInputs::previousDepth, &FrameInputs::mask, &FrameInputs::fog}) {
      if (!(whole.*texture)) continue;
      EXPECT_EQ((parted.*texture).download(part).pixels, (whole.*texture).download(part).pixels)
          << part.x << ", " << part.y;
    }
  }
  EXPECT_LT(fewest, drawn);
}

TEST_P(CullingTest, LeavesOutWhatTheCameraTurnsAwayFrom) {
  const Scene scene = openScene("builtin:" + GetParam());
  int fewest = 1000000, objects = 0;
  for (int turn = 0; turn < 4; ++turn) {
    Scene turned = scene;
    turnCamera(turned, 0.5f * std::numbers::pi_v<float> * static_cast<float>(turn));
    SceneRenderer renderer(std::make_shared<const Scene>(std::move(turned)));
    const DrawCounts counts = compare(renderer, request(scene), 40, "turned " + std::to_string(turn));
    fewest = std::min(fewest, counts.drawn);
    objects = counts.objects;
  }
  EXPECT_LT(fewest, (objects + 1) / 2) << "of " << objects; // floors and walls may be all around
}

std::vector<std::string> ids() {
  std::vector<std::string> all;
  for (const BuiltinScene& scene : builtinScenes()) all.push_back(scene.id);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, CullingTest, testing::ValuesIn(ids()),
                         [](const auto& test) { return test.param; });

} // namespace
} // namespace taa
