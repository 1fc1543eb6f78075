// A sky that is drawn without jitter is told, in painted frames whose world has it.
#include "core/doctor/jitter/JitterSky.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace taa::doctor {
namespace {

constexpr int kFrames = 8;
constexpr double kDown = 4.0; // px a frame: the sky grows

/// Clouds in the painted sky, which move with the camera and with a share of the jitter.
void paintClouds(DoctorFrame& frame, float jittered, double downPx = kDown) {
  const glm::vec2 moved = static_cast<float>(frame.frame) * glm::vec2(0.0f, static_cast<float>(downPx));
  for (int y = 0; y < frame.luma.height; ++y)
    for (int x = 0; x < frame.luma.width; ++x) {
      if (*frame.depth.at(x, y) > 0.0f) continue;
      const glm::vec2 place = glm::vec2(x, y) + 0.5f - moved - jittered * frame.jitterPx;
      frame.luma.pixels[static_cast<std::size_t>(y) * frame.luma.width + x] =
          0.5f + 0.15f * std::sin(0.9f * place.x + 0.35f * place.y) +
          0.15f * std::sin(0.8f * place.y - 0.5f * place.x);
    }
}

Diagnosis diagnosisOf(const test::FrameFault& fault, double downPx = kDown, double rightPx = 0.0) {
  test::PaintedShot shot;
  shot.cameraPx = {rightPx, downPx};
  return examine(test::paintedExamination(shot, kFrames, fault));
}

} // namespace

TEST(JitterSky, IsHealthyWhereItShiftsWithTheWorld) {
  const Diagnosis diagnosis = diagnosisOf([](DoctorFrame& frame) { paintClouds(frame, 1.0f); });
  EXPECT_TRUE(diagnosis.isHealthy()) << diagnosis.findings[0].id << diagnosis.findings[0].reason;
}

TEST(JitterSky, IsToldWhereItRests) {
  const Diagnosis diagnosis = diagnosisOf([](DoctorFrame& frame) { paintClouds(frame, 0.0f); });
  ASSERT_FALSE(diagnosis.findings.empty());
  EXPECT_EQ(diagnosis.findings[0].id, "skyNotJittered");
  ASSERT_EQ(diagnosis.findings[0].regions.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].regions[0].name, "the sky");
}

// What is read with the jitter, and has none, looks as if both jitters were left in its motion.
TEST(JitterSky, IsAllThatIsToldWhereTheCameraRests) {
  const Diagnosis diagnosis = diagnosisOf([](DoctorFrame& frame) { paintClouds(frame, 0.0f, 0.0); }, 0.0);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].id, "skyNotJittered");
  EXPECT_NE(
      std::ranges::find(diagnosis.parts.undecided(), std::string("Jitter in motion"), &Undecided::question),
      diagnosis.parts.undecided().end());
}

// Waves of grain that go over the sky by themselves shift by some share of the jitter, and by no jitter.
TEST(JitterSky, WithGrainOfItsOwnHasNoOtherJitter) {
  const Diagnosis diagnosis = diagnosisOf([](DoctorFrame& frame) {
    for (int y = 0; y < frame.luma.height; ++y)
      for (int x = 0; x < frame.luma.width; ++x) {
        if (*frame.depth.at(x, y) > 0.0f) continue;
        const int pixel = y * frame.luma.width + x;
        frame.luma.pixels[static_cast<std::size_t>(pixel)] =
            0.5f * (1.0f + 0.03f * std::sin(12.9898f * static_cast<float>(pixel) +
                                            78.233f * static_cast<float>(frame.frame)));
      }
  });
  EXPECT_TRUE(diagnosis.isHealthy()) << diagnosis.findings[0].id;
}

// Silhouettes of what is before it lie on whole pixels, whatever the jitter.
TEST(JitterSky, WithoutDetailIsNotDecided) {
  for (const glm::dvec2 panPx : {glm::dvec2(0.0, kDown), glm::dvec2(1.0, 0.0), glm::dvec2(1.5, 0.0)}) {
    const Diagnosis diagnosis = diagnosisOf([](DoctorFrame&) {}, panPx.y, panPx.x);
    ASSERT_TRUE(diagnosis.isHealthy()) << diagnosis.findings[0].id;
    EXPECT_EQ(std::ranges::count(diagnosis.parts.undecided(), std::string("Jitter of the sky"),
                                 &Undecided::question),
              1);
  }
}

} // namespace taa::doctor
