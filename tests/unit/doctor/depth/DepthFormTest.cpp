// A flat ground that a camera looks along: over it 1 over the distance is linear in pixels, by the
// projection.
#include "core/doctor/depth/DepthForm.h"

#include "core/doctor/frames/Regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kWidth = 120, kHeight = 96;

DepthForm formOf(const std::function<double(double distance)>& stored,
                 const std::function<double(int x, int y)>& distance, int height = kHeight) {
  DoctorFrame frame;
  frame.luma = frame.depth = Image(kWidth, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < kWidth; ++x) *frame.depth.at(x, y) = static_cast<float>(stored(distance(x, y)));
  DepthForm out;
  out.add(frame, std::vector<RegionIndex>(frame.depth.pixels.size(), 0));
  return out;
}

/// Of a ground 1.5 m below the camera; row −20 is its horizon.
double groundDistance(int, int y) {
  return 1.5 * 80.0 / (y + 20.0);
}

} // namespace

TEST(DepthForm, TellsADistanceFromTheDepthOfAProjection) {
  constexpr double kNear = 0.1;
  EXPECT_EQ(formOf([](double m) { return kNear / m; }, groundDistance).isDistance(), false);
  EXPECT_EQ(formOf([](double m) { return 1.0 - kNear / m; }, groundDistance).isDistance(), false);
  EXPECT_EQ(formOf([](double m) { return m / 100.0; }, groundDistance).isDistance(), true);
}

// Rows of two pixels lie beside the middle of three that are an odd number of pixels apart: those on one side
// of it make the depth of a projection look like a distance.
TEST(DepthForm, SaysNothingOfTexelsThatPixelsShare) {
  for (const int shared : {2, 3})
    for (const int height : {kHeight, 120}) {
      const auto coarse = [&](int x, int y) { return groundDistance(x, y / shared * shared + 1); };
      const DepthForm form = formOf([](double m) { return 0.1 / m; }, coarse, height);
      EXPECT_EQ(form.isDistance(), std::nullopt) << shared << " of " << height;
      EXPECT_EQ(form.evenReciprocal, 0u) << shared << " of " << height;
    }
}

TEST(DepthForm, SaysNothingWhereNothingIsFlatOrAllIsAsFarAway) {
  EXPECT_EQ(formOf([](double m) { return 0.1 / m; }, [](int, int) { return 3.0; }).rows(), 0u);
  const auto ball = [](int x, int y) { return 3.0 + std::sin(0.31 * x) * std::cos(0.27 * y); };
  EXPECT_EQ(formOf([](double m) { return 0.1 / m; }, ball).isDistance(), std::nullopt);
}

} // namespace taa::doctor
