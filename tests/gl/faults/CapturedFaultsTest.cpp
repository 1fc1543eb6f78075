// Faults of a renderer's frames and of a capture of the same frames: the same bits, and none where there are
// none.
#include "core/capture/source/CaptureSource.h"
#include "core/render/faults/FaultySource.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Faults.h"
#include "tests/support/GlTest.h"
#include "tests/support/capture/CapturedShot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

namespace taa {
namespace {

constexpr glm::ivec2 kPicturePx{64, 36};
constexpr int kFrames = 14;

bool isSame(const gl::Texture& a, const gl::Texture& b) {
  const Image is = a.download(), should = b.download();
  return is.pixels.size() == should.pixels.size() &&
         std::memcmp(is.pixels.data(), should.pixels.data(), is.pixels.size() * sizeof(float)) == 0;
}

bool isSame(const FrameInputs& a, const FrameInputs& b) {
  return isSame(a.color, b.color) && isSame(a.motion, b.motion) && isSame(a.depth, b.depth) &&
         isSame(a.previousDepth, b.previousDepth) && a.info.jitterPx == b.info.jitterPx &&
         a.info.startsHistory == b.info.startsHistory && a.block.depthTerms == b.block.depthTerms &&
         a.block.jitterPx == b.block.jitterPx && a.block.previousJitter == b.block.previousJitter;
}

/// A frame that is faulty, after others.
int faultyFrame(const FaultSettings& faults) {
  return std::min(kFrames - 2, faults.lastFrame);
}

class CapturedFaultsTest : public test::GlTest {
 protected:
  // Opened in the body: a test that is skipped has no context.
  struct Both {
    explicit Both(const std::string& scene)
        : shot(scene, kPicturePx, Settings{}, kFrames),
          drawn(std::make_unique<SceneRenderer>(std::make_shared<const Scene>(openScene(scene)))),
          captured(std::make_unique<capture::CaptureSource>(
              shot.manifest(), [this](int index) { return shot.frame(index); })) {}
    test::CapturedShot shot;
    FaultySource drawn, captured;
  };

  static FrameInputs at(FaultySource& source, const FrameRequest& request, int frame) {
    FrameInputs inputs;
    source.draw(request, frame, inputs);
    return inputs;
  }
};

TEST_F(CapturedFaultsTest, AreTheSameBitsInARendererAndInItsCapture) {
  for (const std::string scene : {"builtin:fan", "builtin:gallery"}) {
    Both both(scene);
    for (const FaultInfo& info : faultTable()) {
      if (info.reach != FaultReach::Any) continue;
      Settings settings;
      inject(info.fault, settings);
      FrameRequest request = both.shot.request();
      request.faults = settings.fault;
      const int frame = faultyFrame(request.faults);
      EXPECT_TRUE(isSame(at(both.captured, request, frame), at(both.drawn, request, frame)))
          << info.id << " of " << scene;
    }
  }
}

// The others change what is drawn, and of a capture nothing.
TEST_F(CapturedFaultsTest, OfWhatIsDrawnLeaveACaptureAsItIs) {
  Both both("builtin:fan");
  const FrameInputs healthy = at(both.captured, both.shot.request(), 5);
  EXPECT_TRUE(isSame(healthy, at(both.drawn, both.shot.request(), 5)));
  for (const FaultInfo& info : faultTable()) {
    if (info.reach != FaultReach::Drawn || !info.assignments.starts_with("fault.jitter")) continue;
    Settings settings;
    inject(info.fault, settings);
    FrameRequest request = both.shot.request();
    request.faults = settings.fault;
    request.faults.jitterReported = 1.0f; // what is reported may be wrong of any frames
    EXPECT_TRUE(isSame(at(both.captured, request, 5), healthy)) << info.id;
    EXPECT_FALSE(isSame(at(both.drawn, request, 5).color, healthy.color)) << info.id;
  }
}

// Each fault of planes changes some of them, where things of all kinds move and the camera, too.
TEST_F(CapturedFaultsTest, ChangeWhatTheySay) {
  Both both("builtin:gallery");
  for (const FaultInfo& info : faultTable()) {
    if (info.part == FaultPart::Resolve || !info.assignments.starts_with("fault.")) continue;
    Settings settings;
    inject(info.fault, settings);
    FrameRequest request = both.shot.request();
    request.camera = info.fault == Fault::ZeroTakenAsMissing ? "still" : "orbit"; // what moves is not 0
    const int frame = faultyFrame(settings.fault);
    const FrameInputs healthy = at(both.drawn, request, frame);
    request.faults = settings.fault;
    EXPECT_FALSE(isSame(at(both.drawn, request, frame), healthy)) << info.id;
  }
}

} // namespace
} // namespace taa
