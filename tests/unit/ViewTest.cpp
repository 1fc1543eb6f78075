// A view at another place of the pixel is the one that a request for that place gets.
#include "core/render/View.h"

#include "core/render/FrameRequest.h"
#include "core/scene/builtin/SceneSource.h"

#include <gtest/gtest.h>

#include <cstring>

namespace taa {
namespace {

TEST(View, JitterThatIsSetIsThatOfTheRequest) {
  const Scene scene = openScene("builtin:fan");
  FrameRequest request;
  request.camera = scene.shot.camera;
  request.jitterPx = glm::vec2(0.25f, -0.125f);
  View view = viewAt(scene, request, 7);
  request.jitterPx = glm::vec2(-0.4375f, 0.5f);
  const View asked = viewAt(scene, request, 7);
  EXPECT_NE(std::memcmp(&view.block, &asked.block, sizeof(view.block)), 0);
  setJitter(view, *request.jitterPx);
  EXPECT_EQ(std::memcmp(&view.block, &asked.block, sizeof(view.block)), 0);
  EXPECT_EQ(view.info.jitterPx, asked.info.jitterPx);
}

} // namespace
} // namespace taa
