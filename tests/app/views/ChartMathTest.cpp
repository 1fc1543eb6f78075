// The arithmetic of charts.
#include "app/models/ChartMath.h"
#include "app/views/plots/CurveLegend.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

using namespace taa::app;

namespace {
const double kGap = std::numeric_limits<double>::quiet_NaN();
}

TEST(ChartMath, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_EQ(roundStep(10.0, 5), 2.0);
  EXPECT_EQ(roundStep(11.0, 5), 5.0);
  EXPECT_EQ(roundStep(1.0, 10), 0.1);
  EXPECT_EQ(roundStep(240.0, 12), 20.0);
  EXPECT_NEAR(roundStep(0.003, 4), 0.001, 1e-18);
}

TEST(ChartMath, ARangeHasAtLeastTwoTicks) {
  EXPECT_EQ(ticksOf({-0.2, 0.4}, roundStep(0.6, 2)).size(), 1u) << "why";
  EXPECT_EQ(tickStep({-0.2, 0.4}, 2), 0.2);
  EXPECT_EQ(tickStep({0.0, 10.0}, 5), 2.0) << "as many as wanted";
  EXPECT_GT(tickStep({0.0, 0.0}, 2), 0.0);
}

TEST(ChartMath, TicksAreTheMultiplesOfAStepInARange) {
  EXPECT_EQ(ticksOf({0.0, 10.0}, 5.0), (std::vector<double>{0.0, 5.0, 10.0}));
  EXPECT_EQ(ticksOf({-120.0, 0.0}, 40.0), (std::vector<double>{-120.0, -80.0, -40.0, 0.0}));
  EXPECT_EQ(ticksOf({3.0, 11.0}, 4.0), (std::vector<double>{4.0, 8.0}));
  EXPECT_EQ(ticksOf({0.0, 0.3}, 0.1).size(), 4u) << "the last one in spite of rounding";
  EXPECT_TRUE(ticksOf({0.0, 1.0}, 0.0).empty());
  EXPECT_TRUE(ticksOf({0.0, 1.0}, kGap).empty());
}

TEST(ChartMath, ScalesEndAtRoundValuesAndStartAtZeroWhereItIsNear) {
  EXPECT_EQ(roundedSpan({0.1, 0.9}, 5), (Span{0.0, 1.0}));
  EXPECT_EQ(roundedSpan({8.2, 9.7}, 4), (Span{8.0, 10.0}));
  EXPECT_EQ(roundedSpan({-3.0, 4.0}, 4), (Span{-4.0, 4.0}));
  EXPECT_EQ(roundedSpan({0.0, 0.0}, 1), (Span{0.0, 1.0})) << "most values cannot be negative";
  const Span one = roundedSpan({4.0, 4.0}, 4);
  EXPECT_LT(one.low, 4.0);
  EXPECT_GT(one.high, 4.0);
}

TEST(ChartMath, ZoomKeepsWhatIsUnderTheCursorAndStaysInside) {
  const Span all{0.0, 100.0};
  EXPECT_EQ(zoomed(all, all, 2.0, 25.0, 4.0), (Span{12.5, 62.5}));
  EXPECT_EQ(zoomed({12.5, 62.5}, all, 0.5, 25.0, 4.0), all);
  EXPECT_EQ(zoomed(all, all, 1000.0, 100.0, 4.0), (Span{96.0, 100.0}));
  EXPECT_EQ(moved({10.0, 20.0}, all, 5.0), (Span{15.0, 25.0}));
  EXPECT_EQ(moved({10.0, 20.0}, all, 500.0), (Span{90.0, 100.0}));
  EXPECT_EQ(moved({10.0, 20.0}, all, -500.0), (Span{0.0, 10.0}));
}

TEST(ChartMath, ALegendGoesOnInTheNextLineBeforeItLeavesTheChart) {
  const std::vector<double> widths{30.0, 40.0, 50.0, 200.0, 10.0};
  const std::vector<LegendPlace> wide = placeLegend(widths, 20.0, 400.0, 500.0);
  EXPECT_EQ(wide, (std::vector<LegendPlace>{{0, 20.0}, {0, 50.0}, {0, 90.0}, {0, 140.0}, {0, 340.0}}));
  // 90 is the end of the first line, 100 that of the others; what is wider than a line has one for itself.
  const std::vector<LegendPlace> narrow = placeLegend(widths, 20.0, 90.0, 100.0);
  EXPECT_EQ(narrow, (std::vector<LegendPlace>{{0, 20.0}, {0, 50.0}, {1, 0.0}, {2, 0.0}, {3, 0.0}}));
  EXPECT_TRUE(placeLegend({}, 20.0, 90.0, 100.0).empty());
}

TEST(CurveLegend, ShortensNamesBeforeItTakesMoreLines) {
  std::vector<Curve> curves;
  for (int probe = 1; probe <= 9; ++probe)
    curves.push_back(
        {QStringLiteral("%1 surface").arg(probe), Qt::red, Qt::SolidLine, {}, QString::number(probe)});
  CurveLegend legend;
  legend.layOut("α", {curves[0], curves[1]}, 1200.0, 80.0);
  EXPECT_FALSE(legend.isShortened());
  EXPECT_EQ(legend.lines(), 1);
  const double line = legend.height();
  legend.layOut("α", curves, 1200.0, 80.0);
  EXPECT_TRUE(legend.isShortened());
  EXPECT_EQ(legend.lines(), 1);
  legend.layOut("α", curves, 420.0, 80.0);
  EXPECT_TRUE(legend.isShortened());
  EXPECT_GT(legend.lines(), 1);
  EXPECT_EQ(legend.height(), legend.lines() * line);
}

TEST(ChartMath, LinesAreBrokenAtGaps) {
  const std::vector<QPointF> points{{0, 1}, {1, 2}, {2, kGap}, {3, 4}, {4, kGap}};
  const auto runs = runsOf(points);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0], (std::vector<QPointF>{{0, 1}, {1, 2}}));
  EXPECT_EQ(runs[1], (std::vector<QPointF>{{3, 4}}));
  EXPECT_EQ(valueAt(points, 3), 4.0);
  EXPECT_FALSE(valueAt(points, 2));
  EXPECT_FALSE(valueAt(points, 2.5));
  EXPECT_FALSE(valueAt(points, 9));
  EXPECT_EQ(valueSpan(points, {0, 4}), (Span{1, 4}));
  EXPECT_EQ(valueSpan(points, {1, 2}), (Span{2, 2}));
  EXPECT_FALSE(valueSpan(points, {5, 6}));
}
