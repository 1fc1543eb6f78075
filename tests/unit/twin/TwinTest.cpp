// The whole twin over every option: constants stay, garbage goes (invariants 60, 61).
#include "core/taa/twin/Twin.h"

#include "tests/support/frames/TwinInputs.h"
#include "tests/support/frames/Variants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace taa::twin {
namespace {

/// Random combinations of all options, besides the default and nothing.
std::vector<Settings> combinations(std::uint32_t count) {
  std::vector<Settings> all{Settings{}, test::plainSettings()};
  for (std::uint32_t seed = 1; all.size() < count; ++seed) all.push_back(test::randomSettings(seed));
  return all;
}

TEST(Twin, AConstantImageStaysExactlyConstantThroughEveryOption) {
  for (Settings settings : combinations(120)) {
    // As printed this one loses light.
    if (settings.history.filter == HistoryFilter::CatmullRom5AsPrinted)
      settings.history.filter = HistoryFilter::CatmullRom5;
    // Beyond a black border nothing is constant.
    settings.history.border = HistoryBorder::Edge;
    // As printed this one makes what is flat s times as bright.
    if (settings.current.sharpen == CurrentSharpen::LaplacianAsPrinted) settings.current.sharpenAmount = 1.0f;
    // 8 and 10 bits cannot hold the levels.
    if (settings.history.precision != Precision::Half) settings.history.precision = Precision::Full;
    for (const float level : {0.0f, 1.0f / 8192.0f, 1.0f, 1000.0f, 65504.0f}) { // all are halves
      Inputs inputs = test::constantInputs(4, 3, glm::vec3(level, 0.5f * level, level));
      for (int frame = 0; frame < 4; ++frame) {
        inputs.jitterPx = {0.3f - 0.2f * static_cast<float>(frame), 0.1f};
        for (int k = 0; k < 12; ++k) inputs.motion.at(k % 4, k / 4)[0] = 0.3f * static_cast<float>(frame);
        const PixelRecord record = test::advance(inputs, settings, 1, 1);
        ASSERT_EQ(at(record, IntermediateId::resolved), glm::vec4(level, 0.5f * level, level, 0.0f));
      }
    }
  }
}

// Techniques: 14.6.
TEST(Twin, GarbageIsGoneWithinOneFrameAndNeverLeavesTheResolve) {
  const std::vector<float> garbage{
      std::nanf(""), INFINITY, -INFINITY, -3.0f, 65504.0f, 1e30f, std::numeric_limits<float>::denorm_min()};
  std::mt19937 random(4);
  for (const Settings& settings : combinations(60)) {
    Inputs clean = test::constantInputs(4, 4, glm::vec3(0.5f));
    Inputs dirty = clean;
    for (float& value : dirty.color.pixels) {
      if (random() % 2 == 0) value = garbage[random() % garbage.size()];
    }
    const auto expectFinite = [](const Inputs& inputs) {
      for (const float value : inputs.historyColor.pixels) ASSERT_TRUE(value >= 0.0f && value <= 65504.0f);
      for (const float value : inputs.historySurface.pixels)
        ASSERT_TRUE(std::isfinite(value) && value > 0.0f);
    };
    test::advance(clean, settings, 0, 0);
    dirty.historyColor = clean.historyColor;
    dirty.historySurface = clean.historySurface;
    test::advance(dirty, settings, 0, 0);
    expectFinite(dirty);
    clean.historyColor = dirty.historyColor;
    clean.historySurface = dirty.historySurface;
    test::advance(clean, settings, 0, 0);
    expectFinite(clean);
  }
}

TEST(Twin, PoisonedHistoryIsNotReadWhereItIsRejected) {
  Inputs inputs = test::constantInputs(4, 4, glm::vec3(0.25f));
  test::setHistory(inputs, glm::vec3(std::nanf("")), std::nanf(""));
  for (float& depth : inputs.previousDepth.pixels) depth = 9.0f; // nothing of it fits
  for (int k = 0; k < 16; ++k) {
    const PixelRecord record = resolvePixel(inputs, Settings{}, k % 4, k / 4);
    EXPECT_EQ(at(record, IntermediateId::resolved), glm::vec4(0.25f, 0.25f, 0.25f, 0.0f));
    EXPECT_EQ(at(record, IntermediateId::historyLength).x, 1.0f);
  }
}

TEST(Twin, RecordsTheInputsAsTheyAre) {
  Inputs inputs = test::constantInputs(2, 2, {-1.0f, 70000.0f, 0.5f});
  inputs.objectId.at(1, 0)[0] = 7.0f;
  inputs.motion.at(1, 0)[1] = -2.5f;
  const PixelRecord record = resolvePixel(inputs, Settings{}, 1, 0);
  EXPECT_EQ(at(record, IntermediateId::color), glm::vec4(-1.0f, 70000.0f, 0.5f, 0.0f));
  EXPECT_EQ(at(record, IntermediateId::depthView).x, 1.0f);
  EXPECT_EQ(at(record, IntermediateId::objectId).x, 7.0f);
  EXPECT_EQ(at(record, IntermediateId::motion).y, -2.5f);
  EXPECT_EQ(at(record, IntermediateId::resolved),
            glm::vec4(0.0f, 0.0f, 0.5f, 0.0f)); // bad channels are black
}

} // namespace
} // namespace taa::twin
