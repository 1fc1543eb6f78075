// Previous cameras that are found from the motion that they make.
#include "core/doctor/motion/OtherCameras.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <functional>
#include <optional>

namespace taa::doctor {
namespace {

using Previous = std::function<glm::dmat4(const glm::dmat4& clipFromView, const glm::dmat4& previousView)>;

/// A slope from 2 to 8 m away that a camera passes, its motion made with another previous camera; the sky in
/// the rows above it.
DoctorFrame frameWith(const Previous& previousClipFromWorld, int skyRows = 0) {
  constexpr int kWide = 64, kHigh = 48;
  constexpr double kNear = 0.1;
  glm::dmat4 clipFromView(0.0); // reversed, its far plane at infinity
  clipFromView[0][0] = 1.5;
  clipFromView[1][1] = 2.0;
  clipFromView[2][3] = -1.0;
  clipFromView[3][2] = kNear;
  const glm::dmat4 view = glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, -1.0, 0.2));
  const glm::dmat4 previousView = glm::translate(glm::dmat4(1.0), glm::dvec3(0.28, -1.0, 0.25));
  DoctorFrame out;
  out.luma = out.depth = Image(kWide, kHigh, 1);
  out.motionPx = Image(kWide, kHigh, 2);
  out.cameras = UnjitteredCameras{clipFromView, view, previousView};
  const glm::dmat4 worldFromClip = glm::inverse(clipFromView * view);
  out.previousClipFromClip = glm::mat4(clipFromView * previousView * worldFromClip);
  const glm::mat4 wrong(previousClipFromWorld(clipFromView, previousView) * worldFromClip);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) {
      if (y >= skyRows)
        *out.depth.at(x, y) = static_cast<float>(kNear / (2.0 + 6.0 * (x + 2.0 * y) / (kWide + 2.0 * kHigh)));
      const auto motion = motionUnder(wrong, out, {x, y}, *out.depth.at(x, y));
      out.motionPx.at(x, y)[0] = motion ? motion->x : kNoPreviousPosition;
      out.motionPx.at(x, y)[1] = motion ? motion->y : kNoPreviousPosition;
    }
  return out;
}

/// How far the motion of a found camera is from that given, px, in the middle of the picture.
float missOf(const DoctorFrame& frame, const std::optional<glm::mat4>& found) {
  const auto motion = motionUnder(*found, frame, {32, 24}, *frame.depth.at(32, 24));
  return glm::distance(*motion, frame.motionAt(32, 24));
}

} // namespace

TEST(OtherCameras, AreNoneWhereMotionIsTheCameras) {
  const OtherCameras others =
      otherCameras(frameWith([](const glm::dmat4& clip, const glm::dmat4& view) { return clip * view; }));
  EXPECT_FALSE(others.turned || others.beside || others.mirrored || others.identity);
}

TEST(OtherCameras, FindATurnedOne) {
  const DoctorFrame frame = frameWith([](const glm::dmat4& clip, const glm::dmat4& view) {
    return clip * glm::rotate(glm::dmat4(1.0), glm::radians(1.0), glm::dvec3(0.0, 1.0, 0.0)) * view;
  });
  const OtherCameras others = otherCameras(frame);
  ASSERT_TRUE(others.turned);
  EXPECT_FALSE(others.beside);
  EXPECT_LT(missOf(frame, others.turned), 0.01f); // px: matrices are of single precision
}

TEST(OtherCameras, FindOneBeside) {
  const DoctorFrame frame = frameWith([](const glm::dmat4& clip, const glm::dmat4& view) {
    return clip * glm::translate(glm::dmat4(1.0), glm::dvec3(-0.5, 0.0, 0.0)) * view;
  });
  const OtherCameras others = otherCameras(frame);
  ASSERT_TRUE(others.beside);
  EXPECT_FALSE(others.turned);
  EXPECT_LT(missOf(frame, others.beside), 0.01f);
}

