// Flicker of pictures made by hand, and the ways it is followed along.
#include "core/measure/Flicker.h"
#include "core/measure/Metrics.h"
#include "core/probe/SurfaceSteps.h"
#include "core/render/FrameInputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

using taa::FlickerFrame;
using taa::FlickerMaps;
using taa::Image;
using taa::SeenSurfaces;

namespace {

constexpr int kWide = 9, kHigh = 5;

using ValueAt = std::function<float(int x, int y)>;

Image picture(const ValueAt& value, int channels = 3) {
  Image image(kWide, kHigh, channels);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      for (int channel = 0; channel < channels; ++channel) image.at(x, y)[channel] = value(x, y);
  return image;
}

/// One surface of object 1 that fills the picture, 2 m away, moving by `dx` px a frame.
SeenSurfaces wall(float dx = 0.0f) {
  const auto all = [](float value) { return picture([value](int, int) { return value; }, 1); };
  SeenSurfaces seen{all(1.0f), all(2.0f), Image(kWide, kHigh, 2), all(2.0f)};
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) seen.motionPx.at(x, y)[0] = dx;
  return seen;
}

SeenSurfaces partOf(const SeenSurfaces& seen, const taa::gl::Rect& part) {
  const auto cut = [&](const Image& image) {
    Image cropped(part.width, part.height, image.channels);
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        std::copy_n(image.at(part.x + x, part.y + y), image.channels, cropped.at(x, y));
    return cropped;
  };
  return {cut(seen.objectId),
          cut(seen.depthView),
          cut(seen.motionPx),
          cut(seen.previousDepthView),
          {part.x, part.y}};
}

/// `shown(k, x, y)` of the frame k before the last.
std::vector<FlickerFrame> framesOf(int count, float dx, const std::function<float(int, int, int)>& shown,
                                   const std::function<float(int, int, int)>& reference = {}) {
  std::vector<FlickerFrame> frames(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    FlickerFrame& frame = frames[static_cast<std::size_t>(k)];
    frame.shown = picture([&](int x, int y) { return shown(k, x, y); });
    frame.steps = taa::surfaceSteps(wall(dx), wall(dx));
    if (!reference) continue;
    frame.reference = picture([&](int x, int y) { return reference(k, x, y); });
    frame.referenceSamples = 64;
  }
  return frames;
}

FlickerMaps mapsOf(const std::vector<FlickerFrame>& frames) {
  std::vector<const FlickerFrame*> pointers;
  for (const FlickerFrame& frame : frames) pointers.push_back(&frame);
  return taa::flickerMaps(pointers);
}

float still(int, int, int) {
  return 0.3f;
}

/// Any picture that repeats nothing.
float pattern(int x, int y) {
  return 0.1f * static_cast<float>((7 * x + 3 * y + 900) % 10);
}

} // namespace

TEST(Flicker, IsNothingWhereNothingChanges) {
  const FlickerMaps maps = mapsOf(framesOf(7, 0.0f, still, still));
  for (std::size_t pixel = 0; pixel < maps.frames.pixels.size(); ++pixel) {
    EXPECT_EQ(maps.deviation.pixels[pixel], 0.0f);
    EXPECT_EQ(maps.flicker.pixels[pixel], 0.0f);
    EXPECT_EQ(maps.frames.pixels[pixel], 7.0f);
  }
  EXPECT_EQ(taa::meanOverTime(maps.deviation, maps.frames), 0.0);
}

TEST(Flicker, OfTwoValuesInTurnIsHalfTheirDifference) {
  constexpr float kA = 0.2f, kB = 0.7f;
  const auto inTurn = [](int k, int x, int) { return x == 4 && k % 2 == 1 ? kB : kA; };
  const FlickerMaps maps = mapsOf(framesOf(16, 0.0f, inTurn, still));
  const auto half = static_cast<float>((double(kB) - double(kA)) / 2.0);
  EXPECT_EQ(*maps.deviation.at(4, 2), half);
  EXPECT_EQ(*maps.flicker.at(4, 2), half) << "the reference stands still";
  EXPECT_EQ(*maps.deviation.at(3, 2), 0.0f) << "a neighbor";
  EXPECT_NEAR(taa::meanOverTime(maps.flicker, maps.frames).value(), half / kWide, 1e-9);
}

TEST(Flicker, IsTheRootOfTheMeanVarianceOfTheChannels) {
  std::vector<FlickerFrame> frames = framesOf(4, 0.0f, still);
  for (const std::size_t k : {1u, 3u}) frames[k].shown.at(2, 2)[1] = 0.3f + 0.25f;
  EXPECT_FLOAT_EQ(*mapsOf(frames).deviation.at(2, 2), 0.125f / std::sqrt(3.0f));
}

