// Zoom and pan of a view: what stays under the cursor, which pixel lies where.
#include "app/views/ViewportMath.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace taa::app;
using glm::dvec2;
using glm::ivec2;

namespace {
const ViewGeometry kGeometry{{800, 600}, {1280, 720}};
} // namespace

TEST(ViewportMath, FitShowsTheWholePictureInTheMiddle) {
  const taa::ViewTransform transform = kGeometry.transform({});
  EXPECT_FLOAT_EQ(transform.zoom, 0.625f);
  EXPECT_EQ(screenFromPicture(transform, {0, 0}), dvec2(0, 75));
  EXPECT_EQ(screenFromPicture(transform, {1280, 720}), dvec2(800, 525));
}

TEST(ViewportMath, FitFillsTheView) {
  EXPECT_EQ((ViewGeometry{{800, 600}, {320, 100}}).fitZoom(), 2.5);
  EXPECT_EQ((ViewGeometry{{800, 606}, {4, 4}}).fitZoom(), 151.0) << "large pixels are of one size";
  EXPECT_EQ((ViewGeometry{{8000, 6000}, {4, 4}}).fitZoom(), kGreatestZoom);
}

TEST(ViewportMath, ZoomHoldsThePositionUnderTheCursor) {
  ViewCamera camera;
  const dvec2 cursor(513, 222);
  for (int notch = 0; notch < 12; ++notch) {
    const dvec2 before = pictureFromScreen(kGeometry.transform(camera), cursor);
    camera = kGeometry.zoomed(camera, cursor, wheelFactor(1));
    EXPECT_FALSE(camera.fit);
    const taa::ViewTransform after = kGeometry.transform(camera);
    // The corner lies on a whole screen pixel, so half a screen pixel is the most it can be off, before and
    // after.
    const dvec2 off = screenFromPicture(after, before) - cursor;
    EXPECT_LE(std::abs(off.x), 0.5 + 0.5 * wheelFactor(1) + 1e-3);
    EXPECT_LE(std::abs(off.y), 0.5 + 0.5 * wheelFactor(1) + 1e-3);
  }
  EXPECT_DOUBLE_EQ(camera.zoom, 0.625 * 64);
}

TEST(ViewportMath, ZoomStaysInItsBounds) {
  EXPECT_EQ(kGeometry.zoomed({}, {400, 300}, 1e9).zoom, kGreatestZoom);
  EXPECT_EQ(kGeometry.zoomed({}, {400, 300}, 1e-9).zoom, kMinZoom);
  EXPECT_EQ(wheelFactor(2), 2.0);
  EXPECT_DOUBLE_EQ(wheelFactor(3) * wheelFactor(-3), 1.0);
}

TEST(ViewportMath, OneToOneIsOneScreenPixelAPixel) {
  const ViewCamera camera = kGeometry.oneToOne({}, {400, 300});
  EXPECT_EQ(camera.zoom, 1.0);
  EXPECT_EQ(camera.center, dvec2(640, 360));
  EXPECT_EQ(kGeometry.transform(camera).origin, glm::vec2(240, 60));
}

TEST(ViewportMath, PanMovesThePictureWithTheHand) {
  const ViewCamera camera = kGeometry.oneToOne({}, {400, 300});
  const ViewCamera moved = kGeometry.panned(camera, {-30, 12});
  EXPECT_EQ(moved.center, camera.center + dvec2(30, -12));
  EXPECT_EQ(kGeometry.panned(camera, {1e6, 0}).center.x, 0.0) << "the picture cannot be lost";
}

TEST(ViewportMath, PixelsAreFoundAndTheOutsideIsNothing) {
  const taa::ViewTransform transform{{10, 20}, 4.0f};
  EXPECT_EQ(kGeometry.pixelAt(transform, {0, 0}), ivec2(10, 20));
  EXPECT_EQ(kGeometry.pixelAt(transform, {3.9, 4.0}), ivec2(10, 21));
  EXPECT_FALSE(kGeometry.pixelAt(transform, {-41, 0}));
  EXPECT_EQ(kGeometry.nearestPixel(transform, {-4100, 99999}), ivec2(0, 719));
  const taa::gl::Rect seen = kGeometry.visiblePixels(transform);
  EXPECT_EQ(seen, (taa::gl::Rect{10, 20, 200, 150}));
}

TEST(ViewportMath, AnOlderPictureLandsWhereItBelongs) {
  const taa::ViewTransform drawn{{100, 50}, 2.0f}, now{{110, 50}, 8.0f};
  const ScreenRect rect = movedPicture(drawn, {800, 600}, now);
  EXPECT_EQ(rect.x, -80.0);
  EXPECT_EQ(rect.y, 0.0);
  EXPECT_EQ(rect.width, 3200.0);
  EXPECT_EQ(rect.height, 2400.0);
}

TEST(ViewportMath, RevealMovesTheLeastThatIsNeeded) {
  const ViewCamera camera = kGeometry.oneToOne({}, {400, 300});
  EXPECT_EQ(kGeometry.revealed(camera, {640, 360}), camera);
  const ViewCamera moved = kGeometry.revealed(camera, {0, 360});
  EXPECT_EQ(moved.center, dvec2(400, 360));
  EXPECT_TRUE(kGeometry.pixelAt(kGeometry.transform(moved), {0, 300}));
}

TEST(ViewportMath, FitLeavesTheLegendFree) {
  const ViewGeometry geometry{{800, 600}, {800, 600}, 60};
  const taa::ViewTransform transform = geometry.transform({});
  EXPECT_FLOAT_EQ(transform.zoom, 0.9f);
  EXPECT_NEAR(screenFromPicture(transform, {0, 0}).y, 0.0, 0.5);
  EXPECT_NEAR(screenFromPicture(transform, {0, 600}).y, 540.0, 0.5);
}
