// The error of a pixel by part and frame, of frames made by hand.
#include "core/verdict/pixel/PixelError.h"

#include "tests/support/verdicts/MadeEvidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

namespace {

using taa::ErrorPart;
using taa::of;
using namespace taa::test;

glm::dvec3 sumOf(const taa::PixelError& found) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& part : found.sum) sum += part;
  return sum;
}

TEST(PixelError, PartsOfAnyFramesSumUpToTheError) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  MadeEvidence evidence;
  for (int number = 0; number < 9; ++number) {
    MadeEvidence::Frame frame = stillFrame(0.0);
    frame.starts = number == 0;
    for (int y = 0; y < kMadeHeight; ++y)
      for (int x = 0; x < kMadeWidth; ++x) {
        MadeEvidence::Pixel& pixel = frame.pixels[MadeEvidence::indexOf({x, y})];
        pixel.current = {value(random), value(random), value(random)};
        pixel.alpha = glm::dvec3(value(random));
        pixel.added = glm::dvec3(0.1 * value(random));
        const double weight = value(random);
        pixel.taps = {{{(x + number) % kMadeWidth, y}, weight}, {{x, (y + 1) % kMadeHeight}, 1.1 - weight}};
        for (int channel = 0; channel < 3; ++channel)
          frame.reference.at(x, y)[channel] = static_cast<float>(value(random));
        if (value(random) < 0.3) frame.steps.at(x, y)[0] = std::numeric_limits<float>::quiet_NaN();
      }
    evidence.add(number, frame);
  }
  for (const int frames : {1, 3, 32})
    for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(3, 2), glm::ivec2(7, 3)}) {
      taa::LineageOptions options;
      options.frames = frames;
      options.minWeight = 1e-3;
      const taa::PixelError found = pixelError(evidence, 8, pixel, options);
      const glm::dvec3 sum = sumOf(found);
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(sum[channel], found.error()[channel], 1e-12) << frames;
    }
}

TEST(PixelError, IsAGhostOfWhatWasReadWhereTheSurfaceWasNotSeen) {
  MadeEvidence evidence;
  MadeEvidence::Frame before = stillFrame(0.8);
  before.starts = true;
  before.steps.at(4, 2)[2] = 6.0f; // object 6 was in front
  evidence.add(0, before);
  MadeEvidence::Frame now = stillFrame(0.2);
  now.steps.at(4, 2)[0] = std::numeric_limits<float>::quiet_NaN();
  evidence.add(1, now);
  evidence.add(2, stillFrame(0.2));
  const taa::PixelError found = pixelError(evidence, 2, {4, 2});
  // ¾ of ¾ of a history that is 0.6 too bright.
  EXPECT_NEAR(of(found.sum, ErrorPart::Ghost).x, 0.75 * 0.75 * 0.6, 1e-7);
  EXPECT_NEAR(found.error().x, 0.75 * 0.75 * 0.6, 1e-7);
  ASSERT_GE(found.frames.size(), 2u);
  EXPECT_EQ(found.frames[0].ghostObject, -1);
  EXPECT_EQ(found.frames[1].frame, 1);
  EXPECT_EQ(found.frames[1].ghostObject, 6);
  EXPECT_EQ(found.frames[1].ghostPixel, glm::ivec2(4, 2));
}

TEST(PixelError, IsAGhostWhereHistoryWasReadBesideItsSurface) {
  MadeEvidence evidence;
  MadeEvidence::Frame before = stillFrame(0.5);
  before.starts = true;
  before.steps.at(5, 2)[2] = 3.0f;
  for (int channel = 0; channel < 3; ++channel) before.reference.at(5, 2)[channel] = 0.9f;
  before.pixels[MadeEvidence::indexOf({5, 2})].current = glm::dvec3(0.9);
  evidence.add(0, before);
  MadeEvidence::Frame now = stillFrame(0.5);
  MadeEvidence::Pixel& pixel = now.pixels[MadeEvidence::indexOf({4, 2})];
  pixel.read = {5.5, 2.5}; // a neighbor's motion, although the surface did not move
  pixel.taps = {{{5, 2}, 1.0}};
  evidence.add(1, now);
  const taa::PixelError found = pixelError(evidence, 1, {4, 2});
  EXPECT_NEAR(of(found.sum, ErrorPart::Ghost).y, 0.75 * 0.4, 1e-7);
  EXPECT_EQ(found.frames[0].ghostObject, 3);
  EXPECT_TRUE(found.frames[0].isGhostOfMotion) << "its own would have led to what it is";

  for (int channel = 0; channel < 3; ++channel) before.reference.at(4, 2)[channel] = 0.8f;
  evidence.add(0, before);
  EXPECT_FALSE(pixelError(evidence, 1, {4, 2}).frames[0].isGhostOfMotion) << "to much the same";
}

