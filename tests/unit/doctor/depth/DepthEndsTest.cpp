// A ground that a camera looks along with the sky above it, by the projection 0.1 m over the distance.
#include "core/doctor/depth/DepthEnds.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>

namespace taa::doctor {
namespace {

constexpr int kWidth = 60, kHeight = 80, kHorizon = 20;

/// `stored`: of a distance in m; of nothing where nothing is drawn.
DepthEnds endsOf(const std::function<double(std::optional<double> distance)>& stored) {
  DoctorFrame frame;
  frame.depth = Image(kWidth, kHeight, 1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const std::optional<double> distance =
          y < kHorizon ? std::nullopt : std::optional(1.5 * kHeight / (y - kHorizon + 1.0));
      *frame.depth.at(x, y) = static_cast<float>(stored(distance));
    }
  DepthEnds out;
  out.add(frame);
  return out;
}

} // namespace

TEST(DepthEnds, AreTurnedWhereTheSkyLiesInTheNearPlane) {
  const DepthEnds right = endsOf([](std::optional<double> m) { return m ? 0.1 / *m : 0.0; });
  EXPECT_EQ(right.atFar, static_cast<std::size_t>(kWidth * kHorizon));
  EXPECT_EQ(right.pixels(), static_cast<std::size_t>(kWidth * kHeight));
  EXPECT_FALSE(right.isSkyNear());
  const DepthEnds turned = endsOf([](std::optional<double> m) { return m ? 1.0 - 0.1 / *m : 1.0; });
  EXPECT_TRUE(turned.isSkyNear());
  EXPECT_TRUE(turned.isTurned());
}

TEST(DepthEnds, AreNotTurnedWhereDistancesAreStored) {
  const DepthEnds distances = endsOf([](std::optional<double> m) { return m ? *m / 100.0 : 1.0; });
  EXPECT_TRUE(distances.isSkyNear());
  EXPECT_FALSE(distances.isTurned());
  EXPECT_NEAR(distances.least, 0.02, 1e-6); // the last row, 2 m away
}

// Device depth that is taken for a distance in meters is nearer than any near plane.
TEST(DepthEnds, AreAllNearWhereDepthIsOfAnotherKind) {
  const DepthEnds all = endsOf([](std::optional<double> m) { return m ? 1.0 : 0.0; });
  EXPECT_TRUE(all.isAllNear());
  EXPECT_FALSE(all.isDrawnFar());
  EXPECT_FALSE(endsOf([](std::optional<double> m) { return m ? 0.1 / *m : 0.0; }).isAllNear());
}

TEST(DepthEnds, AreDrawnFarWhereNumbersSayThatSomethingIsThere) {
  DoctorFrame frame;
  frame.depth = Image(kWidth, kHeight, 1);
  DepthEnds sky;
  sky.add(frame);
  EXPECT_FALSE(sky.isDrawnFar()) << "without numbers it may be the sky";
  frame.objectId.assign(frame.depth.pixels.size(), 3);
  DepthEnds ends;
  ends.add(frame);
  EXPECT_TRUE(ends.isDrawnFar());
}

// A weapon or an interface that is drawn in the near plane has the sky, or what is far away, beside it.
TEST(DepthEnds, AreNotTurnedBySomethingInTheNearPlane) {
  EXPECT_FALSE(endsOf([](std::optional<double> m) {
                 return !m ? 0.0 : *m < 3.0 ? 1.0 : 0.1 / *m;
               }).isSkyNear());
  EXPECT_FALSE(endsOf([](std::optional<double> m) {
                 return !m ? 0.01 : *m < 3.0 ? 1.0 : 0.1 / *m;
               }).isTurned());
}

} // namespace taa::doctor
