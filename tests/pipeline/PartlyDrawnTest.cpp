// Inputs that are drawn where they are read hold what the whole frame holds there, however far that is.
#include "core/probe/PartlyDrawn.h"

#include "core/probe/TwinInputs.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

using namespace taa;

namespace {

class PartlyDrawnTest : public test::GlTest {};

FrameRequest requestOf(const Scene& scene, int width, int height) {
  FrameRequest request;
  request.camera = scene.shot.camera;
  request.width = width;
  request.height = height;
  return request;
}

} // namespace

TEST_F(PartlyDrawnTest, ReadsWhatTheWholeFrameHolds) {
  const auto scene = std::make_shared<const Scene>(openScene("builtin:fan"));
  SceneRenderer renderer(scene);
  for (const float scale : {1.0f, 0.5f}) {
    FrameRequest request = requestOf(*scene, 200, 120);
    request.inputs.renderScale = scale;
    PartlyDrawn parts;
    for (const int frame : {7, 3}) {
      FrameInputs drawn;
      renderer.draw(request, frame, drawn);
      const twin::Inputs whole = twinInputs(drawn, nullptr, TwinReading::Whole);
      const twin::Inputs read =
          parts.open(renderer, request, frame, nullptr, {{150, 20, 1, 1}, {20, 90, 4, 2}});
      EXPECT_EQ(read.frame, frame);
      EXPECT_EQ(read.jitterPx, whole.jitterPx);
      EXPECT_EQ(read.depthTerms, whole.depthTerms);
      ASSERT_EQ(read.width(), whole.width());
      const int right = whole.width() - 1, bottom = whole.height() - 1;
      for (const glm::ivec2& at : {glm::ivec2(right * 3 / 4, bottom / 6), glm::ivec2(2, bottom), // far away
                                   glm::ivec2(right * 3 / 4 + 1, bottom / 6), glm::ivec2(right, 0),
                                   glm::ivec2(right / 10 + 1, bottom * 3 / 4)}) {
        EXPECT_EQ(read.color.texel(at.x, at.y), whole.color.texel(at.x, at.y));
        EXPECT_EQ(read.depth.texel(at.x, at.y), whole.depth.texel(at.x, at.y));
        EXPECT_EQ(read.motion.texel(at.x, at.y), whole.motion.texel(at.x, at.y));
        EXPECT_EQ(read.objectId.texel(at.x, at.y), whole.objectId.texel(at.x, at.y));
      }
    }
  }
}

TEST_F(PartlyDrawnTest, DrawsLittleForLittle) {
  const auto scene = std::make_shared<const Scene>(openScene("builtin:crowd"));
  SceneRenderer renderer(scene);
  const FrameRequest request = requestOf(*scene, 640, 360);
  FrameInputs drawn;
  renderer.draw(request, 5, drawn);
  const int whole = renderer.counts().drawn;
  PartlyDrawn parts;
  const twin::Inputs read = parts.open(renderer, request, 5, nullptr, {{320, 200, 1, 1}});
  read.color.texel(320, 200);
  EXPECT_LT(renderer.counts().drawn, whole / 3);
  const int little = renderer.counts().drawn;
  read.color.texel(322, 203);
  EXPECT_EQ(renderer.counts().drawn, little) << "it is drawn already";
  read.color.texel(320, 330);
  EXPECT_LT(renderer.counts().drawn, whole / 3) << "what is far from it is drawn alone";
}

// Each of its pixels looks at the fog around it.
TEST_F(PartlyDrawnTest, ReadsFogAsTheWholeFrameHoldsIt) {
  const auto scene = std::make_shared<const Scene>(openScene("builtin:fog"));
  SceneRenderer renderer(scene);
  FrameRequest request = requestOf(*scene, 200, 120);
  request.inputs.fogHistory = FogHistory::Clamped;
  FrameInputs drawn;
  renderer.draw(request, 6, drawn);
  const twin::Inputs whole = twinInputs(drawn, nullptr, TwinReading::Whole);
  PartlyDrawn parts;
  const twin::Inputs read = parts.open(renderer, request, 6, nullptr, {{100, 60, 1, 1}});
  for (int y = 0; y < 120; y += 4)
    for (int x = 60; x < 140; x += 4) {
      EXPECT_EQ(read.color.texel(x, y), whole.color.texel(x, y)) << x << " " << y;
      EXPECT_EQ(read.fog.texel(x, y), whole.fog.texel(x, y)) << x << " " << y;
    }
}
