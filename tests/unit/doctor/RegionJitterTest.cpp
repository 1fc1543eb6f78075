// A thing that is drawn without the jitter of all else is told by its pixels, and what has it is not.
#include "core/doctor/jitter/RegionJitter.h"

#include "core/doctor/motion/MotionFindings.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFrames = 12;

/// Draws the board as if there were no jitter, in all planes.
void drawBoardWithoutJitter(DoctorFrame& frame) {
  test::PaintedShot shot;
  shot.isJittered = false;
  const DoctorFrame plain = test::paintedFrame(shot, frame.frame);
  for (int y = 0; y < frame.luma.height; ++y)
    for (int x = 0; x < frame.luma.width; ++x) {
      const std::size_t index = static_cast<std::size_t>(y) * frame.luma.width + x;
      if (plain.objectId[index] != test::kBoardId) continue;
      *frame.luma.at(x, y) = *plain.luma.at(x, y);
      frame.objectId[index] = test::kBoardId;
      std::copy_n(plain.motionPx.at(x, y), 2, frame.motionPx.at(x, y));
      *frame.depth.at(x, y) = *plain.depth.at(x, y);
      *frame.depthView.at(x, y) = *plain.depthView.at(x, y);
      *frame.previousDepthView.at(x, y) = *plain.previousDepthView.at(x, y);
    }
}

struct Seen {
  RegionTracker tracker;
  RegionJitter jitter;

  explicit Seen(const test::FrameFault& fault) {
    const auto read = [&](int number) {
      DoctorFrame frame = test::paintedFrame({}, number);
      fault(frame);
      return frame;
    };
    for (int number = 1; number < kFrames; ++number) {
      const DoctorFrame before = read(number - 1), now = read(number);
      const std::vector<RegionIndex> labels = tracker.label(now);
      jitter.add({now, before}, labels);
    }
  }
};

/// By object.
std::map<std::uint32_t, MissingJitter> missingIn(const test::FrameFault& fault) {
  const Seen seen(fault);
  std::map<std::uint32_t, MissingJitter> out;
  for (const auto& [index, missing] : seen.jitter.regions())
    if (const Region& region = seen.tracker.regions()[static_cast<std::size_t>(index)]; !region.isSky)
      out[region.objectId] = missing;
  return out;
}

} // namespace

TEST(RegionJitter, IsThereInWhatIsDrawnWithIt) {
  const auto missing = missingIn([](DoctorFrame&) {});
  ASSERT_EQ(missing.size(), 2u);
  for (const auto& [object, of] : missing) {
    EXPECT_EQ(of.pairs, kFrames - 1) << object;
    EXPECT_LT(std::abs(of.share), 0.1) << object;
  }
}

TEST(RegionJitter, IsMissingInWhatIsDrawnWithout) {
  const auto missing = missingIn(drawBoardWithoutJitter);
  ASSERT_EQ(missing.size(), 2u);
  EXPECT_NEAR(missing.at(test::kBoardId).share, 1.0, 0.15);
  EXPECT_LT(missing.at(test::kBoardId).error, 0.05);
  EXPECT_LT(std::abs(missing.at(test::kGroundId).share), 0.1);
}

TEST(RegionJitter, IsAFindingOfThatRegionAlone) {
  EXPECT_EQ(test::idsOf(examine(test::paintedExamination({}, kFrames))), "");
  const Diagnosis told = examine(test::paintedExamination({}, kFrames, drawBoardWithoutJitter));
  const auto found = std::ranges::find(told.findings, "jitterRegionMissing", &Finding::id);
  ASSERT_NE(found, told.findings.end()) << test::idsOf(told);
  ASSERT_EQ(found->regions.size(), 1u);
  EXPECT_EQ(found->regions.front().objectId, test::kBoardId);
  EXPECT_EQ(partOf(*found), FaultPart::Jitter);
  EXPECT_EQ(std::ranges::count(told.parts.right(), "Jitter", &RightPart::part), 0);
}

// Its motion is right: what pixels seem to say of that is the jitter that is missing.
TEST(RegionJitter, TakesBackWhatWasSaidOfTheMotionOfThatRegion) {
  const Seen seen(drawBoardWithoutJitter);
  CaptureInfo captureInfo;
  captureInfo.sizePx = test::kPaintedPx;
  Diagnosis out;
  out.frames = kFrames;
  for (const Region& region : seen.tracker.regions()) {
    out.findings.push_back(faultFinding(Fault::MotionCameraOnly));
    out.findings.back().regions = {placeOf(region, captureInfo, 1.0)};
  }
  tellRegionJitter(seen.jitter, seen.tracker.regions(), captureInfo, out);
  for (const Finding& finding : out.findings)
    EXPECT_EQ(finding.regions.front().objectId == test::kBoardId, finding.id == "jitterRegionMissing");
  EXPECT_EQ(out.findings.size(), seen.tracker.regions().size());
}

// Where nothing has jitter, it is not a region's mistake.
TEST(RegionJitter, IsNotToldOfAllOfThePicture) {
  test::PaintedShot still;
  still.isJittered = false;
  const Diagnosis told = examine(test::paintedExamination({}, kFrames, [&](DoctorFrame& frame) {
    const glm::vec2 stated = frame.jitterPx;
    frame = test::paintedFrame(still, frame.frame);
    frame.jitterPx = stated;
  }));
  EXPECT_EQ(std::ranges::count(told.findings, "jitterRegionMissing", &Finding::id), 0) << test::idsOf(told);
}

} // namespace taa::doctor
