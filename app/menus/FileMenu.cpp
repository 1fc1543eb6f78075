// What is opened, saved and exported.
#include "app/menus/Menus.h"

#include "app/session/SessionKeeper.h"
#include "app/style/Icons.h"
#include "app/style/Text.h"
#include "app/window/Exports.h"
#include "app/window/MainWindow.h"
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
  makeRecent(menu->addMenu(tr("Open &recent")));
  SessionKeeper* keeper = window_.keeper();
  add(menu, tr("Start &anew"), {}, [keeper] {
    keeper->startAnew();
  })->setToolTip(tr("The first scene, settings and layout. What is open is kept, and can be opened again."));
  add(menu, tr("&Save session"), keys({"Ctrl+S"}), [keeper] { keeper->save(); });
  add(menu, tr("Save session &as…"), keys({"Ctrl+Shift+S"}), [keeper] { keeper->askWhereToSave(); });
  makeExport(menu->addMenu(tr("&Export")));
  menu->addSeparator();
  for (const BuiltinScene& scene : builtinScenes()) {
    const QString source = QStringLiteral("builtin:") + QString::fromStdString(scene.id);
    add(menu, tableText(scene.label), {}, [this, source] {
      window_.openSource(source);
    })->setToolTip(tableText(scene.description));
  }
  menu->setToolTipsVisible(true);
  menu->addSeparator();
  add(menu, tr("&Quit"), keys({"Ctrl+Q"}), [this] { window_.close(); });
}

void Menus::makeRecent(QMenu* menu) {
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const QString& path : window_.keeper()->recent())
      menu->addAction(QString(path).replace(u'&', QStringLiteral("&&")), this,
                      [this, path] { window_.openSource(path); });
    if (menu->isEmpty()) return menu->addAction(tr("Nothing yet"))->setEnabled(false);
    menu->addSeparator();
    menu->addAction(tr("&Forget these"), this, [this] { window_.keeper()->clearRecent(); });
  });
}

void Menus::makeExport(QMenu* menu) {
  Exports* exports = window_.exports();
  add(menu, tr("&View as PNG…"), keys({"Ctrl+E"}), [exports] { exports->askForView(false); });
  add(menu, tr("View with its &legend as PNG…"), keys({"Ctrl+Alt+E"}),
      [exports] { exports->askForView(true); });
  add(menu, tr("&Range of frames…"), keys({"Ctrl+Shift+E"}), [exports] { exports->askForRange(); });
}

} // namespace taa::app
