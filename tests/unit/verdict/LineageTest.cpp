// Which samples a pixel is made of: weights, places and sums that follow by hand from simple steps, and from
// frames of the CPU twin the response that is measured.
#include "core/verdict/lineage/Lineage.h"

#include "core/settings/Parameters.h"
#include "tests/support/frames/LineageShot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

using namespace taa;

namespace {

using test::LineageShot;

/// Steps by a rule; what is read was resolved to the frame's number.
class RuledSource : public LineageSource {
 public:
  explicit RuledSource(std::function<PixelStep(int frame, const glm::ivec2& pixel)> rule)
      : rule_(std::move(rule)) {}
  PixelStep step(int frame, const glm::ivec2& pixel) override {
    ++steps;
    return rule_(frame, pixel);
  }
  int steps = 0;

 private:
  std::function<PixelStep(int frame, const glm::ivec2& pixel)> rule_;
};

/// At rest, one sample at the pixel's center; frame 0 starts history.
PixelStep stillStep(int frame, const glm::ivec2& pixel, double alpha) {
  PixelStep step;
  step.alpha = glm::dvec3(frame == 0 ? 1.0 : alpha);
  step.samples = {{pixel, 1.0, glm::dvec2(0.0)}};
  step.historyPosition = glm::dvec2(pixel) + 0.5;
  if (frame > 0) step.history = {{pixel, 1.0, glm::dvec3(0.5)}};
  step.current = step.resolved = glm::dvec3(0.5);
  return step;
}

double wholeOf(const Lineage& lineage) {
  return lineage.weight + lineage.rectified + lineage.older + lineage.pruned + lineage.blank;
}

double weightOf(const Lineage& lineage, int frame, const glm::ivec2& texel) {
  for (const FootprintSample& sample : lineage.samples)
    if (sample.frame == frame && sample.texel == texel) return sample.weight;
  return 0.0;
}

/// Frames of noise that all move alike.
std::vector<twin::Inputs> movingFrames(int count, const glm::vec2& motionPx) {
  std::vector<twin::Inputs> frames;
  for (int frame = 0; frame < count; ++frame) {
    frames.push_back(test::mottledFrame(24, 16, frame));
    test::setMotion(frames.back(), motionPx);
  }
  return frames;
}

Settings constantAlpha(float alpha) {
  Settings settings = test::plainSettings();
  settings.weight.alpha = alpha;
  return settings;
}

constexpr LineageOptions kWhole{kLineageFrames, 0.0, 0.0}; // nothing is left out

} // namespace

TEST(Lineage, OfARunningMeanWeighsAllFramesAlike) {
  RuledSource source(
      [](int frame, const glm::ivec2& pixel) { return stillStep(frame, pixel, 1.0 / (frame + 1)); });
  const Lineage lineage = lineageOf(source, 7, {3, 2});
  ASSERT_EQ(lineage.frames.size(), 8u);
  for (const LineageFrame& entry : lineage.frames) {
    EXPECT_NEAR(entry.weight, 0.125, 1e-15);
    EXPECT_EQ(entry.place, glm::dvec2(3.5, 2.5));
    EXPECT_EQ(entry.spreadPx, 0.0);
    EXPECT_EQ(entry.pixels, 1);
  }
  EXPECT_NEAR(lineage.effectiveFrames, 8.0, 1e-12);
  EXPECT_NEAR(lineage.effectiveSamples, 8.0, 1e-12);
  EXPECT_NEAR(lineage.variance, 0.125, 1e-15);
}

TEST(Lineage, OfAConstantAlphaDecaysAndLeavesWhatIsOlder) {
  RuledSource source([](int frame, const glm::ivec2& pixel) { return stillStep(frame, pixel, 0.1); });
  const Lineage lineage = lineageOf(source, 100, {0, 0}, {.frames = 20});
  ASSERT_EQ(lineage.frames.size(), 20u);
  for (std::size_t age = 0; age < 20; ++age) {
    EXPECT_EQ(lineage.frames[age].frame, 100 - static_cast<int>(age));
    EXPECT_NEAR(lineage.frames[age].weight, 0.1 * std::pow(0.9, static_cast<double>(age)), 1e-15);
  }
  EXPECT_NEAR(lineage.older, std::pow(0.9, 20.0), 1e-15);
  EXPECT_NEAR(lineage.rest.x, 0.5 * lineage.older, 1e-15);
  EXPECT_NEAR(wholeOf(lineage), 1.0, 1e-15);
  EXPECT_EQ(source.steps, 20);
}

