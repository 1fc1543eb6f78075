// A plane that is that of the frame before is named by its silhouettes, and the rest is examined with its
// own.
#include "core/doctor/sequence/PlaneTimes.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>

namespace taa::doctor {
namespace {

using test::idsOf;

constexpr int kFrames = 14;

/// `change` is given a frame and the one before it.
using PlaneChange = std::function<void(DoctorFrame&, const DoctorFrame&)>;

Diagnosis diagnosisWith(const PlaneChange& change) {
  test::PaintedShot shot;
  shot.boardPx = {4.0, 3.0};
  Examination examination = test::paintedExamination(shot, kFrames);
  examination.read = [read = examination.read, change](int frame) {
    DoctorFrame out = read(frame);
    change(out, read(std::max(0, frame - 1)));
    return out;
  };
  return examine(examination);
}

/// The light whose compared luma this is.
Image lightOf(const Image& luma) {
  Image out(luma.width, luma.height, 3);
  for (std::size_t i = 0; i < luma.pixels.size(); ++i)
    for (std::size_t channel = 0; channel < 3; ++channel)
      out.pixels[3 * i + channel] = luma.pixels[i] / std::max(1e-3f, 1.0f - luma.pixels[i]);
  return out;
}

} // namespace

TEST(PlaneTimes, OfHealthyFramesAreTheirOwn) {
  EXPECT_EQ(idsOf(diagnosisWith(
                [](DoctorFrame& frame, const DoctorFrame&) { frame.output = lightOf(frame.luma); })),
            "");
}

TEST(PlaneTimes, NameDepthThatIsLate) {
  EXPECT_EQ(idsOf(diagnosisWith([](DoctorFrame& frame, const DoctorFrame& before) {
              frame.depth = before.depth;
              frame.depthView = before.depthView;
              frame.previousDepthView = before.previousDepthView;
            })),
            "depthFrameLate");
}

TEST(PlaneTimes, NameObjectNumbersThatAreLate) {
  EXPECT_EQ(idsOf(diagnosisWith(
                [](DoctorFrame& frame, const DoctorFrame& before) { frame.objectId = before.objectId; })),
            "idsFrameLate");
}

TEST(PlaneTimes, NameAnOutputThatIsLate) {
  EXPECT_EQ(idsOf(diagnosisWith(
                [](DoctorFrame& frame, const DoctorFrame& before) { frame.output = lightOf(before.luma); })),
            "outputFrameLate");
}

} // namespace taa::doctor
