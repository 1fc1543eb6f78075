// The pass after the resolve: shows the resolved picture as it is unless told otherwise, and never touches
// it.
#include "core/base/Error.h"
#include "tests/support/CompareImages.h"
#include "tests/support/ShaderFolder.h"
#include "tests/support/frames/ResolveTest.h"

#include <algorithm>
#include <vector>

using taa::ExposedRows;
using taa::History;
using taa::IntermediateId;
using taa::Settings;
using taa::Sharpen;
using taa::test::crop;
using taa::test::difference;
using taa::test::Exposed;
using taa::test::FrameShape;

namespace {

const std::vector<IntermediateId> kOutputRows{IntermediateId::sharpenDetail, IntermediateId::blurTrust,
                                              IntermediateId::output};

// Off, each way to sharpen with and without motion blur.
std::vector<Settings> outputs() {
  std::vector<Settings> all;
  for (int method = 0; method <= static_cast<int>(Sharpen::Mitchell); ++method)
    for (const taa::Switch blur : {taa::Switch::Off, taa::Switch::On}) {
      Settings settings;
      settings.output.sharpen = static_cast<Sharpen>(method);
      settings.output.amount = 1.5f;
      settings.output.motionBlur = blur;
      all.push_back(settings);
    }
  return all;
}

} // namespace

class OutputTest : public taa::test::ResolveTest {};

TEST_F(OutputTest, IsTheResolvedPictureWhenAllIsOff) {
  for (const taa::Precision precision : {taa::Precision::Half, taa::Precision::Full}) {
    FrameShape shape;
    shape.history = precision;
    Settings settings;
    settings.history.precision = precision;
    taa::twin::Inputs frame = taa::test::randomFrame(shape, 11, true);
    frame.overlay = {};
    const Exposed all = expose(frame, shape, settings);
    EXPECT_EQ(difference(all.at(IntermediateId::output), all.at(IntermediateId::resolved)), "");
    EXPECT_EQ(difference(all.at(IntermediateId::sharpenDetail), taa::Image(shape.width, shape.height, 1)),
              "");
  }
}

// output·(1 − a) + overlay, in what is shown and nowhere else (21.1).
// Techniques: 21.1.
TEST_F(OutputTest, LaysTheOverlayOverWhatIsShown) {
  const FrameShape shape;
  taa::twin::Inputs frame = taa::test::randomFrame(shape, 14, true);
  for (const Settings& settings : outputs()) {
    const Exposed with = expose(frame, shape, settings);
    taa::twin::Inputs bare = frame;
    bare.overlay = {};
    const Exposed without = expose(bare, shape, settings);
    EXPECT_EQ(difference(with.at(IntermediateId::resolved), without.at(IntermediateId::resolved)), "");
    EXPECT_EQ(difference(with.at(IntermediateId::sharpenDetail), without.at(IntermediateId::sharpenDetail)),
              "");
    taa::Image expected = without.at(IntermediateId::output);
    for (int y = 0; y < shape.height; ++y)
      for (int x = 0; x < shape.width; ++x) {
        const glm::vec4 layer = frame.overlay.texel(x, y);
        for (int channel = 0; channel < 3; ++channel)
          expected.at(x, y)[channel] =
              std::min(expected.at(x, y)[channel] * (1.0f - layer.w) + layer[channel], 65504.0f);
      }
    EXPECT_EQ(difference(with.at(IntermediateId::output), expected, isExact() ? 0.0f : 1e-6f), "");
  }
}

// Invariant 62: sharpening never feeds history.
TEST_F(OutputTest, NeverGoesIntoHistory) {
  const FrameShape shape;
  taa::twin::Inputs plain = taa::test::randomFrame(shape, 12, true);
  std::vector<taa::twin::Inputs> others(outputs().size(), plain);
  std::vector<taa::Image> shown(others.size());
  for (int frame = 0; frame < 3; ++frame) {
    advance(plain, shape, {});
    for (std::size_t i = 0; i < others.size(); ++i) {
      ExposedRows exposedRows(kOutputRows, whole(shape));
      taa::test::downloadHistory(resolve(others[i], shape, outputs()[i], &exposedRows), others[i]);
      ASSERT_EQ(difference(others[i].historyColor, plain.historyColor), "") << i << ", frame " << frame;
      ASSERT_EQ(difference(others[i].historySurface, plain.historySurface), "") << i << ", frame " << frame;
      shown[i] = exposedRows.image(IntermediateId::output);
    }
  }
  for (std::size_t i = 1; i < shown.size(); ++i)
    EXPECT_FALSE(taa::test::agree(shown[i], shown[0])) << i << " shows what is shown without it";
}

TEST_F(OutputTest, ShowsInARegionWhatTheWholePictureHasThere) {
  const FrameShape shape;
  const taa::twin::Inputs frame = taa::test::randomFrame(shape, 13, true);
  const taa::FrameInputs inputs = taa::test::upload(frame, shape);
  const History previous = taa::test::uploadHistory(frame, shape);
  for (const Settings& settings : outputs()) {
    const Exposed all = expose(frame, shape, settings);
    const History resolved = resolve(frame, shape, settings);
    for (const taa::gl::Rect& region : {taa::gl::Rect{0, 0, 1, 1}, {96, 60, 1, 1}, {40, 7, 30, 20}}) {
      ExposedRows some(kOutputRows, region);
      pass().expose(inputs, &previous, resolved, settings, some);
      for (const IntermediateId id : kOutputRows)
        EXPECT_EQ(
            difference(some.image(id), crop(all.at(id), region.x, region.y, region.width, region.height)), "")
            << taa::intermediate(id).name;
    }
  }
}

TEST_F(OutputTest, IsFiniteWhateverIsDrawn) {
  const FrameShape shape;
  for (const Settings& settings : outputs()) {
    const Exposed all = expose(taa::test::randomFrame(shape, 14, true), shape, settings);
    for (const float value : all.at(IntermediateId::output).pixels)
      ASSERT_TRUE(value >= 0.0f && value <= 65504.0f) << value;
  }
}

TEST_F(OutputTest, ABrokenShaderKeepsTheProgramsThatRun) {
  const FrameShape shape;
  const taa::twin::Inputs frame = taa::test::randomFrame(shape, 15, false);
  const taa::test::ShaderFolder folder;
  taa::TaaPass own;
  const taa::FrameInputs inputs = taa::test::upload(frame, shape);
  History out;
  ExposedRows exposedRows(kOutputRows, whole(shape));
  own.resolve(inputs, nullptr, {}, out, &exposedRows);
  const taa::Image before = exposedRows.image(IntermediateId::output);

  folder.replace("taa/output.glsl", "precise float detail", "no float detail");
  EXPECT_THROW(own.reloadShaders(), taa::Error);
  own.resolve(inputs, nullptr, {}, out, &exposedRows);
  EXPECT_EQ(difference(exposedRows.image(IntermediateId::output), before), "")
      << "after a reload that failed";

  folder.replace("taa/output.glsl", "no float detail", "precise float detail");
  folder.replace("taa/output.glsl", "expose_output(color)", "expose_output(vec3(2.0))");
  own.reloadShaders();
  own.resolve(inputs, nullptr, {}, out, &exposedRows);
  EXPECT_EQ(exposedRows.image(IntermediateId::output).pixels[0], 2.0f) << "the new shader runs";
}
