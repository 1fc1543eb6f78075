// The curves on the GPU and on the CPU over many values: the same bits, wherever a driver keeps to IEEE.
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/Variants.h"

#include "core/settings/Parameters.h"
#include "core/taa/GlslExport.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

using taa::Image;
using taa::IntermediateId;
using taa::Precision;
using taa::Settings;
using taa::test::bareSettings;
using taa::test::difference;
using taa::test::FrameShape;

namespace {

constexpr FrameShape kShape{192, 128, Precision::Full, Precision::Full};

/// Finer than halves: from 2⁻⁴⁰ to 65504 and 0, channels and neighbors far from each other.
float level(int x, int y, int channel) {
  const int step = (y * kShape.width + x) * 3 + channel;
  if (step % 997 == 0) return 0.0f;
  const float value = std::exp2(static_cast<float>(step) * (56.0f / (192.0f * 128.0f * 3.0f)) - 40.0f);
  return value < 65504.0f ? value : 65504.0f;
}

class ToneCurvesTest : public taa::test::ResolveTest {
 protected:
  /// All values once as history, mixed with all from bright to dark.
  static taa::twin::Inputs frame() {
    taa::twin::Inputs made = taa::test::flatFrame(kShape, 0.0f);
    made.historyColor = made.color;
    made.historySurface = Image(kShape.width, kShape.height, 2);
    std::ranges::fill(made.historySurface.pixels, 5.0f);
    for (int y = 0; y < kShape.height; ++y)
      for (int x = 0; x < kShape.width; ++x)
        for (int channel = 0; channel < 3; ++channel) {
          made.historyColor.at(x, y)[channel] = level(x, y, channel);
          made.color.at(x, y)[channel] = level(kShape.width - 1 - x, kShape.height - 1 - y, 2 - channel);
        }
    return made;
  }

  static Image twin(const taa::twin::Inputs& made, const Settings& settings, IntermediateId id) {
    Image image(kShape.width, kShape.height, 3);
    for (int y = 0; y < kShape.height; ++y)
      for (int x = 0; x < kShape.width; ++x) {
        const taa::twin::PixelRecord record = taa::twin::resolvePixel(made, settings, x, y);
        for (int channel = 0; channel < 3; ++channel)
          image.at(x, y)[channel] = taa::twin::at(record, id)[channel];
      }
    return image;
  }
};

} // namespace

TEST_F(ToneCurvesTest, MixAsTheTwinDoes) {
  const taa::twin::Inputs made = frame();
  for (const char* tone : {"pq", "logarithm", "whitePoint"})
    for (const float alpha : {0.1f, 0.9f}) {
      Settings settings = bareSettings();
      settings.weight.alpha = alpha;
      settings.blend.white = alpha < 0.5f ? 0.7f : 64.0f;
      taa::applyAssignment(settings, std::string("blend.tone=") + tone);
      const Image expected = twin(made, settings, IntermediateId::resolved);
      const Image shown = expose(made, kShape, settings).at(IntermediateId::resolved);
      EXPECT_EQ(difference(shown, expected, isExact() ? 0.0f : 1e-4f), "") << taa::test::flags(settings);
    }
}

TEST_F(ToneCurvesTest, GoToTheBoxAndBackAsTheTwinDoes) {
  const taa::twin::Inputs made = frame();
  for (const char* tone : {"pq", "logarithm", "gamma"}) {
    Settings settings = bareSettings();
    settings.rectify.method = taa::RectifyMethod::Clamp;
    taa::applyAssignment(settings, std::string("space.tone=") + tone);
    const taa::test::Exposed all = expose(made, kShape, settings);
    const Image mean = twin(made, settings, IntermediateId::neighborhoodMean),
                rectified = twin(made, settings, IntermediateId::historyRectified);
    const float tolerance = isExact() ? 0.0f : 1e-4f;
    EXPECT_EQ(difference(all.at(IntermediateId::neighborhoodMean), mean, tolerance), "") << tone;
    EXPECT_EQ(difference(all.at(IntermediateId::historyRectified), rectified, tolerance), "") << tone;
  }
}

// Where samples, moments and the mix are weighed by luma, and α by a difference of lumas.
TEST_F(ToneCurvesTest, WeighByTheChosenLumaAsTheTwinDoes) {
  const taa::twin::Inputs made = frame();
  std::map<std::string, Image> resolved;
  for (const std::string luma : {"rec709", "yCoCg"}) {
    Settings settings = bareSettings();
    for (const std::string& assignment :
         {"space.luma=" + luma, std::string("current.filter=tent"), std::string("current.lumaWeighted=on"),
          std::string("neighborhood.weights=luma"), std::string("blend.tone=luma"),
          std::string("weight.lumaFlicker=on")})
      taa::applyAssignment(settings, assignment);
    const taa::test::Exposed all = expose(made, kShape, settings);
    for (const IntermediateId id :
         {IntermediateId::currentFiltered, IntermediateId::neighborhoodMean, IntermediateId::resolved})
      EXPECT_EQ(difference(all.at(id), twin(made, settings, id), isExact() ? 0.0f : 1e-4f), "") << luma;
    resolved[luma] = all.at(IntermediateId::resolved);
  }
  EXPECT_NE(resolved["rec709"].pixels, resolved["yCoCg"].pixels);
}

// An option that is off costs nothing.
TEST_F(ToneCurvesTest, AreInNoProgramThatDoesNotChooseThem) {
  const auto holdsPowers = [](const char* assignment) {
    Settings settings;
    taa::applyAssignment(settings, assignment);
    return taa::exportedGlsl(settings, "test").find("log2OfRatio") != std::string::npos;
  };
  EXPECT_FALSE(holdsPowers("blend.tone=luma"));
  EXPECT_FALSE(holdsPowers("blend.tone=whitePoint"));
  EXPECT_TRUE(holdsPowers("blend.tone=pq"));
  EXPECT_TRUE(holdsPowers("space.tone=logarithm"));
}
