// No text is cut off and nothing overlaps at the sizes the window is made for.
#include "app/panels/LeftArea.h"
#include "app/panels/LowerArea.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/widgets/bars/WorkBar.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "app/widgets/parameters/ParameterLabel.h"
#include "app/widgets/parameters/SegmentedButtons.h"
#include "tests/app/WindowFixture.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QSplitterHandle>
#include <QTabBar>

#include <string>
#include <utility>

using namespace taa;
using namespace taa::app;

namespace {

std::string nameOf(const QWidget* widget) {
  const auto* label = qobject_cast<const QLabel*>(widget);
  return std::string(widget->metaObject()->className()) + " " + widget->objectName().toStdString() +
         (label ? " \"" + label->text().toStdString() + "\"" : "");
}

/// The width a widget needs for its text; 0: any will do.
int neededWidth(const QWidget* widget) {
  if (const auto* label = qobject_cast<const QLabel*>(widget))
    return label->wordWrap() ? 0 : label->fontMetrics().horizontalAdvance(label->text());
  if (const auto* button = qobject_cast<const QPushButton*>(widget))
    return button->fontMetrics().horizontalAdvance(QString(button->text()).remove('&'));
  if (qobject_cast<const ChoiceButton*>(widget) || qobject_cast<const ParameterLabel*>(widget))
    return widget->sizeHint().width();
  return 0;
}

/// Every tab is whole and in sight, none behind arrows.
void expectWholeTabs(const QTabBar& bar) {
  for (int tab = 0; tab < bar.count(); ++tab) {
    if (!bar.isTabVisible(tab)) continue;
    const QRect place = bar.tabRect(tab);
    EXPECT_GE(place.width(), bar.fontMetrics().horizontalAdvance(bar.tabText(tab)))
        << bar.tabText(tab).toStdString();
    EXPECT_TRUE(place.left() >= 0 && place.right() < bar.width()) << bar.tabText(tab).toStdString();
  }
}

/// Every column has room for its title, and none lies beyond the edge of a table that cannot be scrolled
/// there.
void expectWholeColumns(const QHeaderView& header) {
  const auto* table = qobject_cast<const QAbstractScrollArea*>(header.parentWidget());
  if (!table || header.orientation() != Qt::Horizontal) return;
  const QAbstractItemModel& model = *header.model();
  for (int column = 0; column < header.count(); ++column) {
    const std::string title =
        model.headerData(column, Qt::Horizontal).toString().toStdString() + " in " + nameOf(table);
    if (header.isSectionHidden(column)) continue;
    EXPECT_GE(header.sectionSize(column),
              header.fontMetrics().horizontalAdvance(model.headerData(column, Qt::Horizontal).toString()))
        << title;
    if (table->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) continue;
    EXPECT_LE(header.sectionViewportPosition(column) + header.sectionSize(column), table->viewport()->width())
        << title;
  }
}

void expectNothingIsCut(const QWidget& window) {
  // A text may have come a moment ago, and its place be on its way.
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    if (const auto* bar = qobject_cast<const QTabBar*>(widget)) expectWholeTabs(*bar);
    if (const auto* header = qobject_cast<const QHeaderView*>(widget)) expectWholeColumns(*header);
    EXPECT_GE(widget->width(), neededWidth(widget)) << nameOf(widget);
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      EXPECT_FALSE(label->text().endsWith(QChar(0x2026))) << nameOf(widget) << " is cut";
    }
    if (const auto* label = qobject_cast<const QLabel*>(widget); label && label->wordWrap()) {
      EXPECT_GE(label->height(), label->heightForWidth(label->width())) << nameOf(widget);
    }
    if (const auto* buttons = qobject_cast<const SegmentedButtons*>(widget)) {
      EXPECT_GE(buttons->height(), buttons->heightForWidth(buttons->width())) << nameOf(widget);
    }
    if (widget->parentWidget() == &window || !widget->parentWidget()->inherits("taa::app::ParameterRow"))
      continue;
    EXPECT_LE(widget->geometry().right(), widget->parentWidget()->width()) << nameOf(widget);
  }
}

void expectNoOverlap(const QWidget& window) {
  for (const QWidget* parent : window.findChildren<QWidget*>()) {
    if (!parent->isVisible()) continue;
    const auto children = parent->findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
    for (const QWidget* a : children)
      for (const QWidget* b : children) {
        const auto counts = [](const QWidget* widget) {
          return widget->isVisible() && !widget->isWindow() && !qobject_cast<const WorkBar*>(widget) &&
                 !qobject_cast<const QSplitterHandle*>(widget);
        };
        if (a >= b || !counts(a) || !counts(b)) continue;
        EXPECT_FALSE(a->geometry().intersects(b->geometry()))
            << nameOf(a) << " and " << nameOf(b) << " in " << nameOf(parent);
      }
  }
}

