// The profiler panel: costs nothing while it is hidden, shows what arrives, and gives it away as text.
#include "app/panels/ProfilerPanel.h"

#include "app/models/ProfileSeries.h"
#include "app/panels/PipelinePanel.h"
#include "app/session/Mailbox.h"
#include "app/style/Theme.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "app/views/plots/ProfileChart.h"
#include "app/widgets/SectionHeader.h"
#include "app/widgets/ValueTable.h"
#include "tests/app/WindowFixture.h"

#include <QAbstractItemModel>
#include <QClipboard>
#include <QMenu>
#include <QPushButton>

#include <algorithm>
#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class Profiler : public test::FakeWindow {
 protected:
  void open() { key(Qt::Key_F11, Qt::ControlModifier | Qt::ShiftModifier); }
  static QString cell(const ValueTable* table, int row, int column) {
    return table->topLevelItem(row)->text(column);
  }
};

FrameProfile profileOf(double first, double second) {
  FrameProfile profile;
  profile.passes = {{"G-buffer", first, 1}, {"Resolve", second, 1}, {"Between the passes", 0.0, 0}};
  profile.totalMs = first + second;
  return profile;
}

} // namespace

// A table that told of each word would measure all others each time.
TEST(ValueTable, TellsOfAllItsRowsAtOnce) {
  ValueTable table({"name", "a", "b"});
  table.show();
  int told = 0;
  QObject::connect(table.model(), &QAbstractItemModel::dataChanged, &table, [&] { ++told; });
  const auto rowsOf = [](int count, const QString& word) {
    std::vector<ValueTable::Row> rows;
    for (int row = 0; row < count; ++row) rows.push_back({{QString::number(row), word, word}});
    return rows;
  };
  table.setRows(rowsOf(1000, "1"));
  EXPECT_EQ(told, 1);
  table.setRows(rowsOf(1000, "2"));
  EXPECT_EQ(told, 2);
  EXPECT_EQ(table.topLevelItem(999)->text(0), "999");
  EXPECT_EQ(table.topLevelItem(999)->text(2), "2");
  table.setRows(rowsOf(2, "3"));
  EXPECT_EQ(table.topLevelItemCount(), 2);
  EXPECT_EQ(table.topLevelItem(1)->text(1), "3");
  table.setRows({});
  EXPECT_EQ(table.topLevelItemCount(), 0);
}

TEST_F(Profiler, TimesOnlyWhileItIsShown) {
  EXPECT_FALSE(renderer->last<request::SetProfiling>().on);
  EXPECT_FALSE(window.profiler()->isVisible());
  open();
  EXPECT_TRUE(window.profiler()->isVisible());
  EXPECT_TRUE(renderer->last<request::SetProfiling>().on);
  open();
  EXPECT_FALSE(window.profiler()->isVisible());
  EXPECT_FALSE(renderer->last<request::SetProfiling>().on);
}

// In the smaller of the usual windows.
TEST_F(Profiler, ShowsTheNamesOfPassesWhole) {
  open();
  FrameProfile profile = profileOf(3.0, 4.0);
  profile.passes.insert(profile.passes.begin(), {"Shadows, as the sun sees them", 5.0, 1});
  renderer->tell(profile);
  const ValueTable* passes = window.profiler()->passes();
  // Beside the words: the color, the space behind it, and margins of the cell.
  const int needed = QFontMetrics(secondaryFont()).horizontalAdvance("Shadows, as the sun sees them") +
                     passes->iconSize().width() + 4 + 2 * 4;
  const auto isWhole = [&] { return passes->topLevelItemCount() > 3 && passes->columnWidth(0) >= needed; };
  EXPECT_TRUE(test::waitFor(isWhole, 5000)) << passes->columnWidth(0) << " of " << needed;
}

TEST_F(Profiler, ShowsPassesOfThisFrameTheirMedianAndShare) {
  open();
  for (const int frame : {1, 2, 9}) {
    session.seek(frame);
    settle();
  }
  const ValueTable* table = window.profiler()->passes();
  ASSERT_TRUE(test::waitFor([&] { return table->topLevelItemCount() == 4 && cell(table, 0, 1) == "9.000"; }));
  EXPECT_EQ(cell(table, 0, 0), "G-buffer");
  EXPECT_EQ(cell(table, 0, 2), "2.000");
  EXPECT_EQ(cell(table, 0, 3), "33.3");
  EXPECT_EQ(cell(table, 1, 0), "Resolve");
  EXPECT_EQ(cell(table, 1, 1), "18.00");
  EXPECT_EQ(cell(table, 1, 3), "66.7");
  EXPECT_EQ(cell(table, 3, 0), "All");
  EXPECT_EQ(cell(table, 3, 1), "27.00");
  EXPECT_EQ(cell(table, 3, 2), "6.000");
  const ValueTable* memory = window.profiler()->memory();
  ASSERT_EQ(memory->topLevelItemCount(), 3);
  EXPECT_EQ(cell(memory, 1, 1), "1.00");
  EXPECT_EQ(cell(memory, 2, 1), "3.00");
}

