// What is blended over the painted ground: with motion of its own, with that of what is behind, and over the
// motion of what is seen through it.
#include "core/doctor/color/BlendedSurfaces.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFrames = 6;

/// The board as something blended in: it has no number of its own, and the mask says where it is.
DoctorFrame blendedFrame(int frame) {
  DoctorFrame out = test::paintedFrame({}, frame);
  out.mask = Image(out.luma.width, out.luma.height, 2);
  for (std::size_t i = 0; i < out.objectId.size(); ++i) {
    if (out.objectId[i] != test::kBoardId) continue;
    out.objectId[i] = test::kGroundId;
    out.mask.pixels[2 * i] = 1.0f;
  }
  return out;
}

/// Detail of the ground, which moves with the camera by (2.25, −1.5) px a frame and with the jitter.
float groundAt(const DoctorFrame& frame, int x, int y) {
  const glm::vec2 place =
      glm::vec2(x, y) + 0.5f - frame.jitterPx - static_cast<float>(frame.frame) * glm::vec2(2.25f, -1.5f);
  return 0.5f + 0.15f * std::sin(0.8f * place.x + 0.3f * place.y) +
         0.15f * std::sin(0.7f * place.y - 0.4f * place.x);
}

void forMasked(DoctorFrame& frame, const std::function<void(int x, int y)>& change) {
  for (int y = 0; y < frame.luma.height; ++y)
    for (int x = 0; x < frame.luma.width; ++x)
      if (frame.mask.at(x, y)[0] > 0.0f) change(x, y);
}

BlendedEvidence evidenceOf(const test::FrameFault& fault) {
  BlendedEvidence out;
  for (int frame = 1; frame < kFrames; ++frame) {
    DoctorFrame now = blendedFrame(frame), before = blendedFrame(frame - 1);
    fault(now);
    fault(before);
    out.add({now, before});
  }
  return out;
}

std::string toldOf(const test::FrameFault& fault, bool isMaskUsed = false) {
  Diagnosis out;
  tellBlended(evidenceOf(fault), isMaskUsed, out);
  return out.findings.empty() ? "" : out.findings[0].id;
}

/// As if nothing were written for the board: the motion of the ground.
void takeMotionAway(DoctorFrame& frame) {
  forMasked(frame, [&](int x, int y) {
    frame.motionPx.at(x, y)[0] = 2.25f;
    frame.motionPx.at(x, y)[1] = -1.5f;
  });
}

} // namespace

TEST(BlendedSurfaces, WithMotionOfTheirOwnAreRight) {
  EXPECT_EQ(toldOf([](DoctorFrame&) {}), "");
}

TEST(BlendedSurfaces, WithoutMotionAreTold) {
  EXPECT_EQ(toldOf(takeMotionAway), "transparentsWithoutMotion");
  Diagnosis out;
  tellBlended(evidenceOf(takeMotionAway), false, out);
  ASSERT_EQ(out.findings.size(), 1u);
  EXPECT_EQ(out.findings[0].residuals[0].id, "tried");
  const glm::ivec4& box = out.findings[0].regions[0].box;
  EXPECT_NEAR(box.z - box.x, 36, 1); // the board's side
  EXPECT_NEAR(box.w - box.y, 36, 1);
}

TEST(BlendedSurfaces, WithAMaskThatIsUsedNeedNoMotion) {
  EXPECT_EQ(toldOf(takeMotionAway, true), "");
}

TEST(BlendedSurfaces, OverTheMotionOfWhatIsSeenAreTold) {
  EXPECT_EQ(toldOf([](DoctorFrame& frame) {
              forMasked(frame, [&](int x, int y) { *frame.luma.at(x, y) = groundAt(frame, x, y); });
            }),
            "transparentsOverwriteMotion");
}

TEST(BlendedSurfaces, WithoutAMaskAreNotDecided) {
  BlendedEvidence evidence;
  const DoctorFrame now = test::paintedFrame({}, 1), before = test::paintedFrame({}, 0);
  evidence.add({now, before});
  Diagnosis out;
  tellBlended(evidence, false, out);
  ASSERT_EQ(out.parts.undecided().size(), 1u);
  EXPECT_EQ(out.parts.undecided()[0].faults,
            (std::vector<Fault>{Fault::TransparentsWithoutMotion, Fault::TransparentsOverwriteMotion}));
}

TEST(BlendedSurfaces, ThatAreNowhereSayNothing) {
  Diagnosis out;
  tellBlended(
      evidenceOf([](DoctorFrame& frame) { frame.mask = Image(frame.luma.width, frame.luma.height, 2); }),
      false, out);
  EXPECT_TRUE(out.isHealthy());
  EXPECT_TRUE(out.parts.undecided().empty());
}

} // namespace taa::doctor
