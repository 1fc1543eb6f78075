#include "app/menus/LayoutMenu.h"

#include "app/docks/PanelCycle.h"
#include "app/docks/PanelDock.h"
#include "app/docks/Workspace.h"

#include <QAction>
#include <QGuiApplication>

#include <algorithm>

namespace taa::app {

LayoutMenu::LayoutMenu(Commands& commands, Workspace& workspace, PanelCycle& cycle, QWidget* parent)
    : CommandMenu(tr("La&yout"), commands, parent) {
  setToolTipsVisible(true);
  add(tr("&Next panel"), keys({"Ctrl+Tab"}), [&cycle] { cycle.go(1); });
  add(tr("&Panel before"), keys({"Ctrl+Shift+Tab"}), [&cycle] { cycle.go(-1); });
  addSeparator();
  addWindows(workspace);
  addSeparator();
  add(tr("&Reset layout"), keys({"Ctrl+Alt+0"}), [&workspace] { workspace.resetLayout(); });
}

void LayoutMenu::addWindows(Workspace& workspace) {
  for (PanelDock* dock : workspace.docks()) {
    QAction* action =
        addCheck(tr("In a window of its own: %1").arg(dock->windowTitle()), {}, [&workspace, dock](bool on) {
          workspace.setTornOff(dock, on);
          if (on) dock->widget()->show();
        });
    onRefresh([&workspace, dock, action] { action->setChecked(workspace.isTornOff(dock)); });
  }
  QAction* next = add(tr("Windows of panels to the next &screen"), keys({"Ctrl+Alt+N"}),
                      [&workspace] { workspace.moveToNextScreen(); });
  onRefresh([&workspace, next] {
    const bool isAny =
        std::ranges::any_of(workspace.docks(), [](const PanelDock* dock) { return dock->isFloating(); });
    allow(next, QGuiApplication::screens().size() < 2 ? tr("There is one screen only.")
                : isAny                               ? QString()
                                                      : tr("No panel is in a window of its own."));
  });
}

} // namespace taa::app
