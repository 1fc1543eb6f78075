// What moves otherwise than motion says is seen wherever it is, and thin lines that blink are not it.
#include "core/doctor/color/OutlierPixels.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFrames = 12;
constexpr glm::ivec2 kPlace{56, 52}; ///< on the ground, whatever frame

/// A bright rectangle of the ground's, which no other plane knows.
void paint(DoctorFrame& frame, const glm::ivec2& from, const glm::ivec2& sizePx) {
  for (int y = from.y; y < from.y + sizePx.y; ++y)
    for (int x = from.x; x < from.x + sizePx.x; ++x) *frame.luma.at(x, y) = 0.95f;
}

struct Seen {
  OutlierPixels outlier;
  RegionTracker tracker;
};

Seen seenIn(const test::FrameFault& fault) {
  const auto read = [&](int number) {
    DoctorFrame frame = test::paintedFrame({}, number);
    fault(frame);
    return frame;
  };
  Seen out;
  for (int number = 1; number < kFrames; ++number) {
    const DoctorFrame before = read(number - 1), now = read(number), after = read(number + 1);
    const std::vector<RegionIndex> labels = out.tracker.label(now);
    out.outlier.add({now, before, number + 1 < kFrames ? &after : nullptr}, labels);
  }
  return out;
}

/// Across the ground, which goes by (2.25, −1.5) px a frame.
void paintParticle(DoctorFrame& frame) {
  paint(frame, kPlace + glm::ivec2(-4, 3) * frame.frame, {4, 4});
}

Diagnosis toldOf(const Seen& seen, Diagnosis out = {}) {
  tellOutlier(seen.outlier, seen.tracker.regions(),
              {test::kPaintedPx, test::kPaintedPx, {{1, "ground"}}, {}, {}}, out);
  return out;
}

} // namespace

TEST(OutlierPixels, AreNoneWhereMotionIsRight) {
  const Seen seen = seenIn([](DoctorFrame&) {});
  EXPECT_TRUE(seen.outlier.regions().empty());
  EXPECT_EQ(seen.outlier.asked(), kFrames - 2);
  EXPECT_TRUE(toldOf(seen).parts.undecided().empty());
}

TEST(OutlierPixels, AreWhatOtherPlanesDoNotKnow) {
  const Seen seen = seenIn(paintParticle);
  ASSERT_EQ(seen.outlier.regions().size(), 1u);
  const auto& [region, found] = *seen.outlier.regions().begin();
  EXPECT_EQ(seen.tracker.regions()[static_cast<std::size_t>(region)].objectId, test::kGroundId);
  EXPECT_EQ(found.places, static_cast<std::size_t>(kFrames - 2));
  EXPECT_EQ(found.frames, (std::vector{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(found.most, 16u);
  const glm::ivec2 corner = kPlace + glm::ivec2(-4, 3) * found.frame;
  EXPECT_TRUE(found.pixel.x >= corner.x && found.pixel.x < corner.x + 4 && found.pixel.y >= corner.y &&
              found.pixel.y < corner.y + 4);
}

TEST(OutlierPixels, AreNoLinesThatBlink) {
  for (const glm::ivec2& sizePx : {glm::ivec2(20, 1), glm::ivec2(20, 3), glm::ivec2(1, 12)}) {
    const Seen seen = seenIn([&](DoctorFrame& frame) {
      if (frame.frame % 2 == 1) paint(frame, kPlace, sizePx);
    });
    EXPECT_TRUE(seen.outlier.regions().empty()) << sizePx.x << " " << sizePx.y;
  }
}

TEST(OutlierPixels, LeaveMotionOpen) {
  const Diagnosis told = toldOf(seenIn(paintParticle));
  ASSERT_EQ(told.parts.undecided().size(), 1u);
  const Undecided& open = told.parts.undecided().front();
  EXPECT_EQ(open.question, "Motion");
  EXPECT_TRUE(told.isMisfit());
  EXPECT_TRUE(open.reason.starts_with("at 10 places on object 1 (ground), in 10 of 10 frames, "))
      << open.reason;
}

TEST(OutlierPixels, KeepTheDoctorFromCallingAllRight) {
  const Diagnosis sound = examine(test::paintedExamination({}, kFrames));
  EXPECT_EQ(sound.healthySentence(), "Nothing wrong was found.");
  const Diagnosis told = examine(test::paintedExamination({}, kFrames, paintParticle));
  EXPECT_EQ(test::idsOf(told), "");
  EXPECT_EQ(told.healthySentence(),
            "Nothing is wrong in what could be decided, but not everything fits: Motion.");
  EXPECT_EQ(std::ranges::count(told.parts.right(), "Motion", &RightPart::part), 0);
}

TEST(OutlierPixels, AreNotToldOfWhatAFindingIsOf) {
  const Seen seen = seenIn(paintParticle);
  Diagnosis found;
  found.findings.push_back(faultFinding(Fault::MotionNegatedY));
  found.findings.back().regions.push_back({.name = "object 2 (board)"});
  EXPECT_EQ(toldOf(seen, found).parts.undecided().size(), 1u) << "that is beside it";
  found.findings.back().regions.push_back({.name = "object 1 (ground)"});
  EXPECT_TRUE(toldOf(seen, found).parts.undecided().empty());
  found.findings.back().regions.clear();
  found.findings.back().isWholePicture = true;
  EXPECT_TRUE(toldOf(seen, found).parts.undecided().empty());
}

} // namespace taa::doctor
