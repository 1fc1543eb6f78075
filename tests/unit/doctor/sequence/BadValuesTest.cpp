// Motion that is no number is a finding with its objects and frames; color that is none is a note.
#include "core/doctor/sequence/BadValues.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace taa::doctor {
namespace {

constexpr int kFrames = 10;

const Finding* findingOf(const Diagnosis& diagnosis, const char* id) {
  const auto found = std::ranges::find(diagnosis.findings, id, &Finding::id);
  return found == diagnosis.findings.end() ? nullptr : &*found;
}

} // namespace

TEST(BadValues, OfMotionAreNamedWithObjectAndFrames) {
  const Diagnosis diagnosis = examine(test::paintedExamination({}, kFrames, [](DoctorFrame& frame) {
    if (frame.frame < 3 || frame.frame > 5) return;
    const float bad =
        frame.frame == 4 ? std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
    test::changeMotion(frame, test::kBoardId,
                       [bad](const glm::vec2& motion) { return glm::vec2(bad, motion.y); });
  }));
  const Finding* finding = findingOf(diagnosis, "motionNotFinite");
  ASSERT_TRUE(finding);
  ASSERT_EQ(finding->regions.size(), 1u);
  EXPECT_EQ(finding->regions[0].objectId, test::kBoardId);
  EXPECT_NE(finding->reason.find("In frames 3 to 5 "), std::string::npos) << finding->reason;
  EXPECT_EQ(diagnosis.findings.size(), 1u) << "what is no motion is no witness of another mistake";
}

TEST(BadValues, OfColorAreANote) {
  const Diagnosis diagnosis = examine(test::paintedExamination(
      {}, kFrames, [](DoctorFrame& frame) { frame.badColors = frame.frame == 2 ? 7 : 0; }));
  EXPECT_TRUE(diagnosis.isHealthy());
  EXPECT_TRUE(std::ranges::any_of(diagnosis.notes, [](const std::string& note) {
    return note.find("NaN or infinite) at 7 pixels") != std::string::npos;
  }));
}

TEST(BadValues, OfWholePixelsAloneAreNamed) {
  const auto hasWhole = [](const test::PaintedShot& shot, bool isRounded) {
    const Diagnosis diagnosis =
        examine(test::paintedExamination(shot, kFrames, [isRounded](DoctorFrame& frame) {
          for (const std::uint32_t id : {0u, test::kGroundId, test::kBoardId})
            if (isRounded)
              test::changeMotion(frame, id, [](const glm::vec2& motion) { return glm::round(motion); });
        }));
    return findingOf(diagnosis, "motionWholePixels") != nullptr;
  };
  test::PaintedShot shot;
  shot.change = 0.9; // many lengths
  EXPECT_TRUE(hasWhole(shot, true));
  EXPECT_FALSE(hasWhole(shot, false));
  test::PaintedShot scroll; // two lengths, as of a plain scroll
  scroll.cameraPx = {2.0, -1.0};
  scroll.boardPx = {1.0, 3.0};
  EXPECT_FALSE(hasWhole(scroll, true));
}

// As a clear to 255/256 leaves it.
TEST(BadValues, OfDepthThatMayBeTheSkyAreAsked) {
  const auto isAsked = [](float depth, float change) {
    const Diagnosis diagnosis = examine(test::paintedExamination({}, kFrames, [=](DoctorFrame& frame) {
      const float sky = depth + change * static_cast<float>(frame.frame);
      for (std::size_t i = 0; i < frame.depth.pixels.size(); ++i)
        if (frame.depth.pixels[i] == 0.0f) {
          frame.depth.pixels[i] = sky;
          frame.depthView.pixels[i] = frame.previousDepthView.pixels[i] = sky > 0.0f ? 0.1f / sky : 0.0f;
        }
    }));
    return std::ranges::any_of(diagnosis.parts.undecided(),
                               [](const Undecided& open) { return open.question == "The sky in depth"; });
  };
  EXPECT_TRUE(isAsked(1.0f / 256.0f, 0.0f));
  EXPECT_FALSE(isAsked(0.0f, 0.0f)) << "it is the sky";
  EXPECT_FALSE(isAsked(1.0f / 256.0f, 1e-4f)) << "something that comes nearer";
}

// As 8 bits of a component leave it, with an offset of half a step, while the camera comes nearer.
TEST(BadValues, OfCoarseStepsAreNamedAlone) {
  const auto idsWith = [](float stepPx) {
    return test::idsOf(examine(test::paintedExamination({}, kFrames, [=](DoctorFrame& frame) {
      for (int y = 0; y < frame.motionPx.height; ++y)
        for (int x = 0; x < frame.motionPx.width; ++x) {
          float* motion = frame.motionPx.at(x, y);
          for (int axis = 0; axis < 2; ++axis)
            motion[axis] =
                stepPx * (std::floor((motion[axis] + 0.1f * static_cast<float>(x)) / stepPx) + 0.5f);
        }
    })));
  };
  EXPECT_EQ(idsWith(1.7f), std::string(kMotionStepsId));
  EXPECT_EQ(idsWith(0.01f).find(kMotionStepsId), std::string::npos);
}

} // namespace taa::doctor
