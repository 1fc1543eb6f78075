// Parts of the error of frames of a scene: a function of the last frames however they were reached, which sum
// up to the error and have the causes that the scene gives them.
#include "core/inspect/MetricCursor.h"
#include "core/taa/twin/Color.h"
#include "core/verdict/parts/VerdictMaps.h"
#include "tests/support/SmallInspector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

using taa::Image;
using taa::Inspector;
using taa::IntermediateId;
using taa::Metric;
using taa::OverTime;
using namespace taa::test::small;

namespace {

using enum IntermediateId;

const std::vector<IntermediateId> kParts = {errorGhost,    errorLag,           errorBlur,
                                            errorAliasing, errorRectification, errorOlder};
constexpr int kSamples = 4, kFrames = 5;

std::vector<IntermediateId> allRowsOfParts() {
  std::vector<IntermediateId> ids = kParts;
  ids.push_back(verdictMap);
  ids.push_back(geometryVerdict);
  return ids;
}

std::vector<Image> rowsOf(Inspector& inspector) {
  inspector.overTime().refine({OverTime::Parts}, kSamples);
  std::vector<Image> rows;
  for (const IntermediateId id : allRowsOfParts()) rows.push_back(inspector.views().image(id));
  return rows;
}

void expectSameRows(const std::vector<Image>& a, const std::vector<Image>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t row = 0; row < a.size(); ++row) EXPECT_TRUE(isSame(a[row], b[row])) << row;
}

double meanOf(const Image& row) {
  double sum = 0.0;
  for (const float value : row.pixels) sum += std::fabs(static_cast<double>(value));
  return sum / static_cast<double>(row.pixels.size());
}

/// Share of the pixels that have a verdict.
double shareOf(const Image& row, taa::HistoryVerdict verdict) {
  return static_cast<double>(std::ranges::count(row.pixels, static_cast<float>(verdict))) /
         static_cast<double>(row.pixels.size());
}

taa::Settings changed(std::initializer_list<const char*> assignments) {
  taa::Settings settings;
  for (const char* assignment : assignments) taa::applyAssignment(settings, assignment);
  return settings;
}

/// Nothing but the exponential mean of what is reprojected, each pixel by its own motion.
taa::Settings plain() {
  return changed({"rectify.method=none", "validate.depth=off", "history.filter=bilinear",
                  "history.precision=full", "inputs.precision=full", "weight.source=constant",
                  "weight.motion=none", "blend.tone=none", "weight.alpha=0.1", "dilate.method=none"});
}

} // namespace

class PartsOnScenesTest : public InspectorTest {
 protected:
  static std::unique_ptr<Inspector> small(const taa::Settings& settings = {},
                                          std::string_view source = "builtin:fan") {
    auto inspector = opened({settings});
    if (source != "builtin:fan") inspector->shot().open(std::string(source));
    inspector->overTime().setFrames(kFrames);
    return inspector;
  }
};

TEST_F(PartsOnScenesTest, SumUpToTheErrorOfTheResolvedColor) {
  for (const taa::Settings& settings :
       {taa::Settings{}, plain(), changed({"weight.source=contrastPerChannel", "history.filter=lanczos"}),
        changed({"inputs.renderScale=0.5", "blend.tone=maxChannel"})}) {
    const auto inspector = small(settings);
    inspector->shot().seek(9);
    const std::vector<Image> rows = rowsOf(*inspector);
    inspector->reference().refine(kSamples);
    const Image is = inspector->views().image(resolved), should = inspector->views().image(reference);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        float sum = 0.0f;
        for (std::size_t part = 0; part < kParts.size(); ++part) sum += *rows[part].at(x, y);
        const float error =
            taa::twin::luma(glm::vec3(is.texel(x, y))) - taa::twin::luma(glm::vec3(should.texel(x, y)));
        // Luma of seven pictures, each rounded, of colors up to 4 here.
        EXPECT_NEAR(sum, error, 5e-6f) << x << ", " << y;
      }
  }
}

TEST_F(PartsOnScenesTest, AreTheSameHoweverTheFrameWasReached) {
  const auto straight = small();
  straight->shot().seek(9);
  const std::vector<Image> expected = rowsOf(*straight);
  EXPECT_GT(meanOf(expected[0]), 0.0) << "else nothing was tested";
  const auto played = small();
  while (played->shot().frame() < 9) {
    if (played->shot().frame() >= 6) rowsOf(*played); // the window goes along
    played->shot().advance();
  }
  expectSameRows(rowsOf(*played), expected);
  played->shot().seek(12);
  rowsOf(*played);
  played->shot().seek(9);
  expectSameRows(rowsOf(*played), expected);
  played->overTime().forget();
  played->overTime().refine({OverTime::Flicker, OverTime::Parts}, kSamples);
  expectSameRows(rowsOf(*played), expected);
}

