// What is opened.
#include "app/menus/Menus.h"

#include "app/Icons.h"
#include "app/MainWindow.h"
#include "core/scene/SceneSource.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

namespace taa::app {

void Menus::makeFile() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&File"));
  add(menu, tr("&Open…"), keys({"Ctrl+O"}), [this] {
    window_.askForFile();
  })->setIcon(themedIcon(QStringLiteral("open")));
  menu->addSeparator();
  for (const BuiltinScene& scene : builtinScenes()) {
    const QString source = QStringLiteral("builtin:") + QString::fromStdString(scene.id);
    add(menu, QString::fromStdString(scene.label), {}, [this, source] {
      window_.openSource(source);
    })->setToolTip(QString::fromStdString(scene.description));
  }
  menu->setToolTipsVisible(true);
  menu->addSeparator();
  add(menu, tr("&Quit"), keys({"Ctrl+Q"}), [this] { window_.close(); });
}

} // namespace taa::app
