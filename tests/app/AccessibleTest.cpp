// Who cannot see the window or has no mouse: names for screen readers, the way of the Tab key.
#include "tests/app/WindowFixture.h"

#include "app/panels/LeftArea.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ScenePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/views/ViewArea.h"
#include "app/widgets/SearchField.h"

#include <QAbstractScrollArea>
#include <QAccessible>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTabWidget>

#include <set>
#include <string>
#include <vector>

namespace taa::app::test {
namespace {

using AccessibleTest = FakeWindow;

bool takesFocus(const QWidget* widget) {
  const auto* area = qobject_cast<const QAbstractScrollArea*>(widget->parentWidget());
  if (area && area->viewport() == widget) return false; // the area speaks for it
  return (widget->focusPolicy() & Qt::TabFocus) != 0 && !widget->focusProxy();
}

std::string described(const QWidget* widget) {
  std::string text;
  for (const QWidget* at = widget; at && !at->isWindow(); at = at->parentWidget())
    text += std::string(at->metaObject()->className()) + "(" + at->objectName().toStdString() + ") ";
  return text;
}

/// Every control of `window` has a name that a screen reader can say.
void expectNames(const QWidget* window) {
  for (const QWidget* widget : window->findChildren<QWidget*>()) {
    if (!takesFocus(widget) || widget->isWindow()) continue;
    const QAccessibleInterface* voice = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
    ASSERT_NE(voice, nullptr) << described(widget);
    EXPECT_FALSE(voice->text(QAccessible::Name).trimmed().isEmpty()) << described(widget);
  }
}

TEST_F(AccessibleTest, EveryControlOfTheWindowHasAName) {
  for (const bool shows : {false, true}) {
    window.left()->openPage(shows ? LeftPage::Scene : LeftPage::Pipeline);
    settle();
    expectNames(&window);
  }
}

// Whatever a command opens: each one is asked for once, and what it opened is looked at and closed.
TEST_F(AccessibleTest, EveryControlOfADialogHasAName) {
  std::set<std::string> seen;
  std::vector<QAction*> actions;
  const auto collect = [&](const auto& self, const QList<QAction*>& list) -> void {
    for (QAction* action : list)
      if (action->menu())
        self(self, action->menu()->actions());
      else if (action->text().contains(QStringLiteral("…")) || action->shortcut() == QKeySequence("?") ||
               action->shortcut() == QKeySequence("F1"))
        actions.push_back(action);
  };
  collect(collect, window.menuBar()->actions());
  ASSERT_GT(actions.size(), 8u);
  for (QAction* action : actions) {
    const auto before = QApplication::topLevelWidgets();
    action->trigger();
    settle();
    for (QWidget* opened : QApplication::topLevelWidgets()) {
      if (before.contains(opened) || !opened->isVisible() || opened->inherits("QFileDialog")) continue;
      seen.insert(opened->metaObject()->className());
      SCOPED_TRACE(action->text().toStdString());
      expectNames(opened);
      opened->close();
    }
    for (QWidget* left : QApplication::topLevelWidgets())
      if (!before.contains(left) && left->isVisible()) left->close();
    settle();
  }
  EXPECT_GE(seen.size(), 3u) << "prompts, a list, dialogs";
}

// From the pipeline over the views and the probe down to the timeline.
TEST_F(AccessibleTest, TabGoesFromLeftToRightAndDown) {
  const QWidget* areas[] = {window.left(), window.views(), window.probe(), window.timeline()};
  window.pipeline()->searchField()->setFocus();
  std::vector<std::ptrdiff_t> order;
  const QWidget* start = window.pipeline()->searchField();
  const QWidget* at = start;
  do {
    at = at->nextInFocusChain();
    if (!takesFocus(at) || !at->isVisible()) continue;
    for (const QWidget*& area : areas)
      if (area->isAncestorOf(at) && (order.empty() || order.back() != &area - areas))
        order.push_back(&area - areas);
  } while (at != start);
  EXPECT_EQ(order, (std::vector<std::ptrdiff_t>{0, 1, 2, 3, 0}))
      << "each area once, then again from the left";
}

} // namespace
} // namespace taa::app::test