TEST_F(Profiler, NamesKeepSevenLettersOnTheSmallestScreen) {
  window.resize(1024, 600);
  open();
  session.post(request::MeasureStages{});
  session.seek(3);
  settle();
  settle();
  for (const ValueTable* table : window.profiler()->findChildren<ValueTable*>()) {
    ASSERT_GT(table->topLevelItemCount(), 0);
    const QAbstractItemView* view = table; // a tree hides what it asks for
    // On a busy machine layouts come to rest late.
    EXPECT_TRUE(test::waitFor(
        [&] { return table->columnWidth(0) >= std::min(55, view->sizeHintForColumn(0)); }, 5000))
        << table->accessibleName().toStdString();
  }
}

TEST_F(Profiler, StacksThePassesOverTime) {
  open();
  ProfileSeries series;
  series.add(profileOf(1.0, 2.0));
  series.add(profileOf(3.0, 5.0));
  auto* chart = window.profiler()->findChild<ProfileChart*>();
  chart->show(series);
  const std::vector<QList<QPointF>>& edges = chart->edges();
  ASSERT_EQ(edges.size(), 4u) << "three areas";
  EXPECT_EQ(edges[1], (QList<QPointF>{{-2, 1}, {-1, 1}, {-1, 3}, {0, 3}}));
  EXPECT_EQ(edges[2], (QList<QPointF>{{-2, 3}, {-1, 3}, {-1, 8}, {0, 8}}));
}

TEST_F(Profiler, AnAxisIsReadableInALowWindow) {
  open();
  for (const QSize& size : {QSize(1280, 800), QSize(1920, 1080)}) {
    window.resize(size);
    settle();
    const auto* chart = window.profiler()->findChild<ProfileChart*>();
    const std::vector<ChartLabel>& labels = chart->axes().labels();
    EXPECT_EQ(std::ranges::count(labels, "−80", &ChartLabel::text), 1) << size.height();
    EXPECT_GT(chart->axes().plot().height(), 30.0) << size.height();
    for (const ChartLabel& label : labels) {
      EXPECT_TRUE(QRectF(chart->rect()).contains(label.place)) << label.text.toStdString();
      for (const ChartLabel& other : labels)
        EXPECT_TRUE(&other == &label || !other.place.intersects(label.place))
            << label.text.toStdString() << " and " << other.text.toStdString() << " at " << size.height();
    }
  }
}

TEST_F(Profiler, MeasuresStagesByKeyAndByButton) {
  key(Qt::Key_F11, Qt::ShiftModifier);
  const ProfilerPanel* panel = window.profiler();
  EXPECT_TRUE(panel->isVisible());
  ASSERT_TRUE(panel->hasStageCosts());
  const ValueTable* stages = panel->stages();
  ASSERT_EQ(stages->topLevelItemCount(), 6);
  EXPECT_EQ(cell(stages, 0, 0), "Neighborhood");
  EXPECT_EQ(cell(stages, 0, 1), "2.000");
  EXPECT_EQ(cell(stages, 0, 2), "0.250");
  EXPECT_EQ(cell(stages, 0, 3), "50.0");
  EXPECT_EQ(cell(stages, 1, 0), "Blend weight");
  EXPECT_EQ(cell(stages, 1, 1), "in the noise");
  EXPECT_EQ(cell(stages, 1, 2), "0.750");
  EXPECT_EQ(cell(stages, 1, 3), "") << "no share of what is not known";
  EXPECT_EQ(panel->stages()->rows()[1].tip, "not above the noise, ± 0.750 ms");
  EXPECT_EQ(cell(stages, 2, 1), "-1.000");
  EXPECT_EQ(cell(stages, 2, 3), "");
  EXPECT_TRUE(panel->stages()->rows()[2].tip.startsWith("below 0"));
  EXPECT_EQ(cell(stages, 3, 1), "0.000") << "has the cheapest settings";
  EXPECT_EQ(cell(stages, 3, 2), "") << "not measured";
  session.seek(5);
  settle();
  QTest::mouseClick(panel->measureButton(), Qt::LeftButton);
  settle();
  EXPECT_EQ(cell(stages, 4, 0), "All cheapest");
  EXPECT_EQ(cell(stages, 4, 3), "25.0");
  EXPECT_EQ(cell(stages, 5, 0), "All");
  renderer->tell(Work{WorkKind::Stages, "Measuring stages", 1, 99});
  settle();
  EXPECT_FALSE(panel->measureButton()->isEnabled());
  renderer->tell(Work{});
  settle();
  EXPECT_TRUE(panel->measureButton()->isEnabled());
}