TEST(Lineage, LeavesToRectificationItsShareOfHistory) {
  RuledSource source([](int frame, const glm::ivec2& pixel) {
    PixelStep step = stillStep(frame, pixel, 0.5);
    if (frame == 2) step.rectified = 0.25;
    step.resolved = glm::dvec3(1.0); // of ½ · ½ + ½ · 0.75 · ½ and what rectification put there
    return step;
  });
  const Lineage lineage = lineageOf(source, 2, {0, 0});
  ASSERT_EQ(lineage.frames.size(), 3u);
  EXPECT_EQ(lineage.frames[0].weight, 0.5);
  EXPECT_EQ(lineage.frames[0].rectified, 0.125);
  EXPECT_EQ(lineage.frames[1].weight, 0.1875);
  EXPECT_EQ(lineage.frames[2].weight, 0.1875);
  EXPECT_EQ(lineage.rectified, 0.125);
  EXPECT_EQ(wholeOf(lineage), 1.0);
  EXPECT_EQ(lineage.frames[0].own, glm::dvec3(1.0 - 0.25 - 0.375 * 0.5));
}

TEST(Lineage, SaysTheLumaOfChannelsThatAreMixedUnalike) {
  RuledSource source([](int frame, const glm::ivec2& pixel) {
    PixelStep step = stillStep(frame, pixel, 0.0);
    if (frame > 0) step.alpha = glm::dvec3(1.0, 0.5, 0.0);
    return step;
  });
  const Lineage lineage = lineageOf(source, 1, {0, 0});
  EXPECT_EQ(lineage.frames[0].channels, glm::dvec3(1.0, 0.5, 0.0));
  EXPECT_NEAR(lineage.frames[0].weight, 0.2126 + 0.5 * 0.7152, 1e-15);
  EXPECT_EQ(lineage.frames[1].channels, glm::dvec3(0.0, 0.5, 1.0));
  EXPECT_NEAR(lineage.frames[1].weight, 0.5 * 0.7152 + 0.0722, 1e-15);
}

TEST(Lineage, NamesWhatItDoesNotFollow) {
  RuledSource source([](int frame, const glm::ivec2& pixel) {
    PixelStep step = stillStep(frame, pixel, 0.5);
    if (frame > 0) step.history = {{pixel, 0.75, glm::dvec3(0.5)}, {{9, 9}, 0.125, glm::dvec3(0.5)}};
    return step; // an eighth of what it reads is nothing
  });
  LineageOptions options;
  options.minWeight = 0.07;
  const Lineage lineage = lineageOf(source, 1, {0, 0}, options);
  EXPECT_EQ(lineage.blank, 0.0625);
  EXPECT_EQ(lineage.pruned, 0.0625);
  EXPECT_EQ(lineage.weight, 0.875);
  EXPECT_EQ(lineage.rest, glm::dvec3(0.03125));
  EXPECT_EQ(wholeOf(lineage), 1.0);
}

