// The size of text: keys, what grows with it, that it is remembered, and that nothing is lost on the way
// back.
#include "app/style/TextSize.h"
#include "app/commands/ThemeSetting.h"
#include "app/dialogs/ReferenceDialog.h"
#include "app/docks/Workspace.h"
#include "app/learn/Learning.h"
#include "app/learn/LessonText.h"
#include "app/learn/PartFrame.h"
#include "app/panels/JitterPanel.h"
#include "app/panels/LeftArea.h"
#include "app/panels/LowerArea.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ScenePanel.h"
#include "app/panels/StatusLine.h"
#include "app/panels/WeightsPanel.h"
#include "app/style/Theme.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/views/ViewPanel.h"
#include "app/views/legend/RangeHistogram.h"
#include "app/views/plots/CurveChart.h"
#include "app/widgets/ChannelButtons.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/ValueTable.h"
#include "app/widgets/bars/ElidedLabel.h"
#include "tests/app/PaintedTexts.h"
#include "tests/app/WindowFixture.h"

#include <QAbstractScrollArea>
#include <QFontMetrics>
#include <QHeaderView>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTextLayout>
#include <QTreeView>

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

using namespace taa::app;
using namespace taa::app::test;

namespace {

using Limits = std::tuple<double, QSize, QSize>;

std::map<const QWidget*, Limits> limitsOf(const QWidget& window) {
  std::map<const QWidget*, Limits> limits;
  for (const QWidget* widget : window.findChildren<QWidget*>())
    if (!widget->objectName().startsWith(QLatin1String("qt_")) &&
        !widget->inherits("QDockWidget")) // Qt sizes them
      limits[widget] = {widget->font().pointSizeF(), widget->minimumSize(), widget->maximumSize()};
  return limits;
}

} // namespace

class TextSizeTest : public FakeWindow {
 protected:
  void larger() { key(Qt::Key_Plus, Qt::ControlModifier); }
  void smaller() { key(Qt::Key_Minus, Qt::ControlModifier); }
  void TearDown() override { window.setTextPercent(100); }
};

TEST_F(TextSizeTest, KeysGoFromOneHundredToTwoHundredPercentAndNoFurther) {
  for (const int percent : {125, 150, 175, 200, 200}) {
    larger();
    EXPECT_EQ(textPercent(), percent);
  }
  EXPECT_DOUBLE_EQ(QApplication::font().pointSizeF(), 20.0);
  EXPECT_DOUBLE_EQ(secondaryFont().pointSizeF(), 18.0);
  EXPECT_EQ(rowHeight(), 44);
  EXPECT_EQ(window.statusLine()->height(), 48);
  EXPECT_EQ(window.views()->view(0)->header()->height(), 56);
  for (const int percent : {175, 150, 125, 100, 100}) {
    smaller();
    EXPECT_EQ(textPercent(), percent);
  }
}

TEST_F(TextSizeTest, ThereAndBackEverythingIsAsItWas) {
  const auto before = limitsOf(window);
  for (int step = 0; step < 4; ++step) larger();
  EXPECT_NE(limitsOf(window), before);
  for (int step = 0; step < 4; ++step) smaller();
  const auto after = limitsOf(window);
  for (const auto& [widget, limits] : before) {
    const auto found = after.find(widget);
    ASSERT_NE(found, after.end());
    EXPECT_EQ(found->second, limits) << widget->metaObject()->className() << ' '
                                     << widget->objectName().toStdString();
  }
}

TEST_F(TextSizeTest, AtTwoHundredPercentAWindowOf1280By800HoldsAllThatItShows) {
  window.views()->setViewCount(2);
  session.probes().setPixel(glm::ivec2(20, 10));
  window.setTextPercent(200);
  settle();
  ASSERT_EQ(window.size(), QSize(1280, 800)) << "it fits";
  const auto outside = [&] {
    std::string names;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->isWindow() || isScrolled(widget)) continue;
      if (window.rect().contains(QRect(widget->mapTo(&window, QPoint()), widget->size()))) continue;
      names +=
          std::string(widget->metaObject()->className()) + ' ' + widget->objectName().toStdString() + '\n';
    }
    return names;
  };
  // On a busy machine layouts come to rest later than a window settles elsewhere.
  EXPECT_TRUE(waitFor([&] { return outside().empty(); }, 5000)) << outside();
  for (const auto* button : window.findChildren<QPushButton*>()) {
    if (!button->isVisible() || isScrolled(button)) continue;
    EXPECT_GE(button->width(), button->fontMetrics().horizontalAdvance(button->text()))
        << button->text().toStdString();
  }
}

