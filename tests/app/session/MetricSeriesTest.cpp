// Metrics of frames on their way to the strip of the timeline.
#include "app/window/PlotPresenter.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

FrameMetrics metricsOf(int frame, double alpha) {
  FrameMetrics metrics;
  metrics.frame = frame;
  metrics.at(Metric::MeanAlpha) = alpha;
  return metrics;
}

using Values = std::vector<std::optional<double>>;

} // namespace

TEST(MetricSeries, KeepsTheExactMetricsOfTheFirstLane) {
  MetricSeries series;
  EXPECT_TRUE(series.add(metricsOf(1, 0.5)));
  FrameMetrics other = metricsOf(2, 0.25);
  other.exact = false;
  EXPECT_FALSE(series.add(other));
  other.exact = true;
  other.lane = 1;
  EXPECT_FALSE(series.add(other));
  EXPECT_EQ(series.strip(Metric::MeanAlpha, 4).values, (Values{{}, 0.5, {}, {}}));
  EXPECT_EQ(series.strip(Metric::Rmse, 2).values, (Values{{}, {}}));
  EXPECT_EQ(series.strip(Metric::Rejected, 2).unit, " %");
}

TEST(MetricSeries, ForgetsWhatIsNoLongerTrueAndIgnoresWhatComesTooLate) {
  MetricSeries series;
  series.add(metricsOf(1, 0.5));
  EXPECT_TRUE(series.setShotVersion(3));
  EXPECT_EQ(series.strip(Metric::MeanAlpha, 2).values, (Values{{}, {}}));
  FrameMetrics late = metricsOf(1, 0.5);
  late.shotVersion = 2;
  EXPECT_FALSE(series.add(late));
  late.shotVersion = 3;
  EXPECT_TRUE(series.add(late));
  EXPECT_FALSE(series.setShotVersion(3));
  EXPECT_EQ(series.strip(Metric::MeanAlpha, 2).values, (Values{{}, 0.5}));
}

TEST(MetricSeries, LeavesOutWhatCannotBeDrawn) {
  MetricSeries series;
  FrameMetrics metrics = metricsOf(0, 0.5);
  metrics.at(Metric::Psnr) = std::numeric_limits<double>::infinity();
  series.add(metrics);
  EXPECT_EQ(series.strip(Metric::Psnr, 1).values, (Values{{}}));
}