TEST_F(PartsOnScenesTest, AreAliasingAloneWhereNothingMoves) {
  const auto inspector = small(plain(), "builtin:fence");
  inspector->shot().setCamera("still");
  inspector->shot().seek(4);
  const std::vector<Image> rows = rowsOf(*inspector);
  for (const std::size_t part : {0u, 1u, 2u, 5u}) EXPECT_EQ(meanOf(rows[part]), 0.0) << part;
  EXPECT_GT(meanOf(rows[3]), 1e-4) << "single frames alias";
  // Five roundings of colors below 16.
  for (const float value : rows[4].pixels) EXPECT_NEAR(value, 0.0f, 1e-5f);
}

TEST_F(PartsOnScenesTest, AreBlurWhereTheCameraMovesAndTheFilterBlurs) {
  const auto inspector = small(plain(), "builtin:text");
  inspector->shot().setSize(96, 54);
  inspector->shot().seek(9);
  const std::vector<Image> blurred = rowsOf(*inspector);
  EXPECT_GT(meanOf(blurred[2]), 0.01);
  for (const std::size_t part : {0u, 1u}) EXPECT_LT(meanOf(blurred[part]), 0.02 * meanOf(blurred[2])) << part;
}

TEST_F(PartsOnScenesTest, AreAGhostBehindWhatMovesUnlessHistoryIsRejected) {
  const auto rowsWith = [](const taa::Settings& settings) {
    const auto inspector = small(settings, "builtin:disocclusion");
    inspector->shot().setSize(192, 108); // so that more than a pixel is uncovered in a frame
    inspector->shot().seek(24);
    return rowsOf(*inspector);
  };
  taa::Settings rejecting = plain();
  taa::applyAssignment(rejecting, "validate.depth=on");
  const std::vector<Image> through = rowsWith(plain()), removed = rowsWith(rejecting);
  const auto shares = [](const std::vector<Image>& rows, taa::HistoryVerdict verdict) {
    return shareOf(rows[7], verdict);
  };
  using enum taa::HistoryVerdict;
  EXPECT_GT(shares(through, LetThrough), 0.0);
  // The depth test looks around by a pixel: where less is uncovered it finds what is there still.
  EXPECT_LT(shares(removed, LetThrough), 0.8 * shares(through, LetThrough));
  EXPECT_DOUBLE_EQ(shares(removed, Removed) + shares(removed, LetThrough),
                   shares(through, Removed) + shares(through, LetThrough))
      << "what has to be removed is a matter of the scene";
  EXPECT_LT(meanOf(removed[0]), 0.7 * meanOf(through[0]));
}

TEST_F(PartsOnScenesTest, ArePulledAwayByClipping) {
  taa::Settings clipping = plain();
  taa::applyAssignment(clipping, "rectify.method=clipToCenter");
  const auto clipped = small(clipping, "builtin:disocclusion");
  const auto kept = small(plain(), "builtin:disocclusion");
  for (Inspector* inspector : {clipped.get(), kept.get()}) inspector->shot().seek(9);
  const Image treated = rowsOf(*clipped)[6], untreated = rowsOf(*kept)[6];
  EXPECT_EQ(shareOf(untreated, taa::HistoryVerdict::ThrownAway), 0.0) << "nothing is rejected but off screen";
  EXPECT_GT(shareOf(treated, taa::HistoryVerdict::Removed), shareOf(untreated, taa::HistoryVerdict::Removed));
  EXPECT_LT(shareOf(treated, taa::HistoryVerdict::LetThrough),
            shareOf(untreated, taa::HistoryVerdict::LetThrough));
}

TEST_F(PartsOnScenesTest, StartWithHistory) {
  const auto inspector = small();
  const std::vector<Image> rows = rowsOf(*inspector); // frame 0
  for (const std::size_t row : {0u, 1u, 2u, 5u, 6u, 7u}) EXPECT_EQ(meanOf(rows[row]), 0.0) << row;
  EXPECT_GT(meanOf(rows[3]), 0.0);
}

TEST_F(PartsOnScenesTest, MetricsOfOtherFramesAreThoseOfTheFrame) {
  const auto inspector = small();
  const std::vector<Metric> wanted{Metric::ErrorGhost,  Metric::ErrorBlur, Metric::HistoryLetThrough,
                                   Metric::RightlyKept, Metric::Flicker,   Metric::MeanAlpha};
  taa::MetricCursor cursor;
  std::vector<taa::FrameMetrics> beside;
  for (int frame = 6; frame <= 8; ++frame)
    beside.push_back(inspector->metrics().measureFrame(frame, wanted, kSamples, cursor));
  for (const taa::FrameMetrics& metrics : beside) {
    inspector->shot().seek(metrics.frame);
    inspector->overTime().refine({OverTime::Flicker, OverTime::Parts}, kSamples);
    const std::vector<Image> rows = rowsOf(*inspector);
    const taa::FrameMetrics shown = inspector->metrics().measure(wanted);
    EXPECT_EQ(metrics.partsSamples, kSamples);
    EXPECT_EQ(metrics.flickerSamples, kSamples);
    EXPECT_EQ(metrics.values, shown.values);
    EXPECT_DOUBLE_EQ(shown.at(Metric::ErrorGhost).value(), meanOf(rows[0]));
    EXPECT_DOUBLE_EQ(shown.at(Metric::RightlyKept).value(),
                     100.0 * shareOf(rows[6], taa::HistoryVerdict::RightlyKept));
  }
}
