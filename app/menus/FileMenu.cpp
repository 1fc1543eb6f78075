#include "app/menus/FileMenu.h"

#include "app/commands/DoctorCommands.h"
#include "app/commands/Exports.h"
#include "app/commands/ImportFrames.h"
#include "app/figures/FigureExport.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/style/Icons.h"
#include "app/style/Text.h"
#include "core/scene/builtin/SceneSource.h"

#include <QAction>

namespace taa::app {

FileMenu::FileMenu(Commands& commands, const Targets& on, QWidget* parent)
    : CommandMenu(tr("&File"), commands, parent), keeper_(on.keeper), exports_(on.exports),
      doctor_(on.doctor), figures_(on.figures) {
  SessionKeeper& keeper = on.keeper;
  ImportFrames& imports = on.imports;
  add(tr("&Open…"), keys({"Ctrl+O"}), [&keeper] {
    keeper.askWhatToOpen();
  })->setIcon(themedIcon(QStringLiteral("open")));
  add(tr("Open &capture…"), {}, [&imports] { imports.askForCapture(); })
      ->setToolTip(tr(
          "The folder of frames that an engine wrote, with its capture.json; without one it is imported."));
  addRecent();
  add(tr("&Import frames…"), keys({"Ctrl+Shift+I"}), [&imports] { imports.askForFolder(); })
      ->setToolTip(
          tr("Frames of another engine: a folder of EXR, PNG and other pictures. Its conventions are "
             "guessed, shown and changed before it is opened."));
  add(tr("Start &anew"), {}, [&keeper] {
    keeper.startAnew();
  })->setToolTip(tr("The first scene, settings and layout. What is open is kept, and can be opened again."));
  add(tr("&Save session"), keys({"Ctrl+S"}), [&keeper] { keeper.save(); });
  add(tr("Save session &as…"), keys({"Ctrl+Shift+S"}), [&keeper] { keeper.askWhereToSave(); });
  addExports();
  addSeparator();
  for (const BuiltinScene& scene : builtinScenes()) {
    const QString source = QStringLiteral("builtin:") + QString::fromStdString(scene.id);
    QAction* open = add(qtext(scene.label), {}, [&keeper, source] { keeper.openSource(source); });
    open->setToolTip(qtext(scene.description));
    commands_.setName(open, tr("Scene: %1").arg(qtext(scene.label)));
  }
  setToolTipsVisible(true);
  addSeparator();
  add(tr("&Quit"), keys({"Ctrl+Q"}), [window = parent->window()] { window->close(); });
}

void FileMenu::addRecent() {
  QMenu* menu = addMenu(tr("Open &recent"));
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const QString& path : keeper_.recent())
      menu->addAction(QString(path).replace(u'&', QStringLiteral("&&")), this,
                      [this, path] { keeper_.openSource(path); });
    if (menu->isEmpty()) return menu->addAction(tr("Nothing yet"))->setEnabled(false);
    menu->addSeparator();
    menu->addAction(tr("&Forget these"), this, [this] { keeper_.clearRecent(); });
  });
}

void FileMenu::addExports() {
  QMenu* menu = addMenu(tr("&Export"));
  commands_.add(menu, tr("&View as PNG…"), keys({"Ctrl+E"}), [this] { exports_.askForView(false); });
  commands_.add(menu, tr("View with its &legend as PNG…"), keys({"Ctrl+Alt+E"}),
                [this] { exports_.askForView(true); });
  commands_.add(menu, tr("&Figure with its caption as PNG or SVG…"), keys({"Ctrl+Alt+G"}),
                [this] { figures_.choose(); });
  commands_.add(menu, tr("&Range of frames…"), keys({"Ctrl+Shift+E"}), [this] { exports_.askForRange(); });
  QAction* report =
      commands_.add(menu, tr("Report of the &doctor as HTML…"), {}, [this] { doctor_.askForReport(); });
  onRefresh([this, report] { allow(report, doctor_.whyNoReport()); });
}

} // namespace taa::app
