// Flicker of frames of a scene: a function of the last frames however they were reached, that changes
// nothing.
#include "core/base/Error.h"
#include "core/inspect/MetricCursor.h"
#include "core/measure/Flicker.h"
#include "core/measure/compare/GhostEnergy.h"
#include "core/taa/twin/Known.h"
#include "tests/support/SmallInspector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
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

const std::vector<IntermediateId> kRows = {flicker, deviationOverTime, framesFollowed};
constexpr int kSamples = 4, kFrames = 5;

std::vector<Image> rowsOf(Inspector& inspector, int samples = kSamples) {
  inspector.overTime().refine({OverTime::Flicker}, samples);
  std::vector<Image> rows;
  for (const IntermediateId id : kRows)
    if (samples > 0 || id != flicker) rows.push_back(inspector.views().image(id));
  return rows;
}

void expectSameRows(const std::vector<Image>& a, const std::vector<Image>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t row = 0; row < a.size(); ++row) EXPECT_TRUE(isSame(a[row], b[row])) << row;
}

} // namespace

class FlickerOnScenesTest : public InspectorTest {
 protected:
  static std::unique_ptr<Inspector> small() {
    auto inspector = opened();
    inspector->overTime().setFrames(kFrames);
    return inspector;
  }
};

TEST_F(FlickerOnScenesTest, IsTheSameHoweverTheFrameWasReached) {
  const auto rowsAt9 = [](const taa::Settings& settings) {
    const auto inspector = small();
    inspector->shot().setSettings(settings);
    inspector->shot().seek(9);
    return rowsOf(*inspector);
  };
  const std::vector<Image> sought = rowsAt9({}), others = rowsAt9(otherSettings());
  EXPECT_GT(*std::ranges::max_element(sought[0].pixels), 0.0f) << "else nothing was tested";
  EXPECT_FALSE(isSame(others[0], sought[0])) << "else nothing was tested";
  const auto played = small();
  while (played->shot().frame() < 9) {
    if (played->shot().frame() >= 7) rowsOf(*played); // the window goes along
    played->shot().advance();
  }
  expectSameRows(rowsOf(*played), sought);
  played->shot().seek(12);
  rowsOf(*played);
  played->shot().seek(9);
  expectSameRows(rowsOf(*played), sought);
  played->shot().setSettings(otherSettings()); // on history of the first ones
  ASSERT_FALSE(played->shot().isExact());
  EXPECT_FALSE(played->overTime().samples(OverTime::Flicker));
  expectSameRows(rowsOf(*played), others);
}

TEST_F(FlickerOnScenesTest, IsThatOfWhatIsShown) {
  // Where all stands still the way stays on the pixel.
  const auto inspector = small();
  inspector->shot().setCamera("still");
  inspector->shot().seek(9);
  rowsOf(*inspector);
  const Image deviation = inspector->views().image(deviationOverTime),
              frames = inspector->views().image(framesFollowed);
  std::vector<Image> shown;
  for (int frame = 5; frame <= 9; ++frame) {
    inspector->shot().seek(frame);
    shown.push_back(taa::shownColors(inspector->views().image(output)));
  }
  std::vector<Image> motions;
  for (int frame = 5; frame <= 9; ++frame) {
    inspector->shot().seek(frame);
    motions.push_back(inspector->views().image(motion));
  }
  int checked = 0;
  for (int y = 1; y + 1 < kHeight; ++y)
    for (int x = 1; x + 1 < kWidth; ++x) {
      const auto moves = [&](const Image& motionPx) {
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            if (motionPx.texel(x + dx, y + dy) != glm::vec4(0.0f)) return true;
        return false;
      };
      if (std::ranges::any_of(motions, moves)) continue;
      double variance = 0.0;
      for (int channel = 0; channel < 3; ++channel) {
        double mean = 0.0, square = 0.0;
        for (const Image& picture : shown) mean += picture.at(x, y)[channel] / 5.0;
        for (const Image& picture : shown) square += std::pow(picture.at(x, y)[channel] - mean, 2.0) / 5.0;
        variance += square / 3.0;
      }
      EXPECT_NEAR(*deviation.at(x, y), std::sqrt(variance), 1e-6) << x << ", " << y;
      EXPECT_EQ(*frames.at(x, y), 5.0f) << x << ", " << y;
      ++checked;
    }
  EXPECT_GT(checked, 100);
}