// Half a pixel a frame: bilinear interpolation halves between two texels, and k frames between k + 1.
TEST(Lineage, OfAMovingPictureReadByBilinearTapsIsBinomial) {
  LineageShot shot(movingFrames(6, {0.5f, 0.0f}), constantAlpha(0.25f));
  const Lineage lineage = lineageOf(shot, 5, {12, 8}, kWhole);
  ASSERT_EQ(lineage.frames.size(), 6u);
  double kept = 1.0, binomial = 1.0;
  for (int age = 0; age < 6; ++age) {
    const double alpha = age == 5 ? 1.0 : 0.25;
    const LineageFrame& entry = lineage.frames[static_cast<std::size_t>(age)];
    EXPECT_NEAR(entry.weight, alpha * kept, 1e-15);
    EXPECT_NEAR(entry.place.x, 12.5 - 0.5 * age, 1e-12);
    EXPECT_NEAR(entry.place.y, 8.5, 1e-12);
    EXPECT_NEAR(entry.spreadPx, 0.5 * std::sqrt(age), 1e-12); // f(1 − f) = ¼ a frame
    EXPECT_EQ(entry.pixels, age + 1);
    binomial = 1.0;
    for (int i = 0; i <= age; ++i) {
      EXPECT_NEAR(weightOf(lineage, 5 - age, {12 - i, 8}), alpha * kept * binomial / std::exp2(age), 1e-15);
      binomial = binomial * (age - i) / (i + 1);
    }
    kept *= 0.75;
  }
  for (const FootprintSample& sample : lineage.samples) // not jittered: on today's grid, and between it
    EXPECT_NEAR(sample.offset.x, sample.texel.x - 12 + 0.5 * (5 - sample.frame), 1e-6) << sample.frame;
  EXPECT_NEAR(lineage.effectiveFrames,
              1.0 / (lineage.frames[0].weight * lineage.frames[0].weight + std::pow(0.1875, 2) +
                     std::pow(0.140625, 2) + std::pow(0.10546875, 2) + std::pow(0.0791015625, 2) +
                     std::pow(0.2373046875, 2)),
              1e-12);
}

// What was sampled half as large lies twice as far away today.
TEST(Lineage, PlacesOldSamplesInTodaysPixels) {
  std::vector<twin::Inputs> frames(3, test::mottledFrame(12, 10, 0)); // 1 m away
  for (twin::Inputs& frame : frames) {
    for (float& depth : frame.previousDepth.pixels) depth = 2.0f;
    frame.jitterPx = {0.25f, -0.125f};
  }
  LineageShot shot(std::move(frames), constantAlpha(0.25f));
  const Lineage lineage = lineageOf(shot, 2, {6, 5});
  ASSERT_EQ(lineage.samples.size(), 3u);
  for (const FootprintSample& sample : lineage.samples) {
    const double scale = std::exp2(2 - sample.frame);
    EXPECT_NEAR(sample.offset.x, -0.25 * scale, 1e-6) << sample.frame;
    EXPECT_NEAR(sample.offset.y, 0.125 * scale, 1e-6) << sample.frame;
  }
  const double squares = 0.25 + 0.1875 * 4.0 + 0.5625 * 16.0;
  EXPECT_NEAR(lineage.radiusPx, std::sqrt(squares * (0.0625 + 0.015625)), 1e-6);
}

// Weights are the response to what the samples change by, of every filter that is a sum.
TEST(Lineage, IsTheResponseToAnImpulseInAnOlderFrame) {
  const LineageShot::Change impulse = [](const glm::ivec2& texel) {
    return texel == glm::ivec2(11, 8) ? glm::vec3(0.25f) : glm::vec3(0.0f);
  };
  const LineageShot::Change everywhere = [](const glm::ivec2& texel) {
    return glm::vec3(0.05f * static_cast<float>((texel.x * 29 + texel.y * 17) % 8));
  };
  for (std::size_t filter = 0; filter < parameter("history.filter").choices.size(); ++filter) {
    Settings settings = constantAlpha(0.25f);
    settings.history.filter = static_cast<HistoryFilter>(filter);
    settings.current.filter = CurrentFilter::Gaussian;
    settings.current.variance = 0.4f;
    LineageShot shot(movingFrames(5, {0.3f, -0.2f}), settings);
    const Lineage lineage = lineageOf(shot, 4, {12, 8}, kWhole);
    EXPECT_NEAR(wholeOf(lineage), 1.0, 1e-12);
    const glm::vec3 resolved = shot.resolved({12, 8});
    for (const int frame : {4, 3, 1})
      for (const LineageShot::Change& change : {impulse, everywhere}) {
        const glm::dvec3 response = glm::dvec3(shot.resolvedWith(frame, change, {12, 8}) - resolved);
        const glm::dvec3 predicted = test::predictedResponse(lineage, frame, change);
        EXPECT_GT(std::fabs(predicted.x), 1e-3) << "the impulse is seen";
        // Some forty floats of about ½, each rounded to 3·10⁻⁸.
        for (int channel = 0; channel < 3; ++channel)
          EXPECT_NEAR(response[channel], predicted[channel], 1e-6) << filter << ", frame " << frame;
      }
  }
}

