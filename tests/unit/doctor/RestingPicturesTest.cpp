// Pictures of a camera at rest against their mean, in pictures whose every edge has a known place.
#include "core/doctor/jitter/RestingPictures.h"

#include "core/doctor/jitter/JitterFit.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kStill = 16;
constexpr glm::ivec2 kStillPx{128, 96};

/// The centroids of a pixel's 4 × 4 parts, in an order that does not go along them.
glm::vec2 jitterOf(int frame) {
  const int part = (frame * 7) % kStill;
  return (glm::vec2(part % 4, part / 4) + 0.5f) / 4.0f - 0.5f;
}

/// Light of edges that are sharp and sampled once in a pixel: nearly upright ones on the left, nearly level
/// ones on the right, which cross pixels everywhere.
DoctorFrame stillFrame(int frame, const glm::vec2& jitterPx) {
  constexpr int kApart = 8, kParts = 32;
  DoctorFrame out;
  out.frame = frame;
  out.jitterPx = jitterPx;
  out.luma = Image(kStillPx.x, kStillPx.y, 1);
  for (int y = 0; y < kStillPx.y; ++y)
    for (int x = 0; x < kStillPx.x; ++x) {
      const bool isUpright = x < kStillPx.x / 2;
      const glm::vec2 place = glm::vec2(x, y) + 0.5f - jitterPx;
      const float across = isUpright ? place.x : place.y;
      const int along = isUpright ? y : x;
      const float past = across - (static_cast<float>(along) + 0.5f) / kParts;
      *out.luma.at(x, y) = past - kApart * std::floor(past / kApart) < 0.5f * kApart ? 0.25f : 0.5f;
    }
  return out;
}

/// Of frames whose pictures are shifted by `jitter`.
RestingPictures still(const std::function<glm::vec2(int frame)>& jitter, int frames = kStill) {
  RestingPictures out;
  for (int frame = 1; frame < frames; ++frame)
    out.add(stillFrame(frame - 1, jitter(frame - 1)), stillFrame(frame, jitter(frame)), true);
  return out;
}

std::optional<std::string> toldAtRest(const std::function<glm::vec2(const glm::vec2&)>& shown) {
  JitterEvidence evidence;
  for (int frame = 0; frame < kStill; ++frame) evidence.stated[frame] = jitterOf(frame);
  evidence.resting = still([&](int frame) { return shown(jitterOf(frame)); });
  const std::vector<JitterTrial> trials = jitterTrials(kStillPx);
  const auto trial = trialAtRest(evidence, trials);
  if (!trial) return {};
  return jitterTrialId(trials[*trial]);
}

} // namespace

// The mean of an edge is a ramp of one pixel, and its slope is read over two: of the light that crosses a
// pixel's middle, slope ½ over the ramp, ∫ ½ = ½; of its square, ¼ over the ramp and ((1.5 − |e|)/2)² beside
// it, ¼ + 2 · 1/12 = 5/12. Measured is ½ over 5/12 of the jitter.
TEST(RestingPictures, MeasureEdgesASixthPartTooLong) {
  constexpr float kFactor = 0.5f / (5.0f / 12.0f);
  const std::map<int, glm::vec2> shown = still(jitterOf).displacementsPx();
  ASSERT_EQ(shown.size(), static_cast<std::size_t>(kStill));
  for (const auto& [frame, px] : shown) // their mean is 0
    EXPECT_LT(glm::distance(px, kFactor * jitterOf(frame)), 0.06f) << frame;
}

TEST(RestingPictures, SayNothingOfTooFewFramesOrPlainOnes) {
  EXPECT_TRUE(still(jitterOf, 7).displacementsPx().empty());
  RestingPictures plain;
  for (int frame = 1; frame < kStill; ++frame) {
    DoctorFrame before = stillFrame(frame - 1, {}), now = stillFrame(frame, {});
    for (DoctorFrame* one : {&before, &now}) one->luma.pixels.assign(one->luma.pixels.size(), 0.5f);
    plain.add(before, now, true);
  }
  EXPECT_TRUE(plain.displacementsPx().empty());
}

TEST(RestingPictures, EndWhereTheCameraMoves) {
  RestingPictures pictures;
  const auto add = [&](int first, int end, bool isResting) {
    for (int frame = first; frame < end; ++frame)
      pictures.add(stillFrame(frame - 1, jitterOf(frame - 1)), stillFrame(frame, jitterOf(frame)), isResting);
  };
  add(1, 10, true);
  add(10, 12, false);
  add(12, kStill, true);
  EXPECT_EQ(pictures.displacementsPx().size(), 10u);
}

TEST(TrialAtRest, IsWhatPicturesHold) {
  EXPECT_EQ(toldAtRest([](const glm::vec2& j) { return j; }), "asStated");
  EXPECT_EQ(toldAtRest([](const glm::vec2& j) { return glm::vec2(-j.x, j.y); }), "mirroredX");
  EXPECT_EQ(toldAtRest([](const glm::vec2& j) { return glm::vec2(j.x, -j.y); }), "mirroredY");
  EXPECT_EQ(toldAtRest([](const glm::vec2& j) { return -j; }), "opposite");
  EXPECT_EQ(toldAtRest([](const glm::vec2& j) { return glm::vec2(j.y, j.x); }), "swappedAxes");
}

TEST(TrialAtRest, IsNoneWherePicturesRestOrShiftAsNothingDoes) {
  EXPECT_FALSE(toldAtRest([](const glm::vec2&) { return glm::vec2(0.0f); }));
  EXPECT_FALSE(toldAtRest([](const glm::vec2& j) { return glm::vec2(j.x, 0.2f * j.y); }));
}

} // namespace taa::doctor