TEST(Flicker, FollowsWhatMoves) {
  // What is at x now was k px to the left k frames ago.
  const auto moving = [](int k, int x, int y) { return pattern(x + k, y); };
  const FlickerMaps followed = mapsOf(framesOf(4, 1.0f, moving));
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) {
      EXPECT_EQ(*followed.deviation.at(x, y), 0.0f) << x;
      EXPECT_EQ(*followed.frames.at(x, y), static_cast<float>(std::min(4, x + 1))) << "then off the picture";
    }
  const FlickerMaps still = mapsOf(framesOf(4, 0.0f, moving));
  EXPECT_GT(*still.deviation.at(6, 2), 0.1f) << "else nothing was tested";
}

TEST(Flicker, ReadsBetweenPixelsInProportion) {
  // A ramp of 1/16 a pixel stands still while the surface moves by half a pixel: exact sums.
  const FlickerMaps maps = mapsOf(framesOf(2, 0.5f, [](int, int x, int) { return float(x) / 16.0f; }));
  EXPECT_EQ(*maps.deviation.at(4, 2), 0.5f / 16.0f / 2.0f);
}

TEST(Flicker, LeavesOutWhatTheReferenceDoesToo) {
  const auto changes = [](int k, int x, int y) { return pattern(x + 3 * k, y); };
  const auto more = [&](int k, int x, int y) { return 2.0f * changes(k, x, y); };
  for (const float value : mapsOf(framesOf(8, 0.0f, changes, changes)).flicker.pixels) EXPECT_EQ(value, 0.0f);
  for (const float value : mapsOf(framesOf(8, 0.0f, changes, more)).flicker.pixels)
    EXPECT_EQ(value, 0.0f) << "what the output lacks is no flicker";
  const FlickerMaps maps = mapsOf(framesOf(8, 0.0f, more, changes));
  for (std::size_t pixel = 0; pixel < maps.flicker.pixels.size(); ++pixel)
    EXPECT_NEAR(maps.flicker.pixels[pixel], maps.deviation.pixels[pixel] * std::sqrt(0.75f), 1e-6f);
}

TEST(Flicker, IsNotComparedWhereAReferenceIsMissing) {
  std::vector<FlickerFrame> frames = framesOf(3, 0.0f, still, still);
  frames[2].referenceSamples = 0;
  EXPECT_TRUE(mapsOf(frames).flicker.empty());
}

TEST(Flicker, StopsWhenItIsTold) {
  const std::vector<FlickerFrame> frames = framesOf(2, 0.0f, still);
  const std::vector<const FlickerFrame*> pointers{&frames[0], &frames[1]};
  int reports = 0;
  const taa::Progress stopsAtThree = [&](std::string_view, int, int) { return ++reports < 3; };
  EXPECT_THROW(taa::flickerMaps(pointers, stopsAtThree), taa::Cancelled);
}

TEST(Flicker, HasNoMeanWhereNothingWasSeenBefore) {
  const FlickerMaps maps = mapsOf(framesOf(1, 0.0f, still));
  EXPECT_FALSE(taa::meanOverTime(maps.deviation, maps.frames));
}

TEST(SurfaceSteps, AreTheMotionOfWhatWasSeen) {
  const Image steps = taa::surfaceSteps(wall(2.0f), wall());
  EXPECT_TRUE(std::isnan(steps.at(1, 2)[0])) << "it came from outside";
  EXPECT_EQ(steps.at(2, 2)[0], 2.0f);
  EXPECT_EQ(steps.at(2, 2)[2], 1.0f) << "the object";
}

TEST(SurfaceSteps, EndWhereSomethingElseWasInFront) {
  SeenSurfaces before = wall();
  for (int y = 0; y < kHigh; ++y)
    for (int x = 3; x < 6; ++x) *before.objectId.at(x, y) = 2.0f;
  Image steps = taa::surfaceSteps(wall(), before);
  EXPECT_TRUE(std::isnan(steps.at(4, 2)[0])) << "another object in all of the 3×3";
  EXPECT_EQ(steps.at(3, 2)[0], 0.0f) << "the surface is beside it";
  EXPECT_EQ(steps.at(3, 2)[3], 1.0f) << "and not there";
  EXPECT_EQ(steps.at(2, 2)[3], 0.0f);
  before = wall();
  for (float& depth : before.depthView.pixels) depth = 1.9f;
  EXPECT_TRUE(std::isnan(taa::surfaceSteps(wall(), before).at(4, 2)[0])) << "the same object, nearer";
  for (float& depth : before.depthView.pixels) depth = 1.99f;
  EXPECT_EQ(taa::surfaceSteps(wall(), before).at(4, 2)[0], 0.0f) << "within a hundredth";
  *before.depthView.at(3, 2) = 1.0f;
  *before.depthView.at(5, 2) = 3.0f;
  EXPECT_EQ(taa::surfaceSteps(wall(), before).at(4, 2)[0], 0.0f) << "a slope";
}