/// By object, of all frames.
std::map<int, double> pullsOf(const taa::PixelError& found) {
  std::map<int, double> pulls;
  for (const taa::OutlierSamples& outlier : found.outliers) pulls[outlier.object] += outlier.pull.x;
  return pulls;
}

TEST(PixelError, TellsWhatIsSeenInAGhostFromWhatItCameInBehind) {
  MadeEvidence evidence;
  MadeEvidence::Frame bright = coveredFrame(0.9, 5);
  bright.starts = true;
  evidence.add(0, bright);
  evidence.add(1, coveredFrame(0.6, 1));
  evidence.add(2, coveredFrame(0.0, 2)); // darker than what is before and behind it
  evidence.add(3, coveredFrame(0.55, 9));
  const taa::PixelError found = pixelError(evidence, 3, {2, 1});
  // Shares of the samples: 1/4, 3/4 of 1/4 … and, of the first, all that is left.
  ASSERT_EQ(found.outliers.size(), 3u);
  EXPECT_EQ(found.outliers[0].frame, 2);
  EXPECT_EQ(found.outliers[2].frame, 0);
  EXPECT_NEAR(pullsOf(found)[2], 0.75 * 0.25 * (0.0 - 0.55), 1e-7);
  EXPECT_NEAR(pullsOf(found)[1], 0.75 * 0.75 * 0.25 * (0.6 - 0.55), 1e-7);
  EXPECT_NEAR(pullsOf(found)[5], 0.75 * 0.75 * 0.75 * (0.9 - 0.55), 1e-7);
  EXPECT_FALSE(pullsOf(found).contains(9)) << "today's surface";
  EXPECT_NEAR(found.outliers[0].weight, 0.75 * 0.25, 1e-12);
  EXPECT_NEAR(found.outliers[2].weight, 0.75 * 0.75 * 0.75, 1e-12);
  EXPECT_NEAR(of(found.frames[1].split, ErrorPart::Ghost).x, 0.75 * 0.75 * (0.6 - 0.0), 1e-7)
      << "most came in with the dark one";
  EXPECT_EQ(found.frames[1].ghostObject, 1);
}

TEST(PixelError, TakesNothingFromSamplesThatRectificationReplaced) {
  MadeEvidence evidence;
  MadeEvidence::Frame before = coveredFrame(0.8, 6);
  before.starts = true;
  evidence.add(0, before);
  MadeEvidence::Frame now = coveredFrame(0.2, 1);
  MadeEvidence::Pixel& pixel = now.pixels[MadeEvidence::indexOf({2, 1})];
  pixel.rectified = 0.75;
  pixel.added = glm::dvec3(0.75 * 0.75 * (0.2 - 0.8));
  evidence.add(1, now);
  const taa::PixelError found = pixelError(evidence, 1, {2, 1});
  EXPECT_NEAR(found.error().x, 0.25 * 0.75 * 0.6, 1e-7);
  EXPECT_NEAR(pullsOf(found)[6], 0.25 * 0.75 * 0.6, 1e-7);
}

TEST(PixelError, KnowsWhatIsLeftOfAGhostBeforeTheWindow) {
  MadeEvidence evidence;
  MadeEvidence::Frame first = coveredFrame(0.8, 6);
  first.starts = true;
  evidence.add(0, first);
  MadeEvidence::Frame second = stillFrame(0.8);
  for (int y = 0; y < kMadeHeight; ++y)
    for (int x = 0; x < kMadeWidth; ++x) second.steps.at(x, y)[2] = 6.0f;
  evidence.add(1, second);
  evidence.add(2, coveredFrame(0.2, 1));
  taa::LineageOptions options;
  options.frames = 1;
  const taa::PixelError found = pixelError(evidence, 2, {2, 1}, options);
  EXPECT_NEAR(pullsOf(found)[6], 0.75 * 0.6, 1e-7);
  ASSERT_TRUE(found.older);
  EXPECT_EQ(found.older->frame, 1);
  EXPECT_EQ(found.older->pixel, glm::ivec2(2, 1));
  EXPECT_FALSE(pixelError(evidence, 2, {2, 1}).older) << "history starts in the window";
}

