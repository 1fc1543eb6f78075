// What is wrong with pictures is told in its order, and what an interface covers is no evidence.
#include "core/doctor/color/ColorCheck.h"

#include "core/doctor/examination/Doctor.h"
#include "tests/support/doctor/PaintedFrames.h"
#include "tests/support/doctor/PaintedInterface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace taa::doctor {

TEST(ColorCheck, ReadsFramesThatAreCovered) {
  const std::size_t pixels = static_cast<std::size_t>(test::kPaintedPx.x) * test::kPaintedPx.y;
  std::vector<std::uint8_t> covered(pixels, 0);
  covered[3 * 160 + 2] = 1;
  const FrameReader read = coveredReader([](int frame) { return test::paintedFrame({}, frame); }, covered);
  const DoctorFrame frame = read(4);
  EXPECT_EQ(frame.frame, 4);
  EXPECT_TRUE(frame.isCovered({2, 3}));
  EXPECT_FALSE(frame.isCovered({3, 2}));
  EXPECT_FALSE(test::paintedFrame({}, 4).isCovered({2, 3}));
}

TEST(ColorCheck, LeavesTheBiasOfTexturesOpen) {
  const Diagnosis diagnosis = examine(test::paintedExamination({}, 8));
  const auto isOfBias = [](const Undecided& open) {
    return open.faults == std::vector<Fault>{Fault::MipBiasMissing, Fault::MipBiasLeftOn};
  };
  EXPECT_EQ(std::ranges::count_if(diagnosis.parts.undecided(), isOfBias), 1);
}

TEST(ColorCheck, TellsAnInterfaceBeforeAStepOfBrightness) {
  const Diagnosis diagnosis = examine(test::paintedExamination({}, 14, [](DoctorFrame& frame) {
    test::paintInterface(frame, glm::vec2(0.0f));
    if (frame.frame < 9) return;
    for (float& luma : frame.luma.pixels) luma = 2.0f * luma / (1.0f + luma); // twice the light
  }));
  ASSERT_EQ(diagnosis.findings.size(), 2u);
  EXPECT_EQ(diagnosis.findings[0].id, "interfaceBefore");
  EXPECT_EQ(diagnosis.findings[1].id, "exposureStep");
}

} // namespace taa::doctor