TEST_F(FlickerOnScenesTest, IsOnlyThereOnceItIsMade) {
  const auto inspector = small();
  inspector->shot().seek(6);
  for (const IntermediateId id : kRows) {
    EXPECT_FALSE(taa::twin::isKnown(inspector->probes().probe(3, 4), id));
    EXPECT_THROW(inspector->views().image(id), taa::Error);
    EXPECT_FALSE(inspector->views().isCached({.id = id}));
  }
  inspector->overTime().refine({OverTime::Flicker}, 0);
  EXPECT_EQ(inspector->overTime().samples(OverTime::Flicker), 0);
  EXPECT_TRUE(inspector->views().isCached({.id = deviationOverTime}));
  EXPECT_FALSE(inspector->views().isCached({.id = flicker})) << "it needs a reference";
  EXPECT_THROW(inspector->views().image(flicker), taa::Error);
  EXPECT_FALSE(inspector->metrics().measure({Metric::Flicker}).at(Metric::Flicker));
  inspector->reference().makeRows({flicker}, kSamples);
  for (const IntermediateId id : kRows)
    EXPECT_EQ(taa::twin::at(inspector->probes().probe(3, 4), id).x, *inspector->views().image(id).at(3, 4));
  inspector->shot().seek(7);
  EXPECT_FALSE(inspector->overTime().samples(OverTime::Flicker));
}

TEST_F(FlickerOnScenesTest, StartsAnewWithHistory) {
  const auto inspector = small();
  rowsOf(*inspector); // frame 0
  for (const float frames : inspector->views().image(framesFollowed).pixels) ASSERT_EQ(frames, 1.0f);
  EXPECT_FALSE(inspector->metrics().measure({Metric::Flicker}).at(Metric::Flicker))
      << "nothing was seen before";
  inspector->shot().seek(2);
  const Image frames = rowsOf(*inspector).back();
  EXPECT_EQ(*std::ranges::max_element(frames.pixels), 3.0f);
}

TEST_F(FlickerOnScenesTest, FollowsTheGeometryAndNotTheSettings) {
  const auto inspector = small();
  inspector->shot().seek(9);
  const Image frames = rowsOf(*inspector, 0).back();
  EXPECT_LT(*std::ranges::min_element(frames.pixels), 5.0f) << "the blades hide what is behind them";
  taa::Settings minimal;
  taa::applyAssignment(minimal, "jitter.sequence=none");
  taa::applyAssignment(minimal, "inputs.renderScale=0.5");
  inspector->shot().setSettings(minimal);
  EXPECT_TRUE(isSame(rowsOf(*inspector, 0).back(), frames));
}

TEST_F(FlickerOnScenesTest, LooksWithoutHarmAndGoesOnAfterACancel) {
  const auto inspector = small();
  inspector->shot().seek(9);
  const Image before = inspector->views().image(output);
  const int kept = static_cast<int>(inspector->shot().keptFrames().size());
  int reports = 0;
  EXPECT_THROW(inspector->overTime().refine({OverTime::Flicker}, kSamples,
                                            [&](std::string_view, int, int) { return ++reports < 12; }),
               taa::Cancelled);
  EXPECT_FALSE(inspector->overTime().samples(OverTime::Flicker));
  const std::vector<Image> rows = rowsOf(*inspector);
  EXPECT_TRUE(isSame(inspector->views().image(output), before));
  EXPECT_EQ(inspector->shot().frame(), 9);
  EXPECT_EQ(static_cast<int>(inspector->shot().keptFrames().size()), kept);
  const auto straight = small();
  straight->shot().seek(9);
  expectSameRows(rows, rowsOf(*straight));
}

