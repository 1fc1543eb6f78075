// Where a chart has its plot, its points and its labels.
#include "app/views/plots/ChartAxes.h"

#include <QStringList>
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

using namespace taa::app;

namespace {

const QRectF kArea(10.0, 20.0, 300.0, 150.0);

ChartAxes laidOut(const ChartAxis& x, const ChartAxis& y) {
  ChartAxes axes;
  axes.layOut(x, y, kArea);
  return axes;
}

void expectLabelsHaveRoom(const ChartAxes& axes) {
  const std::vector<ChartLabel>& labels = axes.labels();
  for (std::size_t one = 0; one < labels.size(); ++one) {
    const QRectF withRounding = kArea.adjusted(-1e-6, -1e-6, 1e-6, 1e-6); // a tick is a multiple of its step
    EXPECT_TRUE(withRounding.contains(labels[one].place)) << labels[one].text.toStdString();
    EXPECT_FALSE(axes.plot().intersects(labels[one].place)) << labels[one].text.toStdString();
    for (std::size_t other = 0; other < one; ++other)
      EXPECT_FALSE(labels[one].place.intersects(labels[other].place))
          << labels[one].text.toStdString() << " and " << labels[other].text.toStdString();
  }
}

} // namespace

TEST(ChartAxes, APlotReachesFromTheLowestToTheHighestValues) {
  const ChartAxes axes = laidOut({{0.0, 240.0}, 40.0}, {{-1.0, 1.0}, 1.0});
  EXPECT_EQ(axes.pointOf({0.0, -1.0}), axes.plot().bottomLeft());
  EXPECT_EQ(axes.pointOf({240.0, 1.0}), axes.plot().topRight());
  EXPECT_EQ(axes.pointOf({120.0, 0.0}), axes.plot().center());
  EXPECT_TRUE(kArea.contains(axes.plot()));
}

TEST(ChartAxes, EveryTickHasALabelWithRoom) {
  const ChartAxes axes = laidOut({{-120.0, 0.0}, 40.0}, {{0.0, 0.3}, 0.1});
  QStringList texts;
  for (const ChartLabel& label : axes.labels()) texts << label.text;
  EXPECT_EQ(texts, (QStringList{"0", "0.1", "0.2", "0.3", "−120", "−80", "−40", "0"}));
  expectLabelsHaveRoom(axes);
}

TEST(ChartAxes, TitlesTakeRoomFromThePlot) {
  const ChartAxes bare = laidOut({{0.0, 1.0}, 1.0}, {{0.0, 1.0}, 1.0});
  const ChartAxes titled = laidOut({{0.0, 1.0}, 1.0, "frames"}, {{0.0, 1.0}, 1.0, "ms"});
  EXPECT_LT(titled.plot().bottom(), bare.plot().bottom());
  EXPECT_GT(titled.plot().left(), bare.plot().left());
  expectLabelsHaveRoom(titled);
}

TEST(ChartAxes, PlotsAboveEachOtherHaveOneLeftEdge) {
  const ChartAxis frames{{0.0, 10.0}, 5.0};
  EXPECT_EQ(laidOut(frames, {{0.0, 1.0}, 0.5}).plot().left(),
            laidOut(frames, {{0.0, 400.0}, 200.0}).plot().left());
  expectLabelsHaveRoom(laidOut(frames, {{0.0, 2.5e7}, 0.5e7}));
}

TEST(ChartAxes, LabelsThatWouldTouchAreThinnedOut) {
  const ChartAxes axes = laidOut({{-120.0, 0.0}, 5.0}, {{0.0, 1.0}, 1.0});
  expectLabelsHaveRoom(axes);
  const std::vector<ChartLabel>& labels = axes.labels();
  EXPECT_EQ(labels.back().text, "0") << "the last one stays";
  for (std::size_t index = 3; index < labels.size(); ++index) // after those of the rows
    EXPECT_GE(labels[index].place.left() - labels[index - 1].place.right(), 8.0)
        << labels[index].text.toStdString();
}

TEST(ChartAxes, LabelsOfALowChartAreThinnedOut) {
  ChartAxes axes;
  axes.layOut({{0.0, 1.0}, 1.0}, {{0.0, 300.0}, 50.0}, {0.0, 0.0, 200.0, 70.0});
  const std::vector<ChartLabel>& labels = axes.labels();
  for (std::size_t index = 1; labels[index].text != "0"; ++index)
    EXPECT_GT(labels[index - 1].place.center().y() - labels[index].place.center().y(),
              0.75 * labels[index].place.height())
        << labels[index].text.toStdString();
  EXPECT_EQ(labels[0].text, "0");
}
