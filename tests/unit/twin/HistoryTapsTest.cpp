// Texels that a filter of history adds up, against the filter itself.
#include "core/taa/twin/HistoryTaps.h"

#include "core/settings/Parameters.h"
#include "core/taa/twin/Stages.h"
#include "tests/support/frames/TwinInputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace taa::twin {
namespace {

constexpr int kWide = 9, kHigh = 7;

Inputs patterned() {
  Inputs inputs = test::constantInputs(kWide, kHigh, glm::vec3(0.0f));
  test::setHistory(inputs, glm::vec3(0.0f), 4.0f);
  for (int k = 0; k < kWide * kHigh; ++k)
    test::setColor(inputs.historyColor, k % kWide, k / kWide,
                   glm::vec3(100.0f + static_cast<float>((k * 37) % 61)));
  return inputs;
}

float summed(const Inputs& inputs, const HistoryTexels& texels) {
  float sum = 0.0f;
  for (const HistoryTexels::Texel& texel : texels.all())
    sum += texel.weight * inputs.historyColor.texel(texel.at.x, texel.at.y).x;
  return sum;
}

TEST(HistoryTaps, TexelsAddUpToWhatEveryFilterReads) {
  const Inputs inputs = patterned();
  const std::size_t filters = parameter("history.filter").choices.size();
  for (std::size_t filter = 0; filter < filters; ++filter)
    for (const HistoryBorder border : {HistoryBorder::Edge, HistoryBorder::Black}) {
      HistorySettings settings{static_cast<HistoryFilter>(filter), Switch::Off, Precision::Full};
      settings.border = border;
      for (int k = 0; k < 300; ++k) {
        const glm::vec2 q(static_cast<float>((k * 7) % 180) / 16.0f - 1.0f,
                          static_cast<float>((k * 13) % 150) / 16.0f - 1.0f);
        const float read = sampleHistory(inputs, settings, q, {0, 0}).color.x; // never below 0
        // Of 16 products of values up to 160, each rounded.
        EXPECT_NEAR(std::max(0.0f, summed(inputs, historyTexels(settings, q, {kWide, kHigh}))), read, 1e-3f)
            << filter << " at " << q.x << ", " << q.y;
      }
    }
}

TEST(HistoryTaps, AtTheCenterOfAPixelIsThatPixelOfAFilterThatPassesThroughIt) {
  for (const HistoryFilter filter :
       {HistoryFilter::Point, HistoryFilter::Bilinear, HistoryFilter::CatmullRom5, HistoryFilter::CatmullRom9,
        HistoryFilter::CatmullRom16}) {
    const HistoryTexels texels =
        historyTexels({filter, Switch::Off, Precision::Full}, {4.5f, 3.5f}, {kWide, kHigh});
    ASSERT_EQ(texels.count, 1u) << static_cast<int>(filter);
    EXPECT_EQ(texels.each[0].at, glm::ivec2(4, 3));
    EXPECT_EQ(texels.each[0].weight, 1.0f);
  }
}

TEST(HistoryTaps, AreBilinearAtAnEdgeOfDepth) {
  const HistorySettings settings{HistoryFilter::CatmullRom16, Switch::Off, Precision::Full};
  const HistoryTexels texels = historyTexels(settings, {4.75f, 3.5f}, {kWide, kHigh}, true);
  ASSERT_EQ(texels.count, 2u);
  EXPECT_EQ(texels.each[0].weight, 0.75f);
  EXPECT_EQ(texels.each[1].at, glm::ivec2(5, 3));
  EXPECT_EQ(texels.each[1].weight, 0.25f);
}

} // namespace
} // namespace taa::twin
