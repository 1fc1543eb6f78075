// A known displacement is found again.
#include "core/doctor/motion/MotionSearch.h"

#include "core/capture/import/FrameSamples.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <vector>

namespace taa::doctor {
namespace {

/// Pixels of a square of the ground whose luma is that of `motionPx` away.
std::vector<SearchedPixel> movedPixels(const Image& luma, const glm::vec2& motionPx) {
  std::vector<SearchedPixel> pixels;
  for (int y = 40; y < 56; ++y)
    for (int x = 20; x < 36; ++x) {
      const glm::vec2 place = glm::vec2(x, y) + 0.5f;
      pixels.push_back({place, capture::betweenPixels(luma, place - motionPx)});
    }
  return pixels;
}

} // namespace

TEST(MotionSearch, FindsWholePixelsAndEighths) {
  const Image luma = test::paintedFrame({}, 0).luma;
  for (const glm::vec2& motion : {glm::vec2(0.0f), glm::vec2(3.0f, -2.0f), glm::vec2(-4.625f, 1.375f)}) {
    const auto found = searchMotion(movedPixels(luma, motion), luma, glm::vec2(0.0f), 6);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, motion);
  }
}

TEST(MotionSearch, SaysNothingOfTooFewPixels) {
  const Image luma = test::paintedFrame({}, 0).luma;
  std::vector<SearchedPixel> pixels = movedPixels(luma, glm::vec2(1.0f));
  pixels.resize(23);
  EXPECT_FALSE(searchMotion(pixels, luma, glm::vec2(0.0f), 6));
}

TEST(MotionSearch, SaysNothingWhereAllPlacesLieOutside) {
  const Image luma = test::paintedFrame({}, 0).luma;
  const auto pixels = movedPixels(luma, glm::vec2(0.0f));
  EXPECT_FALSE(searchMotion(pixels, luma, glm::vec2(500.0f, 0.0f), 6));
}

} // namespace taa::doctor
