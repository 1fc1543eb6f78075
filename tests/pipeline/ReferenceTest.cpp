// The supersampled reference: what it is, that it is the same however it was reached, and that it changes
// nothing.
#include "core/base/Error.h"
#include "core/measure/compare/Flip.h"
#include "core/measure/compare/RelativeError.h"
#include "core/measure/compare/Ssim.h"
#include "core/render/ReferencePoints.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/taa/twin/Known.h"
#include "tests/support/SmallInspector.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

using taa::Image;
using taa::Inspector;
using taa::IntermediateId;
using taa::Metric;
using taa::Settings;
using namespace taa::test::small;

namespace {

const std::vector<IntermediateId> kRows = {
    IntermediateId::reference,     IntermediateId::referenceError, IntermediateId::referenceErrorAbs,
    IntermediateId::relativeError, IntermediateId::flip,           IntermediateId::ssimMap};

Settings changed(std::initializer_list<const char*> assignments) {
  Settings settings;
  for (const char* assignment : assignments) taa::applyAssignment(settings, assignment);
  return settings;
}

float luma(const glm::vec4& color) {
  return (0.2126f * color.x + 0.7152f * color.y) + 0.0722f * color.z;
}

} // namespace

class ReferenceTest : public InspectorTest {
 protected:
  static Image referenceOf(Inspector& inspector, int samples) {
    inspector.reference().refine(samples);
    return inspector.views().image(IntermediateId::reference);
  }
  static double rmse(const Image& a, const Image& b) { return taa::pictureError(a, b).rmseLinear; }
};

TEST_F(ReferenceTest, IsTheMeanOfJitteredPictures) {
  const auto inspector = opened();
  inspector->shot().seek(3);
  const Image reference = referenceOf(*inspector, 16);
  taa::SceneRenderer renderer(std::make_shared<const taa::Scene>(taa::openScene("builtin:fan")));
  taa::FrameRequest request{
      .camera = inspector->shot().camera(), .width = kWidth, .height = kHeight, .jitter = {}, .inputs = {}};
  request.inputs.precision = taa::Precision::Full;
  std::vector<double> sums(reference.pixels.size());
  for (int sample = 15; sample >= 0; --sample) { // in another order
    request.jitterPx = taa::referencePointPx(sample);
    taa::FrameInputs drawn;
    renderer.draw(request, 3, drawn);
    EXPECT_EQ(drawn.block.jitterPx, *request.jitterPx);
    const Image color = drawn.color.download();
    for (std::size_t pixel = 0; pixel < sums.size() / 3; ++pixel)
      for (std::size_t channel = 0; channel < 3; ++channel)
        sums[3 * pixel + channel] += color.pixels[4 * pixel + channel];
  }
  for (std::size_t index = 0; index < sums.size(); ++index)
    ASSERT_EQ(reference.pixels[index], static_cast<float>(sums[index] / 16.0)) << index;
}

// Frames of a scene that rests, jittered by a pattern of the settings, come to the same picture.
TEST_F(ReferenceTest, IsWhatFramesOfAStillSceneComeTo) {
  const Settings settings = changed({"jitter.sequence=r2", "jitter.period=64", "inputs.precision=full"});
  Inspector inspector;
  inspector.shot().setSize(kWidth, kHeight);
  inspector.shot().setSettings(settings);
  inspector.shot().open("builtin:fence");
  inspector.shot().setCamera("still");
  Image mean(kWidth, kHeight, 3), first;
  for (int frame = 0; frame < 64; ++frame) {
    inspector.shot().seek(frame);
    const Image color = inspector.views().image(IntermediateId::color);
    if (frame == 0) first = color;
    for (std::size_t index = 0; index < mean.pixels.size(); ++index)
      mean.pixels[index] += color.pixels[index] / 64.0f;
  }
  const Image reference = referenceOf(inspector, 256);
  EXPECT_GT(rmse(first, reference), 0.01) << "one frame has steps";
  EXPECT_LT(rmse(mean, reference), 0.15 * rmse(first, reference));
}

TEST_F(ReferenceTest, IsTheSameInStepsAndAtOnce) {
  const auto inspector = opened();
  inspector->shot().seek(4);
  const Image whole = referenceOf(*inspector, 64);
  for (const int samples : {4, 7, 16, 64}) { // fewer: it starts anew
    inspector->reference().refine(samples);
    EXPECT_EQ(inspector->reference().samples(), samples);
  }
  EXPECT_TRUE(isSame(inspector->views().image(IntermediateId::reference), whole));
}