// Red leaves the box, green and blue do not: t does not change with green, whose response is 1 − t.
TEST(Lineage, IsTheResponseThroughAClipWhoseShareStays) {
  std::vector<twin::Inputs> frames{test::constantInputs(8, 6, {2.0f, 0.5f, 0.5f}),
                                   test::constantInputs(8, 6, glm::vec3(0.5f))};
  for (int k = 0; k < 48; ++k) // a box from 0 to 1 around 0.5
    if ((k % 8 + k / 8) % 2 == 1)
      test::setColor(frames[1].color, k % 8, k / 8, glm::vec3(k % 2 == 0 ? 0.0f : 1.0f));
  Settings settings = constantAlpha(0.25f);
  settings.rectify.method = RectifyMethod::ClipToFiltered;
  LineageShot shot(std::move(frames), settings);
  const Lineage lineage = lineageOf(shot, 1, {4, 2});
  const double t = 1.0 / 1.5; // from 2 to 1 on the way to 0.5
  EXPECT_NEAR(lineage.rectified, 0.75 * t, 1e-6);
  EXPECT_NEAR(lineage.frames[1].weight, 0.75 * (1.0 - t), 1e-6);
  EXPECT_NEAR(wholeOf(lineage), 1.0, 1e-12);
  const LineageShot::Change greener = [](const glm::ivec2&) { return glm::vec3(0.0f, 0.125f, 0.0f); };
  const glm::vec3 response = shot.resolvedWith(0, greener, {4, 2}) - shot.resolved({4, 2});
  EXPECT_NEAR(response.x, 0.0f, 1e-6f);
  EXPECT_NEAR(response.y, 0.125f * static_cast<float>(lineage.frames[1].weight), 1e-6f);
}

TEST(Lineage, EndsWhereHistoryIsRejected) {
  Settings settings = constantAlpha(0.25f);
  settings.validate.offScreen = OffScreen::Reject;
  LineageShot shot(movingFrames(5, {6.0f, 0.0f}), settings);
  const Lineage lineage = lineageOf(shot, 4, {13, 8}); // 7.5, 1.5, and then it was not to be seen
  ASSERT_EQ(lineage.frames.size(), 3u);
  EXPECT_NEAR(lineage.frames[2].weight, 0.5625, 1e-12);
  EXPECT_NEAR(lineage.weight, 1.0, 1e-12);
  EXPECT_NEAR(lineage.effectiveFrames, 1.0 / (0.0625 + 0.1875 * 0.1875 + 0.5625 * 0.5625), 1e-12);
}

TEST(Lineage, ColorsOfItsPartsSumUpToThePixel) {
  for (const bool isRectified : {false, true}) {
    Settings settings; // balanced
    if (!isRectified) settings = constantAlpha(0.125f);
    LineageShot shot(movingFrames(6, {0.37f, 0.21f}), settings);
    const Lineage lineage = lineageOf(shot, 5, {12, 8}, {.frames = 4});
    glm::dvec3 sum = lineage.rest, own(0.0);
    for (const LineageFrame& entry : lineage.frames) {
      sum += entry.color + entry.own;
      own += entry.own;
    }
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(sum[channel], shot.resolved({12, 8})[channel], 1e-12);
      // Without rectification the resolve adds nothing but what floats round.
      EXPECT_NEAR(own[channel], 0.0, isRectified ? 0.2 : 1e-6);
    }
    EXPECT_GT(lineage.older, 0.01);
  }
}