TEST_F(FlickerOnScenesTest, GhostsLieTowardsWhatWasShownAFrameAgo) {
  const auto inspector = small();
  taa::Settings unguarded; // history is kept wherever it comes from
  for (const char* assignment : {"rectify.method=none", "validate.depth=off", "output.sharpen=none"})
    taa::applyAssignment(unguarded, assignment);
  inspector->shot().setSettings(unguarded);
  inspector->shot().seek(8);
  const Image before = taa::shownColors(inspector->views().image(output));
  inspector->shot().seek(9);
  inspector->reference().makeRows({reference, ghost}, kSamples);
  const Image shown = taa::shownColors(inspector->views().image(output));
  const Image expected = taa::ghostMap({shown, taa::shownColors(inspector->views().image(reference)), before,
                                        inspector->views().image(historyPosition)});
  EXPECT_TRUE(isSame(inspector->views().image(ghost), expected));
  const taa::FrameMetrics metrics = inspector->metrics().measure({Metric::GhostEnergy, Metric::Rmse});
  EXPECT_EQ(metrics.at(Metric::GhostEnergy), taa::ghostEnergy(expected));
  EXPECT_GT(*metrics.at(Metric::GhostEnergy), 0.01) << "the blades leave trails";
  EXPECT_LE(*metrics.at(Metric::GhostEnergy), *metrics.at(Metric::Rmse));
  taa::MetricCursor cursor;
  EXPECT_EQ(
      inspector->metrics().measureFrame(9, {Metric::GhostEnergy}, kSamples, cursor).at(Metric::GhostEnergy),
      metrics.at(Metric::GhostEnergy));
  inspector->shot().setSettings({});
  inspector->overTime().refine({OverTime::Flicker}, kSamples);
  EXPECT_LT(*inspector->metrics().measure({Metric::GhostEnergy}).at(Metric::GhostEnergy),
            0.5 * *metrics.at(Metric::GhostEnergy))
      << "rectification takes most of them away";
  inspector->shot().seek(0);
  inspector->overTime().refine({OverTime::Flicker}, kSamples);
  EXPECT_FALSE(inspector->metrics().measure({Metric::GhostEnergy}).at(Metric::GhostEnergy))
      << "nothing was shown before";
}

TEST_F(FlickerOnScenesTest, MetricsOfOtherFramesAreThoseOfTheFrame) {
  const auto inspector = small();
  const std::vector<Metric> wanted{Metric::Deviation, Metric::Flicker, Metric::Psnr, Metric::MeanAlpha};
  taa::MetricCursor cursor;
  std::vector<taa::FrameMetrics> beside;
  for (int frame = 6; frame <= 8; ++frame)
    beside.push_back(inspector->metrics().measureFrame(frame, wanted, kSamples, cursor));
  for (const taa::FrameMetrics& metrics : beside) {
    inspector->shot().seek(metrics.frame);
    inspector->reference().refine(kSamples);
    const std::vector<Image> rows = rowsOf(*inspector);
    const taa::FrameMetrics shown = inspector->metrics().measure(wanted);
    EXPECT_EQ(metrics.flickerSamples, kSamples);
    EXPECT_EQ(metrics.values, shown.values);
    EXPECT_EQ(shown.at(Metric::Flicker), taa::meanOverTime(rows[0], rows[2]));
    EXPECT_EQ(shown.at(Metric::Deviation), taa::meanOverTime(rows[1], rows[2]));
    EXPECT_GT(*shown.at(Metric::Deviation), *shown.at(Metric::Flicker)) << "the fan turns";
    EXPECT_GT(*shown.at(Metric::Flicker), 0.0);
  }
}
