// Derivatives by the twin: the values are the float twin's bit for bit, slopes those of the formulas, of
// steps of the twin, and of steps of the GLSL itself over whole frames.
#include "core/probe/Sensitivity.h"
#include "core/base/Light.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/twin/Dual.h"
#include "tests/support/frames/ResolveTest.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

using namespace taa;
using twin::Dual;
using SensitivityTest = taa::test::ResolveTest;

namespace {

const std::vector<glm::ivec2> kPixels{{0, 0}, {1, 5}, {20, 11}, {33, 20}, {47, 26}};

test::FrameShape smallShape(const Settings& settings) {
  return test::shapeFor(settings, {48, 27, Precision::Full, Precision::Full, {}});
}

/// Nothing but a share α of this frame's sample and the rest of history, read at rest.
Settings plainMix(float alpha) {
  Settings settings = test::bareSettings();
  settings.weight.alpha = alpha;
  settings.weight.minimum = 0.0f;
  return settings;
}

const Sensitivity* find(const std::vector<Sensitivity>& all, SensitivityTo to) {
  const auto found = std::ranges::find(all, to, &Sensitivity::to);
  return found == all.end() ? nullptr : &*found;
}

constexpr double kStep = 0.01;       ///< of the step that one would try
constexpr double kAgreement = 0.02;  ///< relative: floats' steps have no more digits
constexpr double kRoundedOff = 5e-6; ///< of a color: powers of a curve are as exact

/// A number that the resolve itself reads.
bool isOfResolve(const Parameter& row, const Settings& settings) {
  return row.kind == ParameterKind::Number && row.effect == Effect::Uniform && isRelevant(row, settings) &&
         row.path != "weight.referenceRate"; // taken in eighths: it has no slope
}

struct Agreement {
  int compared = 0, differ = 0, sloping = 0;
  std::string first; ///< that differs
};

} // namespace

TEST_F(SensitivityTest, HasTheValuesOfTheFloatTwinBitForBit) {
  for (const Preset& preset : wholePresets())
    for (const bool wild : {false, true}) {
      const twin::Inputs frame = test::randomFrame(smallShape(preset.settings), 7, wild);
      for (const glm::ivec2& pixel : kPixels) {
        const twin::PixelRecord expected = twin::resolvePixel(frame, preset.settings, pixel.x, pixel.y);
        const auto record = twin::resolvePixelIn<Dual>(frame, preset.settings, pixel).record;
        for (const Intermediate& row : kIntermediates)
          for (int channel = 0; channel < row.channels; ++channel)
            EXPECT_EQ(std::bit_cast<std::uint32_t>(twin::at(record, row.id)[channel].value),
                      std::bit_cast<std::uint32_t>(twin::at(expected, row.id)[channel]))
                << preset.id << ' ' << row.name << " at " << pixel.x << ' ' << pixel.y;
      }
    }
}

TEST_F(SensitivityTest, IsTheShareOfEachInAPlainMix) {
  const Settings settings = plainMix(0.25f);
  const twin::Inputs frame = rested(smallShape(settings), settings, 3);
  const glm::ivec2 pixel(20, 11);
  const std::vector<Sensitivity> all = sensitivitiesOf(frame, settings, pixel);
  const Sensitivity* sample = find(all, SensitivityTo::Sample);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->offset, glm::ivec2(0));
  EXPECT_EQ(sample->slope, glm::dvec3(0.25));
  const Sensitivity* history = find(all, SensitivityTo::History);
  ASSERT_TRUE(history);
  EXPECT_EQ(history->offset, glm::ivec2(0));
  EXPECT_EQ(history->slope, glm::dvec3(0.75));
  const auto alpha = std::ranges::find(all, std::string_view("weight.alpha"), &Sensitivity::path);
  ASSERT_NE(alpha, all.end());
  const glm::dvec3 difference = glm::dvec3(glm::vec3(frame.color.texel(20, 11))) -
                                glm::dvec3(glm::vec3(frame.historyColor.texel(20, 11)));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(alpha->slope[i], difference[i], 1e-6 * std::fabs(difference[i]));
  EXPECT_NEAR(alpha->step(), 0.025, 1e-9);
  EXPECT_EQ(std::ranges::count(all, SensitivityTo::Parameter, &Sensitivity::to), 1)
      << "no other number counts";
}

TEST_F(SensitivityTest, OfHistoryBetweenTexelsIsThatOfTheBilinearTap) {
  const Settings settings = plainMix(0.5f);
  twin::Inputs frame = rested(smallShape(settings), settings, 3);
  for (int y = 0; y < 27; ++y)
    for (int x = 0; x < 48; ++x) frame.motion.at(x, y)[0] = 0.25f; // from the left
  std::vector<double> shares;
  for (const Sensitivity& each : sensitivitiesOf(frame, settings, {20, 11}))
    if (each.to == SensitivityTo::History) shares.push_back(each.slope.x);
  EXPECT_EQ(shares, (std::vector<double>{0.375, 0.125}));
}

