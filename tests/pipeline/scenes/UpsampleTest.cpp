// Frames drawn smaller than the picture (manual §22): as the CPU twin says, and better than one frame
// stretched.
#include "core/base/Error.h"
#include "core/inspect/Inspector.h"
#include "core/settings/Parameters.h"
#include "tests/support/CompareImages.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/Frames.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/TwinInputs.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace taa {
namespace {

class UpsampledFramesTest : public test::GlTest {};

constexpr UpsampleKernel kKernels[] = {UpsampleKernel::SampleWeight, UpsampleKernel::Lanczos2,
                                       UpsampleKernel::Hdrp, UpsampleKernel::HdrpGaussian,
                                       UpsampleKernel::Fsr2};

TEST_F(UpsampledFramesTest, AreWhatTheTwinSaysAtOddSizes) {
  constexpr int kWidth = 101, kHeight = 57;
  TaaPass pass;
  for (const float scale : {0.5f, 0.67f, 0.75f})
    for (const UpsampleKernel kernel : kKernels) {
      Settings settings;
      settings.inputs.renderScale = scale;
      settings.current.upsample = kernel;
      test::Player player("builtin:fan", "orbit", kWidth, kHeight, settings);
      ExposedRows exposedRows(allRows(), {0, 0, kWidth, kHeight});
      for (int frame = 0; frame < 8; ++frame) {
        player.step(pass, &exposedRows);
        if (frame != 0 && frame != 1 && frame != 7) continue; // no history, the least, a usual one
        std::vector<Image> pictures;
        for (const IntermediateId id : allRows()) pictures.push_back(exposedRows.image(id));
        EXPECT_EQ(test::differenceFromTwin(test::twinInputs(player.inputs(), player.previous()), settings,
                                           pictures, isExact()),
                  "")
            << test::flags(settings) << ", frame " << frame;
      }
      EXPECT_EQ(player.inputs().width(), static_cast<int>(std::ceil(scale * kWidth)));
      EXPECT_EQ(player.history().color.width(), kWidth);
    }
}

/// c/(1 + c), so that a few highlights do not decide.
double shown(float value) {
  return value / (1.0 + value);
}

double meanSquaredError(const Image& a, const Image& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        const double error = shown(a.at(x, y)[channel]) - shown(b.at(x, y)[channel]);
        sum += error * error;
      }
  return sum / (3.0 * a.width * a.height);
}

/// Bilinear, clamped at the border.
Image stretched(const Image& image, int width, int height) {
  Image result(width, height, image.channels);
  const auto split = [](double position, int count) {
    const double clamped = std::clamp(position - 0.5, 0.0, count - 1.0);
    const int first = std::min(static_cast<int>(clamped), count - 2);
    return std::pair(first, clamped - first);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto [column, fx] = split((x + 0.5) * image.width / width, image.width);
      const auto [row, fy] = split((y + 0.5) * image.height / height, image.height);
      for (int c = 0; c < image.channels; ++c) {
        const double top = (1.0 - fx) * image.at(column, row)[c] + fx * image.at(column + 1, row)[c];
        const double bottom =
            (1.0 - fx) * image.at(column, row + 1)[c] + fx * image.at(column + 1, row + 1)[c];
        result.at(x, y)[c] = static_cast<float>((1.0 - fy) * top + fy * bottom);
      }
    }
  return result;
}

Image accumulated(const std::string& scene, const Settings& settings, int frames, int width, int height) {
  TaaPass pass;
  test::Player player(scene, "still", width, height, settings);
  for (int frame = 0; frame < frames; ++frame) player.step(pass);
  return player.history().color.download();
}

TEST_F(UpsampledFramesTest, GatherDetailThatOneFrameDoesNotHave) {
  constexpr int kWidth = 120, kHeight = 67;
  constexpr int kPeriod = 32; // 8/r²
  const Image reference = accumulated("builtin:fence", test::averagingSettings(64), 64, kWidth, kHeight);
  Settings small = test::averagingSettings(kPeriod);
  small.inputs.renderScale = 0.5f;
  Settings still = small;
  still.jitter.sequence = JitterSequence::None;
  test::Player one("builtin:fence", "still", kWidth, kHeight, still);
  one.draw();
  const Image bilinear = stretched(one.inputs().color.download(), kWidth, kHeight);
  const double before = meanSquaredError(bilinear, reference);
  for (const UpsampleKernel kernel : kKernels) {
    small.current.upsample = kernel;
    const double after =
        meanSquaredError(accumulated("builtin:fence", small, kPeriod, kWidth, kHeight), reference);
    EXPECT_LT(after, 0.25 * before) << test::flags(small);
  }
}

TEST_F(UpsampledFramesTest, StandBesideLanesOfOtherSizes) {
  std::vector<Settings> lanes(3);
  lanes[1].inputs.renderScale = 0.5f;
  lanes[2].inputs.renderScale = 0.75f;
  Inspector inspector;
  inspector.shot().setSize(101, 57);
  inspector.shot().open("builtin:fan");
  inspector.shot().setLanes(lanes);
  inspector.shot().seek(3);
  EXPECT_EQ(inspector.views().inputs(0).width(), 101);
  EXPECT_EQ(inspector.views().inputs(1).width(), 51);
  EXPECT_EQ(inspector.views().inputs(2).height(), 43);
  for (int lane = 0; lane < 3; ++lane) {
    const Image color = inspector.views().image(IntermediateId::resolved, lane);
    EXPECT_EQ(color.width, 101);
    EXPECT_EQ(color.height, 57);
    EXPECT_EQ(inspector.probes().probe(100, 56, lane)[static_cast<std::size_t>(IntermediateId::resolved)],
              color.texel(100, 56));
    EXPECT_THROW(inspector.probes().probe(101, 0, lane), Error);
  }
  inspector.shot().setSize(4, 4);
  EXPECT_EQ(inspector.views().inputs(1).height(), 2);
  EXPECT_EQ(inspector.views().image(IntermediateId::resolved, 1).width, 4);
  EXPECT_THROW(inspector.shot().setSize(3, 57), Error);
}

} // namespace
} // namespace taa
