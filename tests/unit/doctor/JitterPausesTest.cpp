// Frames without the jitter that is stated for them are told from those with it.
#include "core/doctor/jitter/JitterPauses.h"

#include "core/doctor/examination/Doctor.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

glm::vec2 statedAt(int frame) {
  return test::paintedFrame({}, frame).jitterPx;
}

/// Shifts that are measured to the last bit of pictures that hold `share` of what is stated.
JitterEvidence evidenceOf(int frames, const std::function<float(int frame)>& share) {
  JitterEvidence out;
  for (int frame = 0; frame < frames; ++frame) {
    out.stated[frame] = statedAt(frame);
    if (frame > 0)
      out.shifts.push_back({frame, share(frame - 1) * statedAt(frame - 1) - share(frame) * statedAt(frame)});
  }
  return out;
}

std::vector<int> pausesOf(int frames, const std::function<float(int frame)>& share) {
  const auto pauses = jitterPauses(evidenceOf(frames, share));
  return pauses ? pauses->frames : std::vector<int>();
}

} // namespace

TEST(JitterPauses, AreTheFramesWithoutJitter) {
  EXPECT_EQ(pausesOf(16, [](int frame) { return frame >= 5 && frame <= 9 ? 0.0f : 1.0f; }),
            (std::vector<int>{5, 6, 7, 8, 9}));
  EXPECT_EQ(pausesOf(16, [](int frame) { return frame < 6 ? 0.0f : 1.0f; }),
            (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST(JitterPauses, AreNoneWhereJitterIsAsStatedOrNeverThere) {
  EXPECT_TRUE(pausesOf(16, [](int) { return 1.0f; }).empty());
  EXPECT_TRUE(pausesOf(16, [](int) { return 0.0f; }).empty());
  EXPECT_TRUE(pausesOf(16, [](int) { return -1.0f; }).empty());
  EXPECT_TRUE(pausesOf(16, [](int) { return 0.6f; }).empty()) << "another length";
}

TEST(JitterPauses, AreFoundByTheDoctor) {
  Examination examination = test::paintedExamination({}, 20, [](DoctorFrame& frame) {
    if (frame.frame < 8 || frame.frame > 13) return;
    test::PaintedShot shot;
    shot.isJittered = false;
    const glm::vec2 stated = frame.jitterPx;
    frame = test::paintedFrame(shot, frame.frame);
    frame.jitterPx = frame.depthJitterPx = stated;
  });
  const Diagnosis diagnosis = examine(examination);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].id, "jitterNotApplied");
  EXPECT_EQ(diagnosis.findings[0].name, "Jitter reported, not applied in frames 8 to 13");
  EXPECT_EQ(std::ranges::count(diagnosis.parts.right(), "Jitter", &RightPart::part), 0);
}

} // namespace taa::doctor
