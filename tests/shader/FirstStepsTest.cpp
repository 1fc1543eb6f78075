// The first steps of every source: no TAA at all, history without reprojection, and what the sources do with
// a sample or a resolved picture by their formulas alone.
#include "core/settings/Parameters.h"
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

using taa::Image;
using taa::IntermediateId;
using taa::Settings;
using taa::test::Exposed;
using taa::test::FrameShape;

namespace {

FrameShape fullFloats() {
  FrameShape shape;
  shape.history = taa::Precision::Full;
  return shape;
}

Settings withoutTaa(Settings settings) {
  settings.jitter.taa = taa::Switch::Off;
  return settings;
}

// Everything that could change what is shown of a frame.
Settings busySettings() {
  Settings settings;
  settings.history.precision = taa::Precision::Full;
  settings.current.sharpen = taa::CurrentSharpen::Laplacian;
  settings.blend.restart = taa::Restart::Blurred;
  settings.output.sharpen = taa::Sharpen::Unsharp;
  settings.output.dither = settings.output.motionBlur = taa::Switch::On;
  return settings;
}

Image colorsOf(const Image& image) {
  Image colors(image.width, image.height, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int channel = 0; channel < 3; ++channel) colors.at(x, y)[channel] = image.at(x, y)[channel];
  return colors;
}

Image filled(const FrameShape& shape, float value) {
  Image image(shape.width, shape.height, 1);
  for (float& pixel : image.pixels) pixel = value;
  return image;
}

} // namespace

class FirstStepsTest : public taa::test::ResolveTest {};

// Techniques: J0.
TEST_F(FirstStepsTest, WithoutTaaTheFrameIsShownAsItIsDrawn) {
  const FrameShape shape = fullFloats();
  for (const bool hasHistory : {true, false}) {
    taa::twin::Inputs frame = taa::test::stillFrame(shape, 80);
    frame.overlay = {};
    if (hasHistory) {
      frame.historyColor = taa::test::stillFrame(shape, 81).color;
      frame.historySurface = Image(shape.width, shape.height, 2);
      for (float& value : frame.historySurface.pixels) value = 5.0f;
    }
    const Exposed all = expose(frame, shape, withoutTaa(busySettings()));
    for (const IntermediateId id :
         {IntermediateId::currentFiltered, IntermediateId::resolved, IntermediateId::output})
      EXPECT_EQ(taa::test::difference(all.at(id), colorsOf(frame.color)), "")
          << taa::intermediate(id).name << (hasHistory ? " on history" : " at first");
    EXPECT_EQ(taa::test::difference(all.at(IntermediateId::alpha), filled(shape, 1.0f)), "");
    EXPECT_EQ(taa::test::difference(all.at(IntermediateId::historyLength), filled(shape, 1.0f)), "");
  }
}

// What TAA would begin with stays to be looked at: only what is shown is otherwise.
TEST_F(FirstStepsTest, WithoutTaaHistoryIsReadAndMeasuredAllTheSame) {
  const FrameShape shape = fullFloats();
  taa::twin::Inputs frame = taa::test::randomFrame(shape, 82, true);
  Settings settings;
  settings.history.precision = taa::Precision::Full;
  settings.neighborhood.includeFiltered = taa::Switch::Off;
  const Exposed on = expose(frame, shape, settings), off = expose(frame, shape, withoutTaa(settings));
  for (const IntermediateId id :
       {IntermediateId::historyRaw, IntermediateId::historyPosition, IntermediateId::boxMin,
        IntermediateId::boxMax, IntermediateId::depthMismatch, IntermediateId::rejectReason,
        IntermediateId::alphaBase, IntermediateId::alphaFloor})
    EXPECT_EQ(taa::test::difference(off.at(id), on.at(id)), "") << taa::intermediate(id).name;
  EXPECT_FALSE(taa::test::agree(off.at(IntermediateId::resolved), on.at(IntermediateId::resolved)));
}