TEST(OtherCameras, FindOneBesideUnderAWideSky) {
  // Beside each other, cameras see the same sky: two thirds of the picture have the camera's own motion.
  const auto beside = [](const glm::dmat4& clip, const glm::dmat4& view) {
    return clip * glm::translate(glm::dmat4(1.0), glm::dvec3(-0.5, 0.0, 0.0)) * view;
  };
  const DoctorFrame frame = frameWith(beside, 22);
  EXPECT_NEAR(frame.motionAt(32, 10).x, motionUnder(*frame.previousClipFromClip, frame, {32, 10}, 0.0f)->x,
              1e-3);
  const DoctorFrame wide = frameWith(beside, 32);
  for (const DoctorFrame* one : {&frame, &wide}) {
    const OtherCameras others = otherCameras(*one);
    ASSERT_TRUE(others.beside);
    const auto motion = motionUnder(*others.beside, *one, {32, 40}, *one->depth.at(32, 40));
    EXPECT_LT(glm::distance(*motion, one->motionAt(32, 40)), 0.01f);
  }
}

TEST(OtherCameras, TryAMirroredOne) {
  const DoctorFrame frame = frameWith([](const glm::dmat4& clip, const glm::dmat4& view) {
    return clip * view * glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, -1.0, 1.0));
  });
  const OtherCameras others = otherCameras(frame);
  ASSERT_TRUE(others.mirrored);
  EXPECT_LT(missOf(frame, others.mirrored), 0.01f);
}

TEST(OtherCameras, KnowThoseWhoseWayOrTurningIsMissing) {
  // What is written is that of the frame before but for one of the two: the other half is this frame's.
  const DoctorFrame still =
      frameWith([](const glm::dmat4& clip, const glm::dmat4& view) { return clip * view; });
  const glm::dmat4 now = still.cameras->viewFromWorld, before = still.cameras->previousViewFromWorld;
  const glm::dvec3 way(glm::inverse(now)[3] - glm::inverse(before)[3]);
  ASSERT_GT(glm::length(way), 0.0);
  const DoctorFrame unmoved = frameWith([&](const glm::dmat4& clip, const glm::dmat4& view) {
    return clip * view * glm::translate(glm::dmat4(1.0), -way);
  });
  const OtherCameras others = otherCameras(unmoved);
  ASSERT_TRUE(others.unmoved && others.unturned);
  EXPECT_LT(missOf(unmoved, others.unmoved), 0.01f);
}

TEST(OtherCameras, KnowThoseWithoutTheChangeOfTheFieldOfView) {
  DoctorFrame zoomed = frameWith([](const glm::dmat4& clip, const glm::dmat4& view) { return clip * view; });
  EXPECT_FALSE(otherCameras(zoomed).unzoomed) << "it is the camera's";
  // The projection of the frame before was another one, and motion was made without it.
  glm::dmat4 wider(1.0);
  wider[0][0] = wider[1][1] = 0.95;
  zoomed.previousClipFromClip = glm::mat4(wider * glm::dmat4(*zoomed.previousClipFromClip));
  const OtherCameras others = otherCameras(zoomed);
  ASSERT_TRUE(others.unzoomed);
  EXPECT_LT(missOf(zoomed, others.unzoomed), 0.01f);
  EXPECT_GT(missOf(zoomed, others.unmoved), 0.1f);
}

// The way is from (−0.28, 1, −0.25) to (−0.3, 1, −0.2): views that stand on it, and one that does not.
TEST(OtherCameras, OnTheCamerasWayHaveAShareOfIt) {
  const auto shareOf = [](const glm::dvec3& eye) {
    return otherCameras(frameWith([eye](const glm::dmat4& clip, const glm::dmat4&) {
             return clip * glm::translate(glm::dmat4(1.0), -eye);
           }))
        .wayShare;
  };
  const glm::dvec3 now(-0.3, 1.0, -0.2), before(-0.28, 1.0, -0.25);
  for (const double share : {0.5, 0.625, 1.4}) {
    const auto found = shareOf(now + share * (before - now));
    ASSERT_TRUE(found) << share;
    EXPECT_NEAR(*found, share, 0.01);
  }
  EXPECT_FALSE(shareOf(before + glm::dvec3(0.03, 0.0, 0.02)));
}

} // namespace taa::doctor
