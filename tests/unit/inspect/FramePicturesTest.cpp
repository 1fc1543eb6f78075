// Pictures of small frames whose pixels are known by hand.
#include "core/picture/FramePictures.h"

#include "core/base/Light.h"
#include "core/render/FrameInputs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa {

namespace {

/// A row of grays that moved one pixel to the right since the frame before.
capture::DecodedFrame rowOf(const std::vector<float>& grays) {
  capture::DecodedFrame frame;
  const auto width = static_cast<int>(grays.size());
  frame.color = Image(width, 1, 4);
  frame.motion = Image(width, 1, 2);
  for (int x = 0; x < width; ++x) {
    for (int channel = 0; channel < 3; ++channel)
      frame.color.at(x, 0)[channel] = grays[static_cast<std::size_t>(x)];
    frame.color.at(x, 0)[3] = 1.0f;
    frame.motion.at(x, 0)[0] = 1.0f;
  }
  return frame;
}

using Bytes = std::vector<std::uint8_t>;

Bytes pixelOf(const Picture& picture, int x) {
  const auto first = picture.rgba.begin() + 4 * x;
  return {first, first + 4};
}

} // namespace

TEST(FramePictures, BringTheFrameBeforeAlongItsMotion) {
  capture::DecodedFrame frame = rowOf({0.5f, 0.25f, 1.0f});
  const capture::DecodedFrame previous = rowOf({0.25f, 1.0f, 0.125f});
  const Image warped = warpedPrevious(frame, previous);
  EXPECT_EQ(warped.texel(0, 0), glm::vec4(0.0f)) << "it was outside";
  EXPECT_EQ(warped.texel(1, 0), frame.color.texel(1, 0));
  EXPECT_EQ(warped.texel(2, 0), frame.color.texel(2, 0));
  frame.motion.at(1, 0)[0] = kNoPreviousPosition;
  EXPECT_EQ(warpedPrevious(frame, previous).texel(1, 0), glm::vec4(0.0f));
  EXPECT_TRUE(warpedPrevious(frame, rowOf({0.0f})).empty());
}

TEST(FramePictures, AreExposedForAllButTheBrightest) {
  const capture::DecodedFrame frame = rowOf({0.5f, NAN, 1.0f, 4.0f});
  const FramePictures pictures = drawFrame(frame, nullptr);
  const std::uint8_t half = srgbByte(0.5f);
  EXPECT_EQ(pixelOf(pictures.color, 0), (Bytes{half, half, half, 255}));
  EXPECT_EQ(pixelOf(pictures.color, 1), (Bytes{255, 0, 0, 255}));
  EXPECT_EQ(pixelOf(pictures.color, 2), (Bytes{255, 255, 255, 255}));
  EXPECT_EQ(pixelOf(pictures.color, 3), (Bytes{255, 255, 255, 255}));
  EXPECT_TRUE(pictures.depth.rgba.empty() && pictures.warped.rgba.empty() &&
              pictures.difference.rgba.empty());
}

TEST(FramePictures, AreNoLargerThanIsAskedFor) {
  capture::DecodedFrame frame = rowOf({0.25f, 0.75f, 0.5f, 0.5f, 1.0f});
  frame.motion.at(1, 0)[0] = -1.0f; // the one of the first two that is picked
  const FramePictures pictures = drawFrame(frame, nullptr, 3);
  EXPECT_EQ(pictures.color.width, 3);
  EXPECT_EQ(pictures.color.height, 1);
  EXPECT_EQ(pixelOf(pictures.color, 0), pixelOf(pictures.color, 1))
      << "the mean of both is that of the next two";
  EXPECT_EQ(pictures.motion.width, 3);
  EXPECT_NE(pixelOf(pictures.motion, 0), pixelOf(pictures.motion, 1));
}

} // namespace taa