TEST_F(ReferenceTest, GoesOnAfterItWasStopped) {
  const auto inspector = opened();
  inspector->shot().seek(4);
  const Image whole = referenceOf(*inspector, 16);
  inspector->reference().refine(4);
  std::vector<int> told;
  const auto stopAtSix = [&](std::string_view, int done, int total) {
    EXPECT_EQ(total, 16);
    told.push_back(done);
    return done < 6;
  };
  EXPECT_THROW(inspector->reference().refine(16, stopAtSix), taa::Cancelled);
  EXPECT_EQ(told, (std::vector{5, 6}));
  EXPECT_EQ(inspector->reference().samples(), 6);
  EXPECT_TRUE(isSame(referenceOf(*inspector, 16), whole));
}

TEST_F(ReferenceTest, ChangesNothingElse) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  const std::vector<Image> before = inspector->views().images(taa::allRows());
  referenceOf(*inspector, 4);
  inspector->views().images(kRows);
  expectSame(inspector->views().images(taa::allRows()), before);
  inspector->shot().advance();
  EXPECT_EQ(inspector->reference().samples(), 0) << "of another frame";
  expectSame(inspector->views().images(taa::allRows()), fresh({}, 6));
}

TEST_F(ReferenceTest, DependsOnWhatIsDrawnOnly) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  const Image first = referenceOf(*inspector, 8);
  inspector->shot().setSettings(changed(
      {"jitter.sequence=halton", "jitter.scale=0.5", "rectify.method=none", "inputs.mipBias=-1",
       "inputs.noise=blueNoise", "inputs.renderScale=0.5", "inputs.precision=full", "inputs.mask=material",
       "inputs.motion=cameraFromDepth", "inputs.range=ldr", "jitter.projection=rightAsPrinted"}));
  EXPECT_EQ(inspector->reference().samples(), 8) << "the same for all of them";
  EXPECT_TRUE(isSame(inspector->views().image(IntermediateId::reference), first));
  inspector->shot().setSettings(changed({"inputs.blended=before"}));
  EXPECT_EQ(inspector->reference().samples(), 0) << "transparent materials are drawn otherwise";
  inspector->shot().setSettings({});
  EXPECT_EQ(inspector->reference().samples(), 8);
  inspector->shot().seek(6);
  inspector->shot().seek(5);
  EXPECT_EQ(inspector->reference().samples(), 8) << "kept for its frame";
  inspector->shot().setSize(kWidth, kHeight + 1);
  EXPECT_EQ(inspector->reference().samples(), 0);
  inspector->shot().setSize(kWidth, kHeight);
  EXPECT_EQ(inspector->reference().samples(), 8);
  inspector->shot().setCamera("orbit");
  EXPECT_EQ(inspector->reference().samples(), 0);
  inspector->shot().open("builtin:fan");
  inspector->shot().seek(5);
  EXPECT_EQ(inspector->reference().samples(), 0) << "a scene that is opened again may be another one";
}

TEST_F(ReferenceTest, KeepsAsManyAsTheBudgetHolds) {
  const auto inspector = opened();
  const std::size_t bytes = std::size_t(24) * kWidth * kHeight;
  inspector->reference().setBudget(2 * bytes);
  for (const int frame : {1, 2}) {
    inspector->shot().seek(frame);
    inspector->reference().refine(4);
  }
  inspector->shot().seek(1);
  inspector->reference().refine(6); // used later than frame 2
  inspector->shot().seek(3);
  inspector->reference().refine(4);
  const auto samplesOf = [&](int frame) {
    inspector->shot().seek(frame);
    return inspector->reference().samples();
  };
  EXPECT_EQ(samplesOf(1), 6);
  EXPECT_EQ(samplesOf(2), 0) << "used longest ago";
  EXPECT_EQ(samplesOf(3), 4);
  inspector->reference().setBudget(0);
  EXPECT_EQ(samplesOf(1), 0);
  EXPECT_EQ(samplesOf(3), 4) << "the latest stays";
}

