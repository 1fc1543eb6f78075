// Metrics of pictures against values worked out by hand.
#include "core/measure/Metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using taa::Image;
using taa::Metric;

namespace {

Image row(const std::vector<float>& values) {
  Image image(static_cast<int>(values.size()), 1, 1);
  image.pixels = values;
  return image;
}

Image color(int width, int height, float value) {
  Image image(width, height, 3);
  image.pixels.assign(image.pixels.size(), value);
  return image;
}

} // namespace

TEST(PictureError, IsNothingBetweenTheSamePictures) {
  const Image picture = color(3, 2, 0.3f);
  EXPECT_EQ(taa::pictureError(picture, picture).rmse, 0.0);
  EXPECT_EQ(taa::pictureError(picture, picture).rmseLinear, 0.0);
  EXPECT_EQ(taa::pictureError(picture, picture).psnr, std::numeric_limits<double>::infinity());
}

TEST(PictureError, IsTheMeanOverPixelsAndChannels) {
  Image picture = color(2, 2, 0.0f);
  picture.at(1, 0)[2] = 0.5f; // of twelve values
  EXPECT_DOUBLE_EQ(taa::pictureError(picture, color(2, 2, 0.0f)).rmseLinear, std::sqrt(0.25 / 12.0));
  EXPECT_DOUBLE_EQ(taa::pictureError(color(2, 2, 0.0f), picture).rmseLinear, std::sqrt(0.25 / 12.0));
}

TEST(PictureError, TakesPsnrOfWhatIsShown) {
  EXPECT_NEAR(taa::pictureError(color(1, 1, 1.0f), color(1, 1, 0.0f)).psnr, 0.0, 1e-12) << "the peak is 1";
  // On the straight part of sRGB: 12.92 times as large.
  const taa::PictureError dark = taa::pictureError(color(2, 1, 0.002f), color(2, 1, 0.001f));
  EXPECT_NEAR(dark.rmse, 12.92 * 0.001, 1e-8);
  EXPECT_NEAR(dark.psnr, -20.0 * std::log10(12.92 * 0.001), 1e-5);
  EXPECT_NEAR(dark.rmseLinear, 0.001, 1e-9);
  // 0.5 is shown as 0.735357 (IEC 61966-2-1).
  EXPECT_NEAR(taa::pictureError(color(1, 1, 0.5f), color(1, 1, 0.0f)).psnr, -20.0 * std::log10(0.735357),
              1e-4);
}

TEST(PictureError, ShowsNoDifferenceAboveWhiteAndBelowBlack) {
  const taa::PictureError bright = taa::pictureError(color(1, 1, 4.0f), color(1, 1, 1.0f));
  EXPECT_EQ(bright.psnr, std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(bright.rmseLinear, 3.0) << "but there is one";
  EXPECT_EQ(taa::pictureError(color(1, 1, -1.0f), color(1, 1, 0.0f)).psnr,
            std::numeric_limits<double>::infinity());
}

TEST(PictureError, IgnoresOpacity) {
  Image withAlpha(1, 1, 4);
  withAlpha.pixels = {0.25f, 0.5f, 0.75f, 1.0f};
  Image without(1, 1, 3);
  without.pixels = {0.25f, 0.5f, 0.75f};
  EXPECT_EQ(taa::pictureError(withAlpha, without).rmse, 0.0);
}

TEST(Metrics, OfRows) {
  EXPECT_DOUBLE_EQ(taa::metricOf(Metric::MeanAlpha, row({0.0f, 0.5f, 1.0f, 0.5f})), 0.5);
  EXPECT_DOUBLE_EQ(taa::metricOf(Metric::Rejected, row({0, 3, 0, 1, 0, 0, 4, 0})), 37.5)
      << "whatever the reason";
  EXPECT_DOUBLE_EQ(taa::metricOf(Metric::Clipped, row({0.0f, 0.001f, 1.0f, 0.0f})), 50.0);
  EXPECT_DOUBLE_EQ(taa::metricOf(Metric::ClipAmount, row({0.0f, 0.25f, 1.0f, 0.75f})), 0.5);
  EXPECT_DOUBLE_EQ(taa::metricOf(Metric::HistoryLength, row({1.0f, 16.0f})), 8.5);
}