TEST(PixelError, KnowsWhatIsBlendedOverAndWhatChangesWithoutMotion) {
  MadeEvidence evidence;
  MadeEvidence::Frame before = stillFrame(0.6);
  before.starts = true;
  before.steps.at(2, 1)[3] = static_cast<float>(taa::StepFlag::BlendedOver);
  evidence.add(0, before);
  MadeEvidence::Frame now = stillFrame(0.1);
  now.steps.at(2, 1)[3] = static_cast<float>(taa::StepFlag::Changes);
  evidence.add(1, now);
  const taa::PixelError found = pixelError(evidence, 1, {2, 1});
  ASSERT_EQ(found.frames.size(), 2u);
  EXPECT_TRUE(found.frames[0].isChanging);
  EXPECT_FALSE(found.frames[0].isBlendedOver);
  EXPECT_TRUE(found.frames[1].isBlendedOver);
  EXPECT_FALSE(found.frames[1].isChanging);
}

TEST(PixelError, IsLagWhereTheLightChanged) {
  MadeEvidence evidence;
  MadeEvidence::Frame before = stillFrame(0.6);
  before.starts = true;
  evidence.add(0, before);
  evidence.add(1, stillFrame(0.1));
  const taa::PixelError found = pixelError(evidence, 1, {2, 1});
  EXPECT_NEAR(of(found.sum, ErrorPart::Lag).z, 0.75 * 0.5, 1e-7);
  EXPECT_NEAR(found.error().z, 0.75 * 0.5, 1e-7);
}

TEST(PixelError, IsAliasingWhereSamplesAreNotTheMean) {
  MadeEvidence evidence;
  MadeEvidence::Frame first = stillFrame(0.5);
  first.starts = true;
  evidence.add(0, first);
  MadeEvidence::Frame second = stillFrame(0.5);
  second.pixels[MadeEvidence::indexOf({2, 1})].current = glm::dvec3(0.9);
  evidence.add(1, second);
  evidence.add(2, stillFrame(0.5));
  const taa::PixelError found = pixelError(evidence, 2, {2, 1});
  EXPECT_NEAR(of(found.sum, ErrorPart::Aliasing).x, 0.75 * 0.25 * 0.4, 1e-7);
  EXPECT_NEAR(of(found.frames[1].split, ErrorPart::Aliasing).x, 0.75 * 0.25 * 0.4, 1e-7);
}

TEST(PixelError, IsRectificationsWhereHistoryWasPulledAway) {
  MadeEvidence evidence;
  MadeEvidence::Frame first = stillFrame(0.5);
  first.starts = true;
  evidence.add(0, first);
  MadeEvidence::Frame second = stillFrame(0.5);
  second.pixels[MadeEvidence::indexOf({2, 1})].added = glm::dvec3(-0.3);
  evidence.add(1, second);
  const taa::PixelError found = pixelError(evidence, 1, {2, 1});
  EXPECT_NEAR(of(found.sum, ErrorPart::Rectification).x, -0.3, 1e-7);
}

TEST(PixelError, OfBeforeTheWindowIsOlder) {
  MadeEvidence evidence;
  MadeEvidence::Frame first = stillFrame(0.5);
  first.starts = true;
  first.pixels[MadeEvidence::indexOf({2, 1})].current = glm::dvec3(0.9);
  evidence.add(0, first);
  for (int number = 1; number < 4; ++number) evidence.add(number, stillFrame(0.5));
  taa::LineageOptions options;
  options.frames = 2;
  const taa::PixelError found = pixelError(evidence, 3, {2, 1}, options);
  EXPECT_NEAR(of(found.sum, ErrorPart::Older).x, std::pow(0.75, 3) * 0.4, 1e-7);
}

} // namespace