TEST_F(ReferenceTest, RowsAreTheirFormulas) {
  const auto inspector = opened();
  inspector->shot().seek(6);
  inspector->reference().refine(16);
  const Image output = inspector->views().image(IntermediateId::output);
  const std::vector<Image> rows = inspector->views().images(kRows);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const glm::vec4 is = output.texel(x, y), should = rows[0].texel(x, y);
      ASSERT_EQ(rows[1].texel(x, y).x, luma(is) - luma(should)) << x << ", " << y;
      const glm::vec4 off = glm::abs(is - should);
      ASSERT_EQ(rows[2].texel(x, y).x, std::max({off.x, off.y, off.z})) << x << ", " << y;
      const double relative = taa::relativeError(glm::vec3(is), glm::vec3(should));
      ASSERT_EQ(rows[3].texel(x, y).x, static_cast<float>(relative)) << x << ", " << y;
    }
  EXPECT_GT(taa::pictureError(output, rows[0]).rmse, 0.0) << "else nothing was tested";
  EXPECT_TRUE(isSame(rows[4], taa::flipMap(output, rows[0])));
  const Image alike = taa::ssimMap(taa::shownColors(output), taa::shownColors(rows[0]));
  EXPECT_EQ(*rows[5].at(7, 5), 1.0f - *alike.at(7, 5));
  const taa::PixelRecord record = inspector->probes().probe(20, 9);
  for (std::size_t row = 0; row < kRows.size(); ++row)
    EXPECT_EQ(taa::twin::at(record, kRows[row]), rows[row].texel(20, 9));
  const taa::gl::Rect part{11, 5, 7, 3};
  for (std::size_t row = 1; row < kRows.size(); ++row)
    EXPECT_EQ(inspector->views().image(kRows[row], 0, part).texel(6, 2), rows[row].texel(17, 7));
}

TEST_F(ReferenceTest, ErrorsFollowTheSettings) {
  const auto inspector = opened();
  inspector->shot().seek(6);
  inspector->reference().refine(16);
  const double balanced = inspector->reference().error().rmse;
  inspector->shot().setSettings(changed({"output.sharpen=unsharp", "output.amount=2"}));
  const Image output = inspector->views().image(IntermediateId::output);
  EXPECT_NE(inspector->reference().error().rmse, balanced);
  EXPECT_EQ(inspector->reference().error().rmseLinear,
            rmse(output, inspector->views().image(IntermediateId::reference)));
}

TEST_F(ReferenceTest, SaysWhereThereIsNone) {
  const auto inspector = opened();
  EXPECT_THROW(inspector->views().image(IntermediateId::reference), taa::Error);
  EXPECT_THROW(inspector->views().images(kRows), taa::Error);
  EXPECT_THROW(inspector->reference().error(), taa::Error);
  EXPECT_THROW(inspector->reference().refine(3), taa::Error);
  EXPECT_THROW(inspector->reference().refine(1025), taa::Error);
  const taa::PixelRecord record = inspector->probes().probe(3, 4);
  for (const IntermediateId id : kRows) {
    EXPECT_FALSE(taa::twin::isKnown(record, id));
    const taa::Picture picture =
        inspector->views().picture(id, taa::defaultStyle(taa::intermediate(id)), {}, kWidth, kHeight);
    EXPECT_EQ(std::ranges::count(picture.rgba, 0), 4 * kWidth * kHeight) << "nothing is covered";
  }
  inspector->reference().refine(4);
  EXPECT_TRUE(taa::twin::isKnown(inspector->probes().probe(3, 4), IntermediateId::referenceError));
  const taa::Picture picture = inspector->views().picture(IntermediateId::reference, {}, {}, kWidth, kHeight);
  EXPECT_EQ(picture.rgba[3], 255);
}

TEST_F(ReferenceTest, IsWatchedWithoutHarm) {
  const auto inspector = opened();
  inspector->views().watch({IntermediateId::alpha, IntermediateId::reference});
  inspector->shot().advance();
  EXPECT_TRUE(isSame(inspector->views().image(IntermediateId::alpha),
                     fresh({}, 1)[static_cast<std::size_t>(IntermediateId::alpha)]));
}

