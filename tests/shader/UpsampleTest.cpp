// Upsampling in GLSL: at full size it is the native path, and a confidence of 0 keeps history (invariant 65).
#include "core/settings/Parameters.h"
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/Variants.h"

#include <cstdint>
#include <string>

using taa::History;
using taa::Image;
using taa::IntermediateId;
using taa::Settings;
using taa::UpsampleKernel;
using taa::test::difference;
using taa::test::FrameShape;

namespace {

constexpr UpsampleKernel kKernels[] = {UpsampleKernel::SampleWeight, UpsampleKernel::Lanczos2,
                                       UpsampleKernel::Hdrp, UpsampleKernel::HdrpGaussian,
                                       UpsampleKernel::Fsr2};

class UpsampleTest : public taa::test::ResolveTest {
 protected:
  static void expectSame(const History& actual, const History& expected, const std::string& what) {
    EXPECT_EQ(difference(actual.color.download(), expected.color.download()), "") << what;
    EXPECT_EQ(difference(actual.surface.download(), expected.surface.download()), "") << what;
  }
};

} // namespace

TEST_F(UpsampleTest, NoKernelMattersAtFullSize) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    Settings settings = taa::test::randomSettings(2 * seed); // even seeds draw at full size
    ASSERT_FALSE(taa::isUpsampled(settings));
    const FrameShape shape = taa::test::shapeFor(settings);
    const taa::twin::Inputs frame = taa::test::randomFrame(shape, seed, true);
    settings.current.upsample = UpsampleKernel::SampleWeight;
    const History expected = resolve(frame, shape, settings);
    for (const UpsampleKernel kernel : kKernels) {
      settings.current.upsample = kernel;
      EXPECT_EQ(taa::glslPrelude(settings).find("const bool kUpsampled = true"), std::string::npos);
      expectSame(resolve(frame, shape, settings), expected, taa::test::flags(settings));
    }
  }
}

// 0.999 of this size is the whole size: the upsampling code runs, with a ratio of 1.
// Techniques: 22.5.
TEST_F(UpsampleTest, IsTheNativePathWhereAsManyTexelsAreDrawnAtPixelCenters) {
  for (const UpsampleKernel kernel : {UpsampleKernel::SampleWeight, UpsampleKernel::Lanczos2}) {
    Settings settings;
    settings.current = {.filter = taa::CurrentFilter::Center, .upsample = kernel};
    const FrameShape shape = taa::test::shapeFor(settings);
    taa::twin::Inputs frame = taa::test::randomFrame(shape, 3, true);
    frame.jitterPx = glm::vec2(0.0f);
    const History native = resolve(frame, shape, settings);
    settings.inputs.renderScale = 0.999f;
    ASSERT_EQ(taa::test::shapeFor(settings).drawnPx, shape.drawnPx);
    expectSame(resolve(frame, shape, settings), native, taa::test::flags(settings));
  }
}

TEST_F(UpsampleTest, ConfidenceOfNothingKeepsTheRectifiedHistory) {
  for (const UpsampleKernel kernel : kKernels) {
    if (kernel == UpsampleKernel::Hdrp || kernel == UpsampleKernel::HdrpGaussian) continue; // nowhere 0
    for (const taa::ToneWeight tone :
         {taa::ToneWeight::None, taa::ToneWeight::Luma, taa::ToneWeight::MaxChannel, taa::ToneWeight::Pq}) {
      Settings settings;
      settings.inputs.renderScale = 0.5f;
      settings.current.upsample = kernel;
      settings.history.precision = taa::Precision::Full;
      settings.blend.tone = tone;
      FrameShape shape = taa::test::shapeFor(settings, {96, 64});
      taa::twin::Inputs frame = taa::test::randomFrame(shape, 5, false);
      // Some pixels at the middle of four samples, where all but the nearest of Donut's weights vanish too.
      frame.jitterPx = glm::vec2(-0.25f, 0.25f);
      for (float& motion : frame.motion.pixels) motion = motion < 2.0f ? 0.0f : motion;
      const taa::test::Exposed all = expose(frame, shape, settings);
      int kept = 0;
      for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x) {
          if (all.at(IntermediateId::sampleConfidence).texel(x, y).x != 0.0f) continue;
          if (all.at(IntermediateId::rejectReason).texel(x, y).x != 0.0f) {
            ASSERT_EQ(all.at(IntermediateId::alpha).texel(x, y).x, 1.0f);
            continue;
          }
          ++kept;
          ASSERT_EQ(all.at(IntermediateId::alpha).texel(x, y).x, 0.0f);
          ASSERT_EQ(all.at(IntermediateId::resolved).texel(x, y),
                    all.at(IntermediateId::historyRectified).texel(x, y))
              << taa::test::flags(settings) << " at " << x << ", " << y;
        }
      EXPECT_GT(kept, 100) << taa::test::flags(settings);
    }
  }
}

// Techniques: 8.9.
TEST_F(UpsampleTest, ShowsTheNearestTexelOfEachPixel) {
  Settings settings;
  settings.inputs.renderScale = 0.5f;
  const FrameShape shape = taa::test::shapeFor(settings, {48, 32});
  taa::twin::Inputs frame = taa::test::randomFrame(shape, 6, false);
  frame.jitterPx = glm::vec2(0.0f);
  const taa::test::Exposed all = expose(frame, shape, settings);
  for (int y = 0; y < shape.height; ++y)
    for (int x = 0; x < shape.width; ++x) {
      EXPECT_EQ(all.at(IntermediateId::depth).texel(x, y), frame.depth.texel(x / 2, y / 2));
      EXPECT_EQ(all.at(IntermediateId::motion).texel(x, y), frame.motion.texel(x / 2, y / 2));
    }
}