TEST_F(SensitivityTest, OfMixedRowsIsThatOfStepsOfTheFloatTwin) {
  // Steps of a float twin are rounded: they answer to three digits, where no corner lies between them.
  int compared = 0;
  for (const Preset& preset : wholePresets()) {
    Settings settings = preset.settings;
    settings.history.precision = Precision::Full;
    settings.history.dither = Switch::Off;
    const twin::Inputs frame = rested(smallShape(settings), settings, 11);
    for (const glm::ivec2& pixel : kPixels)
      for (const Sensitivity& each : sensitivitiesOf(frame, settings, pixel)) {
        const auto resolvedWith = [&](double step) {
          twin::Inputs moved = frame;
          Settings changed = settings;
          if (each.to == SensitivityTo::Parameter)
            parameter(each.path).set(changed, each.value + step);
          else {
            twin::Texels& plane = each.to == SensitivityTo::Sample ? moved.color : moved.historyColor;
            for (int i = 0; i < 3; ++i) plane.at(each.texel.x, each.texel.y)[i] += static_cast<float>(step);
          }
          const auto record = twin::resolvePixel(moved, changed, pixel.x, pixel.y);
          return glm::dvec3(glm::vec3(twin::at(record, IntermediateId::resolved)));
        };
        const double step = 0.01 * (each.to == SensitivityTo::Parameter ? each.step() : 1.0);
        const glm::dvec3 here = resolvedWith(0.0);
        const glm::dvec3 up = (resolvedWith(step) - here) / step, down = (here - resolvedWith(-step)) / step;
        for (int i = 0; i < 3; ++i) {
          const double scale = std::max(std::fabs(each.slope[i]), 1e-4 * std::fabs(here[i]) / step);
          if (std::fabs(up[i] - down[i]) > 0.02 * scale) continue; // bent, or a corner between
          ++compared;
          EXPECT_NEAR(0.5 * (up[i] + down[i]), each.slope[i], 0.02 * scale)
              << preset.id << ' ' << sensitivityText(each) << " at " << pixel.x << ' ' << pixel.y;
        }
      }
  }
  EXPECT_GT(compared, 1500);
}

TEST_F(SensitivityTest, MapsANumberOverAllPixels) {
  const Settings settings = plainMix(0.25f);
  const twin::Inputs frame = rested(smallShape(settings), settings, 3);
  const SensitivityMap map = sensitivityMap("weight.alpha", frame, settings);
  ASSERT_EQ(map.number.step(), 0.025);
  double largest = 0.0;
  for (int y = 0; y < map.change.height; ++y)
    for (int x = 0; x < map.change.width; ++x) {
      // The resolved color is history + α (sample − history).
      const glm::dvec3 slope = glm::dvec3(glm::vec3(frame.color.texel(x, y))) -
                               glm::dvec3(glm::vec3(frame.historyColor.texel(x, y)));
      const glm::vec3 change(map.change.texel(x, y));
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(change[i], 0.025 * slope[i], 1e-6 * (1.0 + std::fabs(slope[i]))) << x << ' ' << y;
      largest = std::max(largest, std::fabs(luminance(0.025 * slope)));
    }
  EXPECT_NEAR(map.largest, largest, 1e-5 * largest);
  EXPECT_GT(map.share, 0.99);
}

TEST_F(SensitivityTest, AgreesWithStepsOfTheShaderOnWholeFrames) {
  Agreement all;
  for (const Preset& preset : wholePresets()) {
    Settings settings = preset.settings;
    settings.history.precision = Precision::Full;
    settings.history.dither = Switch::Off;
    const test::FrameShape shape = test::shapeFor(settings, {24, 14, Precision::Full, Precision::Full, {}});
    const twin::Inputs frame = rested(shape, settings, 5);
    const Image here = resolve(frame, shape, settings).color.download();
    for (const Parameter& row : parameters()) {
      if (!isOfResolve(row, settings)) continue;
      const double value = row.get(settings);
      const double step =
          kStep * Sensitivity{.to = SensitivityTo::Parameter, .path = row.path, .value = value}.step();
      Settings more = settings, less = settings;
      row.set(more, value + step);
      row.set(less, value - step);
      const Image up = resolve(frame, shape, more).color.download();
      const Image down = resolve(frame, shape, less).color.download();
      for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x) {
          const glm::dvec3 slope = sensitivityTo(row.path, frame, settings, {x, y});
          for (int i = 0; i < 3; ++i) {
            const double middle = here.texel(x, y)[i];
            const double rise = (up.texel(x, y)[i] - middle) / step,
                         fall = (middle - down.texel(x, y)[i]) / step;
            const double scale =
                std::max(std::fabs(slope[i]), kRoundedOff * std::fabs(middle) / (step * kAgreement));
            if (std::fabs(rise - fall) > kAgreement * scale) continue; // bent, or a corner between
            ++all.compared;
            all.sloping += slope[i] != 0.0;
            if (std::fabs(0.5 * (rise + fall) - slope[i]) <= kAgreement * scale) continue;
            if (all.differ++ == 0)
              all.first = preset.id + " " + std::string(row.path) + " at " + std::to_string(x) + " " +
                          std::to_string(y) + ": " + std::to_string(slope[i]) + ", by steps " +
                          std::to_string(rise) + " and " + std::to_string(fall);
          }
        }
    }
  }
  EXPECT_EQ(all.differ, 0) << "of " << all.compared << ", the first " << all.first;
  EXPECT_GT(all.compared, 100000);
  EXPECT_GT(all.sloping, 20000);
}
