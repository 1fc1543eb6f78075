// Points by two numbers: where they lie, and which one is meant.
#include "app/views/plots/ScatterChart.h"

#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include <vector>

using taa::app::ScatterChart;
using taa::app::ScatterPoint;

namespace {

class ScatterChartTest : public testing::Test {
 protected:
  void SetUp() override {
    chart_.resize(400, 300);
    chart_.setTitles("RMSE", "Flicker");
    chart_.setPoints({{3, "few", Qt::red, {0.01, 0.004}, true}, {5, "much", Qt::blue, {0.05, 0.001}, true}});
  }
  ScatterChart chart_;
};

} // namespace

TEST_F(ScatterChartTest, PlacesMoreToTheRightAndUpwards) {
  const QPointF few = chart_.placeOf(chart_.points()[0]), much = chart_.placeOf(chart_.points()[1]);
  EXPECT_LT(few.x(), much.x());
  EXPECT_LT(few.y(), much.y()) << "more flicker is higher up";
  EXPECT_TRUE(QRectF(chart_.rect()).contains(few));
  EXPECT_TRUE(QRectF(chart_.rect()).contains(much));
}

TEST_F(ScatterChartTest, KnowsThePointThatIsMeant) {
  const QPointF few = chart_.placeOf(chart_.points()[0]);
  EXPECT_EQ(chart_.pointAt(few + QPointF(4, -4)), &chart_.points()[0]);
  EXPECT_EQ(chart_.pointAt(few + QPointF(30, 30)), nullptr);
  EXPECT_EQ(chart_.textOf(chart_.points()[0]), "few: RMSE 0.01, Flicker 0.004");
}

TEST_F(ScatterChartTest, SaysWhichOneIsClicked) {
  QSignalSpy clicked(&chart_, &ScatterChart::pointClicked);
  QTest::mouseClick(&chart_, Qt::LeftButton, {}, chart_.placeOf(chart_.points()[1]).toPoint());
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_EQ(clicked[0][0].toULongLong(), 5u);
  QTest::mouseClick(&chart_, Qt::LeftButton, {}, {2, 2});
  EXPECT_EQ(clicked.count(), 1);
}

TEST_F(ScatterChartTest, PaintsNothingAndOneAndMany) {
  EXPECT_FALSE(chart_.grab().toImage().isNull());
  for (const int count : {0, 1, 100}) {
    std::vector<ScatterPoint> points;
    for (int index = 0; index < count; ++index)
      points.push_back({static_cast<std::size_t>(index), "one", Qt::red, {0.0, 0.0}, index % 2 == 0});
    chart_.setPoints(points);
    const QPointF place = count > 0 ? chart_.placeOf(chart_.points()[0]) : QPointF(10, 10);
    EXPECT_TRUE(QRectF(chart_.rect()).contains(place)) << count;
    chart_.grab();
  }
}

TEST_F(ScatterChartTest, NamesScenesWhereThereAreSeveral) {
  EXPECT_TRUE(chart_.scenes().empty());
  const QPointF before = chart_.placeOf(chart_.points()[0]);
  chart_.setPoints({{0, "Fan · few", Qt::red, {0.01, 0.004}, true, 0, "Fan"},
                    {1, "Fan · much", Qt::blue, {0.05, 0.001}, true, 0, "Fan"},
                    {2, "Fence · few", Qt::red, {0.02, 0.002}, true, 1, "Fence"}});
  ASSERT_EQ(chart_.scenes().size(), 2u);
  EXPECT_EQ(chart_.scenes()[1].sceneName, "Fence");
  EXPECT_GT(chart_.placeOf(chart_.points()[0]).y(), before.y()) << "their names stand above";
  EXPECT_FALSE(chart_.grab().toImage().isNull());
}