// Frames that all move by 2 px: in place history is the pixel's own, reprojected it is that 2 px behind.
// Techniques: 5.8.
TEST_F(FirstStepsTest, HistoryInPlaceIsThatOfThePixel) {
  const FrameShape shape = fullFloats();
  taa::twin::Inputs frame = taa::test::stillFrame(shape, 83);
  frame.historyColor = taa::test::stillFrame(shape, 84).color;
  frame.historySurface = Image(shape.width, shape.height, 2);
  for (float& value : frame.historySurface.pixels) value = 5.0f;
  for (int y = 0; y < shape.height; ++y)
    for (int x = 0; x < shape.width; ++x) {
      frame.motion.at(x, y)[0] = 2.0f;
      frame.motion.at(x, y)[1] = 0.0f;
    }
  Settings settings = taa::test::bareSettings();
  const Image moved = expose(frame, shape, settings).at(IntermediateId::historyRaw);
  settings.reproject.method = taa::ReprojectMethod::InPlace;
  const Exposed inPlace = expose(frame, shape, settings);
  const Image own = colorsOf(frame.historyColor);
  EXPECT_EQ(taa::test::difference(inPlace.at(IntermediateId::historyRaw), own), "");
  EXPECT_EQ(taa::test::difference(inPlace.at(IntermediateId::speed), filled(shape, 2.0f)), "");
  for (int y = 0; y < shape.height; ++y)
    for (int x = 2; x < shape.width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_EQ(moved.at(x, y)[channel], own.at(x - 2, y)[channel]) << x << ", " << y;
}

// The kernel of Mitchell and Netravali 1988 with B = C = 1/3, by its two pieces: (16 − 6B…)/18 at 0, 1/18 at
// 1, 0 at 2.
// Techniques: 18.4.
TEST_F(FirstStepsTest, MitchellAfterTaaHasTheKernelsWeightsAtPixelCenters) {
  const auto kernel = [](double x) {
    const double b = 1.0 / 3.0, c = 1.0 / 3.0;
    if (x < 1.0)
      return ((12.0 - 9.0 * b - 6.0 * c) * x * x * x + (12.0 * b + 6.0 * c - 18.0) * x * x + 6.0 - 2.0 * b) /
             6.0;
    return ((-b - 6.0 * c) * x * x * x + (6.0 * b + 30.0 * c) * x * x + (-12.0 * b - 48.0 * c) * x + 8.0 * b +
            24.0 * c) /
           6.0;
  };
  const FrameShape shape = fullFloats();
  taa::twin::Inputs frame = taa::test::stillFrame(shape, 85);
  frame.overlay = {};
  Settings settings = taa::test::bareSettings();
  settings.weight.alpha = 1.0f; // resolved is the frame
  settings.output.sharpen = taa::Sharpen::Mitchell;
  const Image shown = expose(frame, shape, settings).at(IntermediateId::output);
  for (int y = 1; y + 1 < shape.height; ++y)
    for (int x = 1; x + 1 < shape.width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        double sum = 0.0, largest = 0.0;
        for (int k = 0; k < 9; ++k) {
          const double sample = static_cast<double>(frame.color.at(x + k % 3 - 1, y + k / 3 - 1)[channel]);
          sum += kernel(std::abs(k % 3 - 1)) * kernel(std::abs(k / 3 - 1)) * sample;
          largest = std::max(largest, sample);
        }
        ASSERT_NEAR(static_cast<double>(shown.at(x, y)[channel]), sum, 1e-6 * largest); // a few roundings
      }
}

// Source 004: at rest every sample counts alike, in motion the one near the center counts more.
// Techniques: 7.7.
TEST_F(FirstStepsTest, InMotionTheSampleNearTheCenterIsPreferred) {
  const FrameShape shape = fullFloats();
  taa::twin::Inputs frame = taa::test::stillFrame(shape, 86);
  frame.historyColor = frame.color;
  frame.historySurface = Image(shape.width, shape.height, 2);
  for (float& value : frame.historySurface.pixels) value = 5.0f;
  Settings settings = taa::test::bareSettings();
  settings.weight.alpha = 0.25f;
  settings.weight.minimum = 0.0f;
  settings.weight.sampleDistance = taa::SampleDistance::GaussianMoving;
  const auto alphaAt = [&](float motion, glm::vec2 jitterPx) {
    for (int y = 0; y < shape.height; ++y)
      for (int x = 0; x < shape.width; ++x)
        frame.motion.at(x, y)[0] = motion, frame.motion.at(x, y)[1] = 0.0f;
    frame.jitterPx = jitterPx;
    return static_cast<double>(expose(frame, shape, settings).at(IntermediateId::alpha).at(4, 4)[0]);
  };
  const glm::vec2 near(0.0f), far(0.5f, -0.5f);
  EXPECT_EQ(alphaAt(0.0f, near), 0.25);
  EXPECT_EQ(alphaAt(0.0f, far), 0.25) << "at rest";
  EXPECT_EQ(alphaAt(3.0f, near), 0.25) << "at the center";
  EXPECT_NEAR(alphaAt(3.0f, far), 0.25 * std::exp(-0.5 / 0.44), 1e-7);
  const double half = 0.5; // smoothstep(0, 1, ½)
  EXPECT_NEAR(alphaAt(0.5f, far), 0.25 * (1.0 - half + half * std::exp(-0.5 / 0.44)), 1e-7);
}
