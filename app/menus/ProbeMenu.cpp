// The pick.
#include "app/menus/Menus.h"

#include "app/Icons.h"
#include "app/MainWindow.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

namespace taa::app {

void Menus::makeProbe() {
  QMenu* menu = window_.menuBar()->addMenu(tr("Pr&obe"));
  add(menu, tr("&Go to pixel…"), keys({"Ctrl+G"}), [this] {
    window_.askForPixel();
  })->setIcon(themedIcon(QStringLiteral("probe")));
  add(menu, tr("Go to the probe"), keys({"P"}), [this] {
    if (const auto pick = window_.session().pick()) window_.views()->active()->viewport()->reveal(*pick);
  });
  add(menu, tr("&Remove the probe"), keys({"Esc"}), [this] { window_.session().setPick({}); });
}

} // namespace taa::app
