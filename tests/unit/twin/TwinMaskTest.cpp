// What the masks of special content do (manual 10.10, 13.18, 21.4, 21.5).
#include "core/taa/twin/Stages.h"
#include "tests/support/frames/TwinInputs.h"

#include <gtest/gtest.h>

namespace taa {
namespace {

using twin::at;

/// Gray 0.5 with a checker around it, history of another gray, one mask everywhere.
twin::Inputs masked(float reactive, float responsive) {
  twin::Inputs inputs = test::constantInputs(3, 3, glm::vec3(0.5f));
  test::setGrays(inputs.color, {0.4f, 0.6f, 0.4f, 0.6f, 0.5f, 0.6f, 0.4f, 0.6f, 0.4f});
  test::setHistory(inputs, glm::vec3(0.9f), 8.0f);
  inputs.mask = Image(3, 3, 2);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      inputs.mask.at(x, y)[0] = reactive;
      inputs.mask.at(x, y)[1] = responsive;
    }
  return inputs;
}

float alphaOf(const twin::Inputs& inputs, const Settings& settings) {
  return at(twin::resolvePixel(inputs, settings, 1, 1), IntermediateId::alpha).x;
}

// Techniques: 13.18, 21.4, 21.5.
TEST(TwinMask, AsksForAtLeastAsMuchOfTheCurrentFrame) {
  Settings settings = test::plainSettings();
  EXPECT_EQ(alphaOf(masked(0.75f, 0.5f), settings), 0.1f);
  settings.weight.mask = MaskAlpha::Responsive;
  settings.weight.maskAlpha = 0.25f;
  EXPECT_EQ(alphaOf(masked(0.0f, 1.0f), settings), 0.25f);
  EXPECT_EQ(alphaOf(masked(1.0f, 0.0f), settings), 0.25f);
  EXPECT_EQ(alphaOf(masked(0.5f, 0.75f), settings), 0.1875f);
  EXPECT_EQ(alphaOf(masked(0.0f, 0.25f), settings), 0.1f) << "never less";
  settings.weight.mask = MaskAlpha::Reactive;
  EXPECT_EQ(alphaOf(masked(0.75f, 1.0f), settings), 0.75f);
  EXPECT_EQ(alphaOf(masked(0.0f, 1.0f), settings), 0.1f);
  settings.weight.mask = MaskAlpha::Exclude;
  EXPECT_EQ(alphaOf(masked(1.0f, 0.0f), settings), 0.1f);
  EXPECT_EQ(alphaOf(masked(0.0f, 1.0f / 255.0f), settings), 1.0f);
}

// Techniques: 21.4.
TEST(TwinMask, ShowsTheCurrentFrameAloneWhereExcluded) {
  Settings settings = test::plainSettings();
  settings.weight.mask = MaskAlpha::Exclude;
  const twin::PixelRecord record = twin::resolvePixel(masked(0.0f, 1.0f), settings, 1, 1);
  EXPECT_EQ(at(record, IntermediateId::resolved), at(record, IntermediateId::currentFiltered));
  EXPECT_EQ(at(record, IntermediateId::historyLength).x, 1.0f);
}

// γ·(1 + 1.5m) ≤ 2.5γ and α/(1 + 0.5m) ≥ α/1.5.
// Techniques: 10.10.
TEST(TwinMask, RelaxesBoxAndWeight) {
  Settings settings = test::plainSettings();
  settings.neighborhood.box = BoxKind::Variance;
  settings.neighborhood.gamma = 0.5f;
  settings.neighborhood.maskRelax = Switch::On;
  for (const glm::vec2 mask : {glm::vec2(0, 0), {0.5f, 0.25f}, {0.25f, 0.5f}, {0, 1}}) {
    const float m = mask.x > mask.y ? mask.x : mask.y;
    const twin::PixelRecord record = twin::resolvePixel(masked(mask.x, mask.y), settings, 1, 1);
    EXPECT_EQ(at(record, IntermediateId::boxGamma).x, 0.5f + 0.75f * m);
    EXPECT_EQ(at(record, IntermediateId::alphaRelax).x, 1.0f / (1.0f + 0.5f * m));
    EXPECT_EQ(at(record, IntermediateId::alpha).x, 0.1f * (1.0f / (1.0f + 0.5f * m)));
    const float width = at(record, IntermediateId::boxMax).x - at(record, IntermediateId::neighborhoodMean).x;
    EXPECT_NEAR(width, (0.5f + 0.75f * m) * at(record, IntermediateId::neighborhoodDeviation).x, 1e-7f);
  }
}

TEST(TwinMask, IsZeroWhereNoneIsDrawn) {
  twin::Inputs inputs = masked(1.0f, 1.0f);
  inputs.mask = {};
  Settings settings = test::plainSettings();
  settings.neighborhood.maskRelax = Switch::On;
  for (const MaskAlpha use : {MaskAlpha::Responsive, MaskAlpha::Reactive, MaskAlpha::Exclude}) {
    settings.weight.mask = use;
    EXPECT_EQ(twin::resolvePixel(inputs, settings, 1, 1),
              twin::resolvePixel(inputs, test::plainSettings(), 1, 1));
  }
}

} // namespace
} // namespace taa
