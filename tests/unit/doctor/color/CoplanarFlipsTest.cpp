// Objects that take turns in an area at one distance fight; those that touch along a line, or lie behind each
// other, do not.
#include "core/doctor/color/CoplanarFlips.h"

#include "core/doctor/examination/Doctor.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace taa::doctor {
namespace {

constexpr int kFrames = 8;
constexpr std::uint32_t kDecalId = 7;

test::PaintedShot flipShot() {
  test::PaintedShot out;
  out.cameraPx = {0.0, 0.0};
  out.isJittered = false;
  return out;
}

/// `isDecal`: of a place of the ground at a frame.
std::string toldWhere(const std::function<bool(int x, int y, int frame)>& isDecal, float distance = 10.0f) {
  const Diagnosis diagnosis = examine(test::paintedExamination(flipShot(), kFrames, [&](DoctorFrame& frame) {
    for (int y = 20; y < 36; ++y)
      for (int x = 8; x < 40; ++x) {
        if (!isDecal(x, y, frame.frame)) continue;
        frame.objectId[static_cast<std::size_t>(y) * frame.luma.width + x] = kDecalId;
        *frame.depthView.at(x, y) = *frame.previousDepthView.at(x, y) = distance;
      }
  }));
  std::string text;
  for (const Finding& finding : diagnosis.findings) {
    text += finding.id;
    for (const RegionPlace& region : finding.regions) text += ": " + region.name;
  }
  return text;
}

bool alternates(int x, int y, int frame) {
  return (x / 3 + y / 2 + frame) % 2 == 0;
}

} // namespace

TEST(CoplanarFlips, OfAnAreaFight) {
  EXPECT_EQ(toldWhere(alternates), "zFighting: object 1 (ground) and object 7");
}

TEST(CoplanarFlips, OfAnAreaThatIsHiddenInTurnsDoNot) {
  EXPECT_EQ(toldWhere(alternates, 9.9f), "");
}

TEST(CoplanarFlips, AlongALineDoNot) {
  EXPECT_EQ(toldWhere([](int x, int y, int frame) { return y < 28 + frame % 2 && x >= 8; }), "");
}

TEST(CoplanarFlips, ThatStayDoNot) {
  EXPECT_EQ(toldWhere([](int x, int y, int) { return alternates(x, y, 0); }), "");
}

TEST(CoplanarFlips, NeedObjectNumbers) {
  CoplanarEvidence evidence;
  DoctorFrame now = test::paintedFrame({}, 1), before = test::paintedFrame({}, 0);
  now.objectId.clear();
  before.objectId.clear();
  evidence.add({now, before});
  EXPECT_TRUE(evidence.objects.empty());
  EXPECT_EQ(evidence.pixels, 160.0 * 96.0);
}

} // namespace taa::doctor
