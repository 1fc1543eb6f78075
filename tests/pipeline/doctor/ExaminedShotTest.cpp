// The doctor on the shot of a session, on a thread of its own.
#include "core/inspect/ExaminedShot.h"

#include "core/base/Error.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <string_view>
#include <thread>
#include <vector>

namespace taa {
namespace {

class ExaminedShot : public test::GlTest {
 protected:
  static ExaminationRequest requestOf(int first, int frames) {
    ExaminationRequest request;
    request.shot.source = "builtin:fan";
    request.shot.camera = "pan";
    request.shot.size = {240, 136};
    request.first = first;
    request.frames = frames;
    return request;
  }
  /// On a thread that has no context.
  static void beside(const std::function<void()>& act) { std::thread(act).join(); }
};

} // namespace

TEST_F(ExaminedShot, IsFoundFaultyBySettingsOfTheSession) {
  ExaminationRequest request = requestOf(3, 10);
  request.shot.settings.settings.fault.motionX = -1.0f;
  std::vector<doctor::Diagnosis> early;
  doctor::Diagnosis all;
  beside(
      [&] { all = examineShot(request, [&](const doctor::Diagnosis& seen) { early.push_back(seen); }, {}); });
  ASSERT_EQ(early.size(), 1u);
  EXPECT_EQ(early[0].frames, doctor::kFirstLook);
  EXPECT_EQ(all.frames, 10);
  EXPECT_EQ(all.sizePx, glm::ivec2(240, 136));
  ASSERT_FALSE(all.findings.empty());
  EXPECT_EQ(all.findings[0].id, "motionNegatedX");
  ASSERT_FALSE(all.findings[0].regions.empty());
  EXPECT_GE(all.findings[0].regions[0].frame, 3) << "numbers are those of the shot";
}

TEST_F(ExaminedShot, IsDrawnAsItWouldBeWithNumbersOfTheShot) {
  ExaminationRequest request = requestOf(3, 10);
  request.shot.settings.settings.fault.motionX = -1.0f;
  doctor::CorrectedLook look;
  beside([&] { look = lookAtCorrectedShot(request, examineShot(request, {}, {}), Settings{}, {}); });
  EXPECT_EQ(look.lastFrame, 12);
  EXPECT_TRUE(look.left.isHealthy());
  ASSERT_FALSE(look.pictures.empty());
  EXPECT_GE(look.pictures[0].frame, 3);
  EXPECT_NE(look.pictures[0].given.pixels, look.pictures[0].corrected.pixels);
}

TEST_F(ExaminedShot, IsLeftWhereItIsCancelled) {
  std::atomic<bool> isCancelled = false;
  beside([&] {
    try {
      examineShot(requestOf(0, 10), {}, [](std::string_view, int, int) { return false; });
    } catch (const Cancelled&) {
      isCancelled = true;
    }
  });
  EXPECT_TRUE(isCancelled);
}

TEST_F(ExaminedShot, WantsFramesThatThereAre) {
  std::atomic<bool> isRefused = false;
  beside([&] {
    try {
      examineShot(requestOf(100000, 10), {}, {});
    } catch (const Error&) {
      isRefused = true;
    }
  });
  EXPECT_TRUE(isRefused);
}

} // namespace taa
