// What light says of the encoding that is stated for it: on frames of two values.
#include "core/doctor/color/ScreenEncoding.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace taa::doctor {
namespace {

/// 100 × 100 pixels of light ½, `bright` of them of light `most`.
BrightLight lightOf(std::size_t bright, float most) {
  DoctorFrame frame;
  frame.luma = Image(100, 100, 1);
  for (std::size_t i = 0; i < frame.luma.pixels.size(); ++i) {
    const float light = i < bright ? most : 0.5f;
    frame.luma.pixels[i] = light / (1.0f + light);
  }
  BrightLight out;
  out.add(frame);
  return out;
}

Diagnosis told(const BrightLight& light, capture::ColorEncoding encoding, bool isPreExposed = false) {
  CaptureInfo captureInfo;
  captureInfo.conventions.emplace();
  captureInfo.conventions->color = {encoding, isPreExposed};
  Diagnosis out;
  tellEncoding(light, captureInfo, out);
  return out;
}

TEST(ScreenEncoding, OfLightBeyondAScreenIsNamedWhereItIsStatedAsEncoded) {
  const Diagnosis out = told(lightOf(50, 8.0f), capture::ColorEncoding::Srgb);
  ASSERT_EQ(out.findings.size(), 1u);
  EXPECT_EQ(out.findings[0].id, "colorEncoding");
  EXPECT_EQ(out.findings[0].reason,
            "Color is stated as encoded for a screen, which ends at 1; decoded it goes up to 8.");
  EXPECT_TRUE(out.parts.undecided().empty());
}

TEST(ScreenEncoding, OfLightBeyondAScreenIsRightWhereItIsStatedAsLinear) {
  const Diagnosis out = told(lightOf(50, 8.0f), capture::ColorEncoding::Linear);
  EXPECT_TRUE(out.findings.empty());
  ASSERT_EQ(out.parts.right().size(), 1u);
}

// Ringing of a filter, or exposure that is taken off, goes a little or far beyond 1.
TEST(ScreenEncoding, IsOpenWhereLightSaysNothing) {
  for (const auto encoding : {capture::ColorEncoding::Linear, capture::ColorEncoding::Srgb})
    for (const BrightLight& light : {lightOf(0, 0.0f), lightOf(5000, 1.2f), lightOf(9, 100.0f)}) {
      const Diagnosis out = told(light, encoding);
      EXPECT_TRUE(out.findings.empty());
      EXPECT_TRUE(out.parts.right().empty());
      ASSERT_EQ(out.parts.undecided().size(), 1u);
      EXPECT_EQ(out.parts.undecided()[0].question, "Color's encoding");
    }
  EXPECT_TRUE(told(lightOf(50, 8.0f), capture::ColorEncoding::Srgb, true).findings.empty());
}

TEST(ScreenEncoding, OfAScenesOwnFramesIsNoQuestion) {
  Diagnosis out;
  tellEncoding(lightOf(50, 8.0f), {}, out);
  EXPECT_TRUE(out.findings.empty() && out.parts.right().empty() && out.parts.undecided().empty());
}

} // namespace
} // namespace taa::doctor
