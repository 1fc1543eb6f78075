// What is known besides makes an answer no worse: the same painted frames with and without object numbers,
// depth and cameras are said to have the same fault. Half a minute, as nothing else asks that of one shot.
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFrames = 8;

using MotionChange = std::function<glm::vec2(const glm::vec2& motion)>;

struct Mistake {
  const char* id;
  MotionChange change;
};

/// What of the frames is known.
struct Known {
  bool ids = true, camera = true, depth = true;
};

Diagnosis diagnosisOf(const MotionChange& change, const Known& known) {
  test::PaintedShot shot;
  shot.change = 0.3;
  Examination examination = test::paintedExamination(shot, kFrames, [=](DoctorFrame& frame) {
    for (const std::uint32_t id : {0u, test::kGroundId, test::kBoardId})
      test::changeMotion(frame, id, change);
    if (!known.ids) frame.objectId.clear();
    if (!known.camera) frame.previousClipFromClip.reset();
    if (known.depth) return;
    for (Image* plane : {&frame.depth, &frame.depthView, &frame.previousDepthView}) *plane = Image();
    frame.previousClipFromClip.reset();
  });
  examination.known.ids = known.ids;
  examination.known.depth = known.depth;
  examination.known.camera = known.camera && known.depth;
  return examine(examination);
}

} // namespace

TEST(SameAnswer, IsGivenWhateverElseIsKnown) {
  const std::vector<Mistake> mistakes = {
      {"", [](const glm::vec2& m) { return m; }},
      {"motionNegatedY", [](const glm::vec2& m) { return glm::vec2(m.x, -m.y); }},
      {"motionSwapped", [](const glm::vec2& m) { return glm::vec2(m.y, m.x); }},
      {"motionScaled", [](const glm::vec2& m) { return 1.18f * m; }},
      {"motionInUv", [](const glm::vec2& m) { return m / glm::vec2(test::kPaintedPx); }},
  };
  for (const Mistake& mistake : mistakes)
    for (const bool ids : {true, false})
      for (const bool depth : {true, false})
        for (const bool camera : {true, false}) {
          if (camera && !depth) continue;
          const Diagnosis diagnosis = diagnosisOf(mistake.change, {ids, camera, depth});
          EXPECT_EQ(test::idsOf(diagnosis), mistake.id)
              << (ids ? "ids " : "") << (depth ? "depth " : "") << (camera ? "camera" : "");
        }
}

} // namespace taa::doctor