TEST_F(TextSizeTest, AtTwoHundredPercentALessonIsReadBesideTheProbeInAWindowOf1280By800) {
  window.views()->setViewCount(2);
  window.setTextPercent(200);
  settle();
  key(Qt::Key_F12);
  session.probes().setPixel(glm::ivec2(20, 10));
  settle();
  EXPECT_EQ(window.size(), QSize(1280, 800)) << "it fits";
  for (const ProbeTab tab : {ProbeTab::ColorSpace, ProbeTab::WhatIf, ProbeTab::Values}) {
    window.probe()->setTab(tab);
    settle();
    EXPECT_EQ(window.size(), QSize(1280, 800)) << "it fits with tab " << static_cast<int>(tab);
  }
  const auto* text = window.findChild<LessonText*>();
  ASSERT_TRUE(text && text->isVisible());
  EXPECT_GE(text->viewport()->height(), 4 * text->fontMetrics().lineSpacing());

  // What is surrounded is what of the probe is seen.
  window.findChild<Learning*>()->openStep(QStringLiteral("first-ghost"), 3);
  settle();
  session.probes().setPixel(glm::ivec2(20, 10));
  settle();
  const auto* frame = window.findChild<PartFrame*>();
  ASSERT_TRUE(frame && frame->isVisible());
  const QWidget* area = window.probe()->parentWidget();
  ASSERT_LT(area->height(), window.probe()->height());
  EXPECT_EQ(frame->geometry(), QRect(area->mapTo(&window, QPoint()), area->size()));
}

TEST_F(TextSizeTest, AtTwoHundredPercentSomeLinesOfALessonAreReadAboveAPageBelowTheViews) {
  window.setTextPercent(200);
  settle();
  auto* const learning = window.findChild<Learning*>();
  // A page alone; with a probe.
  for (const auto& [lesson, step] : {std::pair("jitter", 3), std::pair("alpha", 1), std::pair("alpha", 3)}) {
    learning->openStep(QLatin1String(lesson), step);
    settle();
    EXPECT_TRUE(window.lower()->isVisible());
    const auto* text = window.findChild<LessonText*>();
    const auto lines = [&] { return text->viewport()->height() / text->fontMetrics().lineSpacing(); };
    EXPECT_TRUE(waitFor([&] { return lines() >= 3; })) << lesson << " " << step << ": " << lines();
  }
}

TEST_F(TextSizeTest, ALessonIsReadAsWellWhenTextsGrowWhileItIsOpen) {
  auto* const learning = window.findChild<Learning*>();
  learning->openStep(QStringLiteral("first-ghost"), 4);
  settle();
  session.probes().setPixel(glm::ivec2(20, 10));
  settle();
  window.setTextPercent(200);
  settle();
  const auto* text = window.findChild<LessonText*>();
  EXPECT_TRUE(waitFor([&] { return text->viewport()->height() >= 4 * text->fontMetrics().lineSpacing(); }))
      << text->viewport()->height();
}

TEST_F(TextSizeTest, WhatIsSurroundedIsSurroundedWhereItHasGone) {
  window.setTextPercent(200);
  window.findChild<Learning*>()->openStep(QStringLiteral("first-ghost"), 3);
  settle();
  const auto* frame = window.findChild<PartFrame*>();
  ASSERT_TRUE(frame && frame->isVisible());
  for (const int width : {1280, 1400, 1300}) {
    window.resize(width, 800);
    settle();
    const QWidget* area = window.probe()->parentWidget();
    EXPECT_TRUE(waitFor([&] {
      return frame->geometry() == QRect(area->mapTo(&window, QPoint()), area->size());
    })) << width;
  }
}

TEST_F(TextSizeTest, AtTwoHundredPercentNoStepMakesTheWindowWider) {
  window.setTextPercent(200);
  settle();
  auto* const learning = window.findChild<Learning*>();
  // The last one of a lesson, whose button has two words; one whose fault the last line names.
  for (const auto& [lesson, step] : {std::pair("first-ghost", 8), std::pair("reprojection", 6)}) {
    learning->openStep(QLatin1String(lesson), step);
    settle();
    EXPECT_EQ(window.size(), QSize(1280, 800)) << lesson;
  }
}

TEST_F(TextSizeTest, AtTwoHundredPercentALessonHasTheRoomOfAnEmptyProbe) {
  window.setTextPercent(200);
  settle();
  session.probes().removeAll();
  key(Qt::Key_F12);
  settle();
  const auto* text = window.findChild<LessonText*>();
  ASSERT_TRUE(text && text->isVisible());
  const double line = 1.35 * text->fontMetrics().lineSpacing();
  EXPECT_GE(text->viewport()->height(), 7 * line);
  window.findChild<LowerArea*>()->setShown(LowerPage::Jitter, true);
  window.findChild<Workspace*>()->shareSide();
  settle();
  EXPECT_GE(text->viewport()->height(), 2 * text->fontMetrics().lineSpacing());
}