TEST_F(ReferenceTest, MetricsAreThoseOfTheImages) {
  const auto inspector = opened();
  inspector->shot().seek(6);
  std::vector<Metric> all;
  for (const taa::MetricInfo& info : taa::kMetrics) all.push_back(info.metric);
  taa::FrameMetrics metrics = inspector->metrics().measure(all);
  EXPECT_EQ(metrics.frame, 6);
  EXPECT_TRUE(metrics.exact);
  EXPECT_EQ(metrics.referenceSamples, 0);
  EXPECT_FALSE(metrics.at(Metric::Rmse) || metrics.at(Metric::Psnr)) << "no reference, no value";
  double alpha = 0.0, rejected = 0.0, clipped = 0.0;
  for (const float value : inspector->views().image(IntermediateId::alpha).pixels) alpha += value;
  for (const float value : inspector->views().image(IntermediateId::rejectReason).pixels)
    rejected += value != 0.0f;
  for (const float value : inspector->views().image(IntermediateId::clipAmount).pixels)
    clipped += value > 0.0f;
  constexpr double kPixels = kWidth * kHeight;
  EXPECT_DOUBLE_EQ(*metrics.at(Metric::MeanAlpha), alpha / kPixels);
  EXPECT_DOUBLE_EQ(*metrics.at(Metric::Rejected), 100.0 * rejected / kPixels);
  EXPECT_DOUBLE_EQ(*metrics.at(Metric::Clipped), 100.0 * clipped / kPixels);
  EXPECT_GT(rejected + clipped, 0.0) << "else nothing was tested";
  inspector->reference().refine(8);
  metrics = inspector->metrics().measure({Metric::Psnr, Metric::HistoryLength});
  EXPECT_EQ(metrics.referenceSamples, 8);
  EXPECT_FALSE(metrics.at(Metric::MeanAlpha) || metrics.at(Metric::Rmse)) << "not asked for";
  const taa::PictureError error = taa::pictureError(inspector->views().image(IntermediateId::output),
                                                    inspector->views().image(IntermediateId::reference));
  EXPECT_EQ(*metrics.at(Metric::Psnr), error.psnr);
  metrics = inspector->metrics().measure({Metric::Flip, Metric::Ssim, Metric::HdrFlip, Metric::Sharpness});
  const std::vector<Image> maps = inspector->views().images({IntermediateId::flip, IntermediateId::ssimMap});
  double seen = 0.0;
  for (const float value : maps[0].pixels) seen += value;
  EXPECT_DOUBLE_EQ(*metrics.at(Metric::Flip), seen / kPixels);
  EXPECT_DOUBLE_EQ(*metrics.at(Metric::Ssim), 1.0 - taa::meanSsim(maps[1]));
  EXPECT_GT(*metrics.at(Metric::HdrFlip), 0.0);
  EXPECT_GT(*metrics.at(Metric::Sharpness), 0.1);
}

// builtin:thin says what its lines cover: see there.
class ReferenceOfLines : public taa::test::GlTest {
 protected:
  static constexpr int kHigh = 540, kWide = 960;
  static std::unique_ptr<Inspector> lines() {
    auto inspector = std::make_unique<Inspector>();
    inspector->shot().setSize(kWide, kHigh);
    inspector->shot().open("builtin:thin");
    return inspector;
  }
  /// Of a pixel between the board, 0.02, and a line, 1.
  static double coverage(const Image& image, int x, int y) { return (image.texel(x, y).y - 0.02) / 0.98; }
};

TEST_F(ReferenceOfLines, HasTheCoverageOfEachPixel) {
  const auto inspector = lines();
  inspector->reference().refine(16);
  const Image reference = inspector->views().image(IntermediateId::reference);
  // The level line is at 210 px above the middle and one pixel wide: half of rows 59 and 60; the upright one
  // 425 px left of the middle and 110 px above it.
  for (int along = -30; along <= 30; ++along) {
    for (const int row : {59, 60}) EXPECT_NEAR(coverage(reference, 55 + along, row), 0.5, 1e-6) << along;
    for (const int column : {54, 55})
      EXPECT_NEAR(coverage(reference, column, 160 + along), 0.5, 1e-6) << along;
  }
}

TEST_F(ReferenceOfLines, CoverWhatTheyAreLargeAndComeNearerWithMoreSamples) {
  const auto inspector = lines();
  constexpr double kCovered = 18 * 85.0 * 1.0 + 18 * 85.0 * 0.5 + 5 * 800.0 * 1.0; // px
  std::vector<Image> images;
  for (const int samples : {4, 16, 64}) {
    inspector->reference().refine(samples);
    images.push_back(inspector->views().image(IntermediateId::reference));
    double sum = 0.0;
    for (int y = 0; y < kHigh; ++y)
      for (int x = 0; x < kWide; ++x) sum += coverage(images.back(), x, y);
    EXPECT_NEAR(sum / kCovered, 1.0, 0.01) << samples << " samples";
  }
  const double few = taa::pictureError(images[0], images[2]).rmseLinear;
  const double more = taa::pictureError(images[1], images[2]).rmseLinear;
  EXPECT_LT(more, 0.5 * few) << "four times the samples";
}