TEST(SurfaceSteps, SayWhatTheMaskSays) {
  SeenSurfaces now = wall(), before = wall();
  EXPECT_EQ(taa::surfaceSteps(now, before).at(4, 2)[3], 0.0f) << "there is none";
  now.mask = Image(kWide, kHigh, 2);
  now.mask.at(3, 2)[0] = 0.2f;
  now.mask.at(4, 2)[1] = 1.0f;
  *before.objectId.at(3, 2) = 2.0f;
  const Image steps = taa::surfaceSteps(now, before);
  EXPECT_EQ(steps.at(2, 2)[3], 0.0f);
  EXPECT_TRUE(taa::hasFlag(steps.at(3, 2)[3], taa::StepFlag::BlendedOver));
  EXPECT_TRUE(taa::hasFlag(steps.at(3, 2)[3], taa::StepFlag::SeenBeside));
  EXPECT_FALSE(taa::hasFlag(steps.at(3, 2)[3], taa::StepFlag::Changes));
  EXPECT_EQ(steps.at(4, 2)[3], static_cast<float>(taa::StepFlag::Changes));
}

TEST(SurfaceSteps, EndWhereThereIsNoPreviousPosition) {
  EXPECT_TRUE(std::isnan(taa::surfaceSteps(wall(taa::kNoPreviousPosition), wall()).at(4, 2)[0]));
}

TEST(SurfaceSteps, AreLookedUpAtTheSameObject) {
  Image steps = taa::surfaceSteps(wall(1.0f), wall());
  steps.at(4, 2)[2] = 2.0f; // something else
  steps.at(5, 2)[0] = 3.0f;
  EXPECT_EQ(taa::stepAt(steps, {4.75, 2.5}, 1.0f), glm::dvec2(3.0, 0.0)) << "the nearest around";
  EXPECT_EQ(taa::stepAt(steps, {4.75, 2.5}, 2.0f), glm::dvec2(1.0, 0.0)) << "the pixel itself";
  EXPECT_FALSE(taa::stepAt(steps, {4.75, 2.5}, 7.0f)) << "not there";
  EXPECT_FALSE(taa::stepAt(steps, {0.5, 2.5}, 1.0f)) << "it came from outside";
}

// A wall that moves by 2 px, and a thing of another color and way in it, looked at through a window.
TEST(SurfaceSteps, OfAPartAreThoseOfTheWhole) {
  SeenSurfaces now = wall(2.0f);
  *now.objectId.at(5, 2) = 2.0f;
  now.motionPx.at(5, 2)[0] = -1.0f;
  const SeenSurfaces before = wall();
  const Image whole = taa::surfaceSteps(now, before);
  const taa::gl::Rect part{4, 1, 3, 2};
  SeenSurfaces partNow = partOf(now, {3, 1, 5, 3});
  const taa::gl::Rect places = taa::formerPlaces(partNow, part, {kWide, kHigh});
  EXPECT_EQ(places, (taa::gl::Rect{1, 0, 7, 4}))
      << "from 2 px to the left of 4 to 1 px right of 5, and around";
  const Image steps = taa::surfaceSteps(partNow, partOf(before, places), part, {kWide, kHigh});
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      for (int channel = 0; channel < taa::kStepChannels; ++channel) {
        const float expected = whole.at(part.x + x, part.y + y)[channel];
        const float value = steps.at(x, y)[channel];
        EXPECT_TRUE(value == expected || (std::isnan(value) && std::isnan(expected))) << x << " " << y;
      }
}

TEST(SurfaceSteps, OfWhatCameFromOutsideAreLookedForNowhere) {
  EXPECT_EQ(taa::formerPlaces(wall(20.0f), {0, 0, 3, 3}, {kWide, kHigh}).width, 0);
}

TEST(ShownColors, AreClampedAndEncoded) {
  Image linear(3, 1, 4);
  linear.pixels = {-1.0f, 0.0f, 0.003f, 9.0f, 1.0f, 7.0f, 0.5f, 9.0f, 0.214041f, 0.0f, 0.0f, 9.0f};
  const Image shown = taa::shownColors(linear);
  ASSERT_EQ(shown.channels, 3);
  EXPECT_EQ(shown.at(0, 0)[0], 0.0f);
  EXPECT_FLOAT_EQ(shown.at(0, 0)[2], 12.92f * 0.003f);
  EXPECT_EQ(shown.at(1, 0)[0], 1.0f);
  EXPECT_EQ(shown.at(1, 0)[1], 1.0f);
  EXPECT_NEAR(shown.at(1, 0)[2], 0.735357f, 1e-6f);
  EXPECT_NEAR(shown.at(2, 0)[0], 0.5f, 1e-6f);
}
