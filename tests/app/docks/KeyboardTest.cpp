// Without a mouse: every panel, control, menu and dialog is reached and left by keys, and undo works wherever
// the focus is.
#include "app/docks/PanelDock.h"
#include "app/panels/LeftArea.h"
#include "app/panels/LowerArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/views/ViewArea.h"
#include "app/widgets/SearchField.h"
#include "app/window/Dialogs.h"
#include "tests/app/WindowFixture.h"

#include <QAbstractScrollArea>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QWindow>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

bool isControl(const QWidget* widget) {
  const auto* area = qobject_cast<const QAbstractScrollArea*>(widget->parentWidget());
  if (area && area->viewport() == widget) return false; // the area speaks for it
  return widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0 &&
         !widget->focusProxy();
}

std::set<const QWidget*> controlsOf(const QWidget* window) {
  std::set<const QWidget*> controls;
  for (const QWidget* widget : window->findChildren<QWidget*>())
    if (widget->window() == window && isControl(widget)) controls.insert(widget);
  return controls;
}

std::string wayTo(const QWidget* widget) {
  std::string text;
  for (const QWidget* at = widget; at && !at->isWindow(); at = at->parentWidget())
    text += std::string(at->metaObject()->className()) + "(" + at->objectName().toStdString() + ") ";
  return text;
}

class Keyboard : public test::FakeWindow {
 protected:
  void SetUp() override {
    test::FakeWindow::SetUp();
    session.probes().setPixel(glm::ivec2(12, 7));
    settle();
  }

  /// What the Tab key reaches, from what has the focus until it is there again.
  std::set<const QWidget*> tabbed(QWidget* top) {
    std::set<const QWidget*> reached;
    for (int presses = 0; presses < 600; ++presses) {
      QWidget* focus = QApplication::focusWidget();
      if (!focus || !reached.insert(focus).second) break;
      QTest::keyClick(top->windowHandle(), Qt::Key_Tab);
    }
    return reached;
  }
  void expectTabReachesAll(QWidget* top) {
    const std::set<const QWidget*> controls = controlsOf(top), reached = tabbed(top);
    for (const QWidget* control : controls) EXPECT_TRUE(reached.contains(control)) << wayTo(control);
  }
  /// Down through a menu and into its submenus; every entry that can be chosen is come by.
  void walk(QMenu* menu) {
    std::set<const QAction*> met;
    for (int presses = 0; presses < 200; ++presses) {
      QTest::keyClick(menu, Qt::Key_Down);
      const QAction* now = menu->activeAction();
      if (!now || !met.insert(now).second) break;
      if (!now->menu() || now->menu()->isEmpty()) continue;
      QTest::keyClick(menu, Qt::Key_Right);
      ASSERT_TRUE(now->menu()->isVisible()) << now->text().toStdString();
      walk(now->menu());
      QTest::keyClick(now->menu(), Qt::Key_Left);
      EXPECT_FALSE(now->menu()->isVisible()) << now->text().toStdString();
    }
    for (const QAction* action : menu->actions())
      if (action->isEnabled() && action->isVisible() && !action->isSeparator()) {
        EXPECT_TRUE(met.contains(action)) << action->text().toStdString();
      }
  }
  std::vector<QWidget*> opened(const QList<QWidget*>& before) {
    std::vector<QWidget*> found;
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (!before.contains(widget) && widget->isVisible()) found.push_back(widget);
    return found;
  }
};

constexpr auto kControl = Qt::ControlModifier;

} // namespace

TEST_F(Keyboard, TabReachesEveryControlOfTheWindow) {
  for (int page = 0; page < kLowerPageCount; ++page) {
    window.left()->openPage(page % 2 == 0 ? LeftPage::Pipeline : LeftPage::Scene);
    window.probe()->setTab(static_cast<ProbeTab>(page % 3));
    window.lower()->setShown(static_cast<LowerPage>(page), true);
    settle();
    window.views()->activate(0);
    SCOPED_TRACE(lowerPageId(static_cast<LowerPage>(page)).toStdString());
    expectTabReachesAll(&window);
  }
}

TEST_F(Keyboard, TabReachesEveryControlOfAPanelInAWindowOfItsOwnAndOfWhatIsLeft) {
  auto* dock = window.findChild<PanelDock*>("probe");
  dock->setFloating(true);
  settle();
  dock->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(dock));
  ASSERT_FALSE(controlsOf(dock).empty());
  (*window.probe()->findChildren<QTabBar*>().begin())->setFocus();
  expectTabReachesAll(dock);
  dock->setFloating(false);
  window.activateWindow();
  settle();
  window.views()->activate(0);
  expectTabReachesAll(&window);
}

