// Faults of what is drawn, on built-in scenes: color and depth are those that the renderer alone draws with
// the jitter that each fault says.
#include "core/render/faults/FaultySource.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Faults.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <glm/vec2.hpp>

#include <functional>
#include <memory>

namespace taa {
namespace {

constexpr int kWidth = 64, kHeight = 36, kFrame = 5;

class DrawnFaultsTest : public test::GlTest {
 protected:
  // Opened in the body: a test that is skipped has no context.
  struct Scenes {
    Scenes()
        : scene(std::make_shared<const Scene>(openScene("builtin:gallery"))), alone(scene),
          faulty(std::make_unique<SceneRenderer>(scene)) {
      request.camera = "orbit"; // some frames of the scene's own camera have no sky
      request.width = kWidth;
      request.height = kHeight;
    }
    std::shared_ptr<const Scene> scene; // also owned by both renderers
    SceneRenderer alone;
    FaultySource faulty;
    FrameRequest request;

    glm::vec2 jitter(int frame) const { return alone.info(request, frame).jitterPx; }
    FrameInputs healthy(const glm::vec2& jitterPx) {
      FrameRequest asked = request;
      asked.jitterPx = jitterPx;
      FrameInputs inputs;
      alone.draw(asked, kFrame, inputs);
      return inputs;
    }
    FrameInputs with(Fault fault) {
      Settings settings;
      inject(fault, settings);
      FrameRequest asked = request;
      asked.faults = settings.fault;
      FrameInputs inputs;
      faulty.draw(asked, kFrame, inputs);
      return inputs;
    }
  };

  static void expectSame(const Image& is, const Image& should, const FaultInfo& info) {
    EXPECT_EQ(is.pixels, should.pixels) << info.id;
  }
};

TEST_F(DrawnFaultsTest, OfTheSequenceAreInThePictureAndReported) {
  Scenes on;
  const glm::vec2 right = on.jitter(kFrame);
  const auto expectDrawn = [&](Fault fault, const glm::vec2& applied, const glm::vec2& reported) {
    ASSERT_NE(applied, right);
    const FrameInputs is = on.with(fault), should = on.healthy(applied);
    expectSame(is.color.download(), should.color.download(), faultInfo(fault));
    expectSame(is.depth.download(), should.depth.download(), faultInfo(fault));
    EXPECT_EQ(is.info.jitterPx, reported) << faultInfo(fault).id;
  };
  expectDrawn(Fault::JitterNotApplied, glm::vec2(0.0f), right);
  expectDrawn(Fault::JitterOutside, 2.0f * right, 2.0f * right);
  expectDrawn(Fault::JitterFrozen, on.jitter(0), on.jitter(0));
  expectDrawn(Fault::JitterShort, on.jitter(kFrame % 2), on.jitter(kFrame % 2));
  const glm::vec2 shifted = right + glm::vec2(0.25f, 0.125f);
  expectDrawn(Fault::JitterMean, shifted, shifted);
}

TEST_F(DrawnFaultsTest, OfDepthLeaveColor) {
  Scenes on;
  const FrameInputs is = on.with(Fault::DepthNotJittered), right = on.healthy(on.jitter(kFrame)),
                    still = on.healthy(glm::vec2(0.0f));
  expectSame(is.color.download(), right.color.download(), faultInfo(Fault::DepthNotJittered));
  expectSame(is.depth.download(), still.depth.download(), faultInfo(Fault::DepthNotJittered));
  EXPECT_NE(still.depth.download().pixels, right.depth.download().pixels);
}

// Where the sky's own jitter puts an object before the sky, nothing is taken: nobody draws it twice.
TEST_F(DrawnFaultsTest, OfTheSkyLeaveSurfaces) {
  Scenes on;
  const FrameInputs inputs = on.with(Fault::SkyNotJittered);
  const FrameInputs other = on.healthy(glm::vec2(0.0f));
  const Image is = inputs.color.download(), depth = inputs.depth.download(),
              right = on.healthy(on.jitter(kFrame)).color.download(), still = other.color.download(),
              stillDepth = other.depth.download();
  int skyTexels = 0, silhouettes = 0, moved = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool isSky = depth.at(x, y)[0] == 0.0f, isSilhouette = isSky && stillDepth.at(x, y)[0] != 0.0f;
      for (int channel = 0; channel < 3; ++channel) {
        ASSERT_EQ(is.at(x, y)[channel], (isSky && !isSilhouette ? still : right).at(x, y)[channel])
            << x << ", " << y;
        if (isSky && !isSilhouette && still.at(x, y)[channel] != right.at(x, y)[channel]) ++moved;
      }
      if (isSky) ++skyTexels;
      if (isSilhouette) ++silhouettes;
    }
  EXPECT_GT(skyTexels, 20);
  EXPECT_LT(skyTexels, kWidth * kHeight - 20);
  EXPECT_GT(silhouettes, 0) << "jitter moves an object's rim";
  EXPECT_GT(moved, 0) << "the sky has something that jitter moves";
}

} // namespace
} // namespace taa