/// The smallest screen it is made for, logical px.
constexpr QSize kSmallestScreen(1024, 600);

class Layout : public test::FakeWindow, public testing::WithParamInterface<std::pair<int, int>> {};

} // namespace

TEST_P(Layout, CutsNoTextAndOverlapsNothing) {
  window.resize(GetParam().first, GetParam().second);
  window.pipeline()->setAllExpanded(true);
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  settle();
  expectNothingIsCut(window);
  expectNoOverlap(window);
}

TEST_P(Layout, CutsNoTextAndOverlapsNothingWithTheProfiler) {
  window.resize(GetParam().first, GetParam().second);
  renderer->status.driver.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
  renderer->status.driver.isSoftware = true;
  window.lower()->setShown(LowerPage::Profiler, true);
  session.post(request::MeasureStages{});
  session.seek(3);
  settle();
  settle();
  expectNothingIsCut(window);
  expectNoOverlap(window);
}

TEST_P(Layout, CutsNoTextAndOverlapsNothingWithAnyPage) {
  window.resize(GetParam().first, GetParam().second);
  window.left()->openPage(LeftPage::Scene);
  session.probes().setPixel(glm::ivec2(12, 7));
  for (int page = 0; page < kLowerPageCount; ++page) {
    SCOPED_TRACE(lowerPageId(static_cast<LowerPage>(page)).toStdString());
    window.lower()->setShown(static_cast<LowerPage>(page), true);
    settle();
    settle();
    expectNothingIsCut(window);
    expectNoOverlap(window);
  }
}

using SmallScreen = test::FakeWindow;

TEST_F(SmallScreen, HoldsTheWindowWithEachOfItsPages) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  for (int page = 0; page < kLowerPageCount; ++page)
    for (const ProbeTab tab : {ProbeTab::Values, ProbeTab::ColorSpace, ProbeTab::WhatIf}) {
      window.lower()->setShown(static_cast<LowerPage>(page), true);
      window.probe()->setTab(tab);
      window.resize(kSmallestScreen);
      settle();
      const std::string where = lowerPageId(static_cast<LowerPage>(page)).toStdString() + " " +
                                std::to_string(static_cast<int>(tab));
      EXPECT_EQ(window.width(), kSmallestScreen.width()) << where;
      EXPECT_EQ(window.height(), kSmallestScreen.height()) << where;
    }
}

// A long name of what is open would hide the last menus.
TEST_F(SmallScreen, KeepsAllMenusBesideWhatIsOpen) {
  renderer->status.source = "a model of " + std::string(150, 'x') + " letters and longer still.glb";
  renderer->deliver();
  settle();
  const QMenuBar& bar = *window.menuBar();
  for (const int width : {1024, 1280, 1024}) {
    window.resize(width, 600);
    settle();
    const auto* title = bar.cornerWidget();
    for (QAction* menu : bar.actions()) {
      const QRect place = bar.actionGeometry(menu);
      EXPECT_GT(place.width(), 0) << menu->text().toStdString();
      EXPECT_LT(place.right(), title->x()) << menu->text().toStdString() << " " << width;
    }
    EXPECT_GT(title->width(), 100) << "there is room for some of it";
    EXPECT_LE(title->geometry().right(), bar.width());
    EXPECT_TRUE(title->toolTip().contains("longer still")) << "its tip has the rest";
  }
}

TEST_F(SmallScreen, HoldsTheDialogs) {
  window.resize(kSmallestScreen);
  settle();
  const std::pair<Qt::Key, Qt::KeyboardModifier> keys[] = {
      {Qt::Key_F1, Qt::NoModifier}, {Qt::Key_F5, Qt::ShiftModifier}, {Qt::Key_Question, Qt::NoModifier}};
  for (const auto& [with, modifier] : keys) {
    key(with, modifier);
    int shown = 0;
    for (QDialog* dialog : window.findChildren<QDialog*>()) {
      if (!dialog->isVisible()) continue;
      ++shown;
      EXPECT_LE(dialog->width(), kSmallestScreen.width()) << dialog->windowTitle().toStdString();
      EXPECT_LE(dialog->height(), kSmallestScreen.height()) << dialog->windowTitle().toStdString();
      dialog->close();
    }
    EXPECT_EQ(shown, 1) << with;
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Layout,
                         testing::Values(std::pair(1024, 600), std::pair(1280, 800), std::pair(1920, 1080),
                                         std::pair(1600, 900)),
                         [](const auto& size) { return std::to_string(size.param.first); });