TEST_F(Keyboard, OneKeyGoesFromPanelToPanelAndComesBackToWhereOneWas) {
  window.lower()->setShown(LowerPage::Plots, true);
  settle();
  const std::vector<const QWidget*> panels{window.views(),
                                           window.findChild<PanelDock*>("probe"),
                                           window.findChild<PanelDock*>("lower"),
                                           window.timeline(),
                                           window.messages(), // a hint that can be closed
                                           window.findChild<PanelDock*>("left")};
  window.pipeline()->searchField()->setFocus();
  window.views()->activate(1);
  for (std::size_t step = 1; step <= panels.size(); ++step) {
    key(Qt::Key_Tab, kControl);
    const QWidget* wanted = panels[step % panels.size()];
    EXPECT_TRUE(wanted->isAncestorOf(QApplication::focusWidget())) << step;
    if (wanted == panels.back()) {
      EXPECT_EQ(QApplication::focusWidget(), window.pipeline()->searchField());
    }
  }
  EXPECT_EQ(window.views()->activeIndex(), 1);
  for (std::size_t step = panels.size(); step-- > 0;) {
    key(Qt::Key_Tab, kControl | Qt::ShiftModifier);
    EXPECT_TRUE(panels[step]->isAncestorOf(QApplication::focusWidget())) << step;
  }
}

TEST_F(Keyboard, OneKeyAlsoGoesToAPanelInAWindowOfItsOwn) {
  auto* dock = window.findChild<PanelDock*>("probe");
  dock->setFloating(true);
  settle();
  window.activateWindow();
  settle();
  window.views()->activate(0);
  key(Qt::Key_Tab, kControl);
  EXPECT_TRUE(dock->isAncestorOf(QApplication::focusWidget())) << wayTo(QApplication::focusWidget());
  QTest::keyClick(dock->windowHandle(), Qt::Key_Tab, kControl);
  settle();
  EXPECT_TRUE(window.timeline()->isAncestorOf(QApplication::focusWidget()))
      << wayTo(QApplication::focusWidget());
}

TEST_F(Keyboard, UndoWorksWhereverTheFocusIs) {
  int tried = 0;
  for (int page = 0; page < kLowerPageCount; ++page) {
    window.left()->openPage(page % 2 == 0 ? LeftPage::Pipeline : LeftPage::Scene);
    window.probe()->setTab(static_cast<ProbeTab>(page % 3));
    window.lower()->setShown(static_cast<LowerPage>(page), true);
    settle();
    for (const QWidget* control : controlsOf(&window)) {
      auto* widget = const_cast<QWidget*>(control);
      const float before = session.presets().settings().weight.alpha;
      session.presets().setParameter("weight.alpha", 0.5);
      widget->setFocus(Qt::TabFocusReason);
      if (QApplication::focusWidget() != widget) {
        session.undo();
        continue;
      }
      QTest::keyClick(window.windowHandle(), Qt::Key_Z, kControl);
      ASSERT_EQ(session.presets().settings().weight.alpha, before) << wayTo(widget);
      ++tried;
    }
  }
  EXPECT_GT(tried, 200);
}

TEST_F(Keyboard, EveryMenuIsOpenedByItsLetterAndWalkedThrough) {
  for (const QAction* entry : window.menuBar()->actions()) {
    const qsizetype mark = entry->text().indexOf('&');
    ASSERT_GE(mark, 0) << entry->text().toStdString();
    const auto letter = static_cast<Qt::Key>(entry->text()[mark + 1].toUpper().unicode());
    SCOPED_TRACE(entry->text().toStdString());
    key(letter, Qt::AltModifier);
    ASSERT_TRUE(entry->menu()->isVisible());
    walk(entry->menu());
    QTest::keyClick(entry->menu(), Qt::Key_Escape);
    if (window.menuBar()->activeAction()) key(Qt::Key_Escape);
    settle();
    EXPECT_FALSE(entry->menu()->isVisible());
  }
}

TEST_F(Keyboard, EveryDialogIsWalkedThroughByTabAndLeftByEsc) {
  int walked = 0;
  for (const std::string& name : dialogNames()) {
    SCOPED_TRACE(name);
    const QList<QWidget*> before = QApplication::topLevelWidgets();
    window.openDialog(name);
    settle();
    for (QWidget* dialog : opened(before)) {
      dialog->activateWindow();
      settle();
      if (!dialog->isAncestorOf(QApplication::focusWidget())) dialog->setFocus();
      if (!controlsOf(dialog).empty() && dialog->windowType() != Qt::Popup) {
        ASSERT_TRUE(dialog->isAncestorOf(QApplication::focusWidget()));
        expectTabReachesAll(dialog);
      }
      QTest::keyClick(QApplication::activePopupWidget() ? QApplication::activePopupWidget() : dialog,
                      Qt::Key_Escape);
      settle();
      EXPECT_TRUE(!QApplication::topLevelWidgets().contains(dialog) || !dialog->isVisible());
      ++walked;
    }
    for (QWidget* left : opened(before)) left->close();
    window.activateWindow();
    settle();
  }
  EXPECT_GE(walked, 8);
}