TEST_F(TextSizeTest, AWindowThatOpensAtTwoHundredPercentHasRoomForCurves) {
  window.setTextPercent(200);
  Session shown([](taa::Listener listener) { return std::make_unique<FakeRenderer>(std::move(listener)); });
  TestWindow large(shown, nullptr);
  large.resize(1920, 1080);
  large.show();
  large.openSource("builtin:fan");
  shown.probes().setPixel(glm::ivec2(20, 10));
  settle();
  for (const LowerPage page : {LowerPage::Plots, LowerPage::Weights}) {
    large.lower()->setShown(page, true);
    settle();
    EXPECT_EQ(large.size(), QSize(1920, 1080)) << "it fits";
    EXPECT_GE(large.lower()->height(), 280) << "its tabs lie above it";
    EXPECT_GE(large.views()->height(), 300) << "the views keep theirs";
  }
}

TEST_F(TextSizeTest, AtTwoHundredPercentPagesBelowKeepTheirCurvesAndColumns) {
  session.probes().setPixel(glm::ivec2(20, 10));
  window.setTextPercent(200);
  settle();
  window.lower()->setShown(LowerPage::Weights, true);
  settle();
  EXPECT_EQ(window.size(), QSize(1280, 800)) << "it fits";
  // On a busy machine layouts come to rest late.
  for (const CurveChart* chart : {window.weights()->weights(), window.weights()->samples()})
    EXPECT_TRUE(waitFor([&] { return chart->height() >= chart->minimumSizeHint().height(); }, 5000))
        << chart->height() << " of " << chart->minimumSizeHint().height();
  window.lower()->setShown(LowerPage::Jitter, true);
  settle();
  EXPECT_EQ(window.size(), QSize(1280, 800)) << "it fits";
  const ValueTable& table = *window.jitter()->table();
  EXPECT_TRUE(waitFor([&] { return table.header()->length() <= table.viewport()->width(); }, 5000));
  for (int column = 0; column < table.columnCount(); ++column) {
    const int needed = table.header()->fontMetrics().horizontalAdvance(table.headerItem()->text(column));
    EXPECT_GE(table.header()->sectionSize(column), needed) << column;
  }
}

TEST_F(TextSizeTest, AtTwoHundredPercentEachPageBelowFitsWithTwoViewsAndAProbe) {
  window.views()->setViewCount(2);
  session.probes().setPixel(glm::ivec2(20, 10));
  window.setTextPercent(200);
  for (int frame = 1; frame <= 3; ++frame) session.seek(frame); // what the probe measured is drawn, too
  settle();
  for (int page = 0; page < kLowerPageCount; ++page) {
    SCOPED_TRACE(lowerPageId(static_cast<LowerPage>(page)).toStdString());
    window.lower()->setShown(static_cast<LowerPage>(page), true);
    settle();
    EXPECT_TRUE(waitFor([&] { return window.size() == QSize(1280, 800); }, 5000)) << window.height();
    for (const QLabel* label : window.findChildren<QLabel*>()) {
      if (!label->isVisible()) continue;
      EXPECT_FALSE(label->text().endsWith(QChar(0x2026))) << label->text().toStdString();
    }
  }
}

TEST_F(TextSizeTest, AtTwoHundredPercentAHistogramStaysInItsView) {
  window.views()->setViewCount(4);
  for (const int percent : {200, 100}) {
    window.setTextPercent(percent);
    settle();
    window.views()->view(0)->setHistogramShown(true);
    settle();
    const auto* histogram = window.views()->view(0)->findChild<RangeHistogram*>();
    ASSERT_TRUE(histogram && histogram->isVisible());
    EXPECT_LT(histogram->geometry().right(), histogram->parentWidget()->width()) << percent;
  }
}

TEST_F(TextSizeTest, WhatIsBehindTheButtonOfANarrowHeaderHasLargeLetters) {
  window.views()->setViewCount(4);
  window.setTextPercent(200);
  settle();
  ViewHeader* header = window.views()->view(0)->header();
  const auto* channels = header->findChild<ChannelButtons*>();
  ASSERT_TRUE(channels && !channels->isVisible());
  QTest::mouseClick(header->findChild<QWidget*>(QStringLiteral("more")), Qt::LeftButton);
  settle();
  ASSERT_TRUE(channels->isVisible());
  EXPECT_DOUBLE_EQ(channels->font().pointSizeF(), 18.0);
  channels->parentWidget()->hide();
  settle();
  EXPECT_EQ(channels->parentWidget(), header);
  EXPECT_DOUBLE_EQ(channels->font().pointSizeF(), 18.0) << "back in the header";
}

