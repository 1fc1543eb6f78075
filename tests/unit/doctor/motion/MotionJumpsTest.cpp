// A frame whose motion alone is too long, and one that truly jumped: on evidence made by hand.
#include "core/doctor/motion/MotionJumps.h"

#include <gtest/gtest.h>

#include <optional>

namespace taa::doctor {
namespace {

/// 100 pixels that move by 2 px and fit; in frame `odd` they move by `oddPx` and leave `given` of luma each.
RegionEvidence tracesWith(int odd, double oddPx, double given) {
  RegionEvidence out;
  for (int frame = 1; frame <= 8; ++frame) {
    const bool isOdd = frame == odd;
    out.traces.push_back(
        {frame, 100, 100.0 * (isOdd ? oddPx : 2.0), 100, 100.0 * (isOdd ? given : 0.01), 1.0});
  }
  return out;
}

} // namespace

TEST(MotionJumps, AreOfOneFrameAlone) {
  EXPECT_EQ(jumpOf(tracesWith(5, 20.0, 0.05)), 5);
  EXPECT_EQ(jumpOf(tracesWith(0, 20.0, 0.05)), std::nullopt);
  RegionEvidence twice = tracesWith(5, 20.0, 0.05);
  twice.traces[6] = twice.traces[4];
  EXPECT_EQ(jumpOf(twice), std::nullopt);
  // It stays as long: the frames after it have no better one beside them.
  RegionEvidence onset = tracesWith(7, 20.0, 0.05);
  onset.traces[7].lengthPx = 100.0 * 20.0;
  EXPECT_EQ(jumpOf(onset), std::nullopt);
}

TEST(MotionJumps, AreLongerAndFitWorse) {
  EXPECT_EQ(jumpOf(tracesWith(5, 8.0, 0.05)), 5); // 3 · 2 px + 2 px
  EXPECT_EQ(jumpOf(tracesWith(5, 7.9, 0.05)), std::nullopt);
  EXPECT_EQ(jumpOf(tracesWith(5, 20.0, 0.019)), std::nullopt); // it moved so: the rest leaves 0.01
}

TEST(MotionJumps, NeedFramesBeforeAndAfter) {
  RegionEvidence few = tracesWith(3, 20.0, 0.05);
  few.traces.resize(4);
  EXPECT_EQ(jumpOf(few), std::nullopt);
}

} // namespace taa::doctor