TEST_F(Profiler, SaysHowItTimesAndCopiesAsTextAndCsv) {
  renderer->status.driver.renderer = "llvmpipe (test)";
  renderer->status.driver.isSoftware = true;
  key(Qt::Key_F11, Qt::ShiftModifier);
  session.seek(4);
  settle();
  const ProfilerPanel* panel = window.profiler();
  ASSERT_TRUE(test::waitFor([&] { return panel->passes()->topLevelItemCount() == 4; }));
  const QString csv = panel->csv(), text = panel->text();
  EXPECT_TRUE(csv.contains("G-buffer,4.000,4.000,33.3\n")) << csv.toStdString();
  EXPECT_TRUE(csv.contains("Neighborhood,2.000,0.250,50.0\nBlend weight,in the noise,0.750,\n"))
      << csv.toStdString();
  EXPECT_TRUE(csv.contains("\"history, \"\"kept\"\"\",3.00,5\n")) << csv.toStdString();
  EXPECT_TRUE(text.contains("llvmpipe (test)")) << text.toStdString();
  EXPECT_TRUE(text.contains("glFinish")) << text.toStdString();
  QApplication::clipboard()->clear();
  auto* menu = panel->findChild<QWidget*>(QStringLiteral("copyProfile"))->findChild<QMenu*>();
  menu->actions().last()->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), csv);
  menu->actions().first()->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), text);
}

TEST(ProfileSeries, KeepsTheLastFramesAndTheirPasses) {
  ProfileSeries series;
  for (int frame = 0; frame < 200; ++frame) series.add(profileOf(frame, 1.0));
  EXPECT_EQ(series.profiles().size(), kProfiledFrames);
  EXPECT_EQ(series.rows()[0].last, 199.0);
  EXPECT_EQ(series.rows()[0].median, 139.5);
  FrameProfile more = profileOf(0.0, 1.0);
  more.passes.insert(more.passes.begin(), {"Sky", 4.0, 1});
  series.add(more);
  EXPECT_EQ(series.names(), (std::vector<std::string>{"G-buffer", "Resolve", "Sky", "Between the passes"}));
  EXPECT_EQ(series.rows()[2].last, 4.0);
  EXPECT_EQ(series.rows()[2].median, 0.0);
}

namespace {

class StageThumbnails : public test::FakeWindow {
 protected:
  SectionHeader* header(const char* stage) const {
    return window.pipeline()->findChild<SectionHeader*>(QStringLiteral("stage.") + QLatin1String(stage));
  }
};

} // namespace

TEST_F(StageThumbnails, StandInTheHeadingsAndFollowTheFrame) {
  ASSERT_GT(renderer->last<request::SetThumbnails>().width, 0);
  const double ratio = window.devicePixelRatioF();
  EXPECT_LE(renderer->last<request::SetThumbnails>().width, 96 * ratio);
  session.seek(7);
  ASSERT_TRUE(test::waitFor([&] { return window.pipeline()->hasThumbnailsOf(7); }));
  for (const StageInfo& stage : kStages) {
    const SectionHeader* heading = header(std::string(stage.id).c_str());
    const auto row = mainRow(stage.stage);
    ASSERT_EQ(heading->thumbnail().isNull(), !row) << stage.id;
    if (!row) continue;
    EXPECT_EQ(qRed(heading->thumbnail().pixel(0, 0)), static_cast<int>(*row) * 3 + 7) << stage.id;
    EXPECT_TRUE(heading->rect().contains(heading->thumbnailRect())) << stage.id;
  }
}

TEST_F(StageThumbnails, AreClickedToShowTheirRowAndNotToFold) {
  SectionHeader* heading = header("blend_weight");
  const bool wasChecked = heading->isChecked();
  QTest::mouseClick(heading, Qt::LeftButton, {}, heading->thumbnailRect().center());
  settle();
  EXPECT_EQ(window.views()->active()->id(), IntermediateId::alpha);
  EXPECT_EQ(heading->isChecked(), wasChecked);
  QTest::mouseClick(heading, Qt::LeftButton, {}, QPoint(30, heading->height() / 2));
  EXPECT_NE(heading->isChecked(), wasChecked);
}

TEST_F(StageThumbnails, AreNotDrawnWhereNobodySeesThem) {
  key(Qt::Key_F9);
  EXPECT_EQ(renderer->last<request::SetThumbnails>().width, 0);
  key(Qt::Key_F9);
  EXPECT_GT(renderer->last<request::SetThumbnails>().width, 0);
  const int high = header("blend")->height();
  key(Qt::Key_T);
  EXPECT_EQ(renderer->last<request::SetThumbnails>().width, 0);
  EXPECT_LT(header("blend")->height(), high);
  key(Qt::Key_T);
  EXPECT_GT(renderer->last<request::SetThumbnails>().width, 0);
}