TEST_F(TextSizeTest, AtTwoHundredPercentThePageOfTheManualIsWiderThanTheListOfPages) {
  window.setTextPercent(200);
  key(Qt::Key_F1);
  const auto* dialog = window.findChild<ReferenceDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_GT(dialog->findChild<QTextBrowser*>()->width(), dialog->findChild<QListWidget*>()->width());
  delete dialog;
}

TEST_F(TextSizeTest, AtTwoHundredPercentTablesOfTheManualBreakLinesBetweenWords) {
  window.resize(1280, 800);
  window.setTextPercent(200);
  key(Qt::Key_F1);
  const auto* dialog = window.findChild<ReferenceDialog*>();
  ASSERT_TRUE(dialog);
  auto* pages = dialog->findChild<QListWidget*>();
  pages->setCurrentItem(pages->findItems("Glossary", Qt::MatchExactly).value(0));
  // Its lines have their places some time after.
  EXPECT_TRUE(waitFor(
      [&] { return dialog->findChild<QTextBrowser*>()->horizontalScrollBar()->maximum() == 0; }, 20000))
      << "it fits";
  const QTextDocument* document = dialog->findChild<QTextBrowser*>()->document();
  int broken = 0, lines = 0;
  for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
    const QTextLayout* layout = block.layout();
    for (int line = 0; line + 1 < layout->lineCount(); ++line, ++lines) {
      const QTextLine broke = layout->lineAt(line);
      const int end = broke.textStart() + broke.textLength();
      if (block.text()[end - 1].isLetter() && block.text()[end].isLetter()) ++broken;
    }
  }
  EXPECT_EQ(broken, 0);
  EXPECT_GT(lines, 100);
  const auto* list = dialog->findChild<QListWidget*>();
  for (int row = 0; row < list->count(); ++row) {
    const QRect place = list->visualItemRect(list->item(row)).adjusted(8, 3, -8, -3); // its padding
    const QRect text = list->fontMetrics().boundingRect(place, Qt::TextWordWrap, list->item(row)->text());
    EXPECT_LE(text.height(), place.height()) << list->item(row)->text().toStdString();
  }
  delete dialog;
}

TEST_F(TextSizeTest, CommandsGrowWithTheirTextsAndStayInTheWindow) {
  window.setTextPercent(200);
  key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  auto* chooser = window.findChild<Chooser*>();
  ASSERT_TRUE(chooser);
  EXPECT_EQ(chooser->width(), 960);
  EXPECT_LE(chooser->geometry().right(), window.geometry().right());
  chooser->close();
}

TEST_F(TextSizeTest, AnotherThemeLeavesTheTitleWhole) {
  window.setTextPercent(200);
  window.setTheme(ThemeChoice::Light);
  settle();
  const auto* title = static_cast<const ElidedLabel*>(window.menuBar()->cornerWidget());
  EXPECT_EQ(title->text(), title->whole());
  EXPECT_GE(title->width(), title->fontMetrics().horizontalAdvance(title->whole()));
  window.setTheme(ThemeChoice::Dark);
}

TEST_F(TextSizeTest, TheMotionOfAnObjectIsReadInLargeText) {
  window.left()->openPage(LeftPage::Scene);
  window.setTextPercent(200);
  settle();
  const auto* tree = window.scene()->findChild<QTreeView*>(QStringLiteral("sceneTree"));
  const int column = 1; // what the renderer is told of motion
  QFont bold = tree->font();
  bold.setBold(true);
  EXPECT_GE(tree->header()->sectionSize(column),
            QFontMetrics(bold).horizontalAdvance(QStringLiteral("Per object")));
}

TEST_F(TextSizeTest, RowsOfTheProbeAreAsHighAsTheirLines) {
  session.probes().setPixel(glm::ivec2(20, 10));
  window.setTextPercent(200);
  settle();
  const QTreeView* table = nullptr;
  for (const QTreeView* each : window.probe()->findChildren<QTreeView*>())
    if (each->accessibleName() == QLatin1String("Every intermediate at the pixel")) table = each;
  ASSERT_TRUE(table);
  const QAbstractItemModel& model = *table->model();
  const QModelIndex color = model.index(0, 1, model.index(0, 0));
  EXPECT_GE(table->visualRect(color).height(), 3 * QFontMetrics(numberFont()).lineSpacing()) << "R, G, B";
}

TEST_F(TextSizeTest, IsRememberedWhereItIsSet) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  ThemeSetting first(&settings, nullptr);
  first.setTextPercent(150);
  first.showTextPercent(175);
  first.showTextPercent(100);
  ThemeSetting second(&settings, nullptr);
  second.restoreTextSize();
  EXPECT_EQ(textPercent(), 150) << "not what was only shown";
}
