// Objects of the scene, and the camera that is flown.
#include "app/menus/Menus.h"

#include "app/panels/ScenePanel.h"
#include "app/style/Text.h"
#include "app/window/Flight.h"
#include "app/window/MainWindow.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QTabWidget>

#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace taa::app {

void Menus::makeScene() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Scene"));
  ScenePanel* scene = window_.scene();
  Flight* flight = window_.flight();
  QAction* fly = addCheck(menu, tr("&Fly the camera"), QKeySequence(QStringLiteral("Shift+F")),
                          [flight](bool on) { flight->setOn(on); });
  QAction* record =
      add(menu, tr("&Record a flight"), keys({"Ctrl+Shift+R"}), [flight] { flight->toggleRecording(); });
  add(menu, tr("&Back to the scene's camera"), keys({"Backspace"}), [flight] { flight->reset(); });
  QAction* save = add(menu, tr("Sa&ve the flown camera…"), {}, [this] { window_.askToSaveCamera(); });
  add(menu, tr("Open a recorded &camera…"), {}, [this] { window_.askForCamera(); });
  QAction* rename =
      add(menu, tr("Re&name the flown camera…"), keys({"Ctrl+F2"}), [this] { window_.askForCameraName(); });
  QAction* remove = add(menu, tr("&Delete the flown camera"), keys({"Ctrl+Shift+Del"}), [this] {
    if (const CameraTrackHandle track = window_.flownCamera()) window_.session().removeCamera(track->name);
  });
  menu->addSeparator();
  QAction* tree = addCheck(menu, tr("&Objects in place of the pipeline"), QKeySequence(QStringLiteral("F8")),
                           [this](bool on) { window_.showScene(on); });
  add(menu, tr("&Search objects"), keys({"Ctrl+Shift+F"}), [this, scene] {
    window_.showScene(true);
    scene->focusFilter();
  });
  QAction* needSelection[] = {
      add(menu, tr("&Hide or show the selected object"), keys({"Ctrl+H"}),
          [scene] { scene->hideSelected(); }),
      add(menu, tr("&Isolate the selected object, or show all again"), keys({"Ctrl+I"}),
          [scene] { scene->isolateSelected(); }),
      add(menu, tr("&Probe the selected object"), keys({"Ctrl+J"}), [scene] { scene->revealSelected(); })};
  QMenu* motion = menu->addMenu(tr("&Motion of the selected object"));
  for (std::size_t mode = 0; mode < kMotionModes.size(); ++mode)
    add(motion, tableText(kMotionModes[mode].label),
        {QKeySequence(QStringLiteral("Ctrl+Shift+%1").arg(mode + 1))},
        [scene, mode] { scene->setMotionOfSelected(static_cast<MotionMode>(mode)); });
  QMenu* classes = menu->addMenu(tr("&Class of the selected object"));
  int number = static_cast<int>(kMotionModes.size());
  for (const std::optional<ObjectClass> offered : ScenePanel::classChoices())
    add(classes, ScenePanel::classLabel(offered),
        {QKeySequence(QStringLiteral("Ctrl+Shift+%1").arg(++number))},
        [scene, offered] { scene->setClassOfSelected(offered); });
  QAction* all = add(menu, tr("Show &all objects"), keys({"Ctrl+Shift+H"}), [scene] { scene->showAll(); });
  onRefresh([this, fly, record, save, rename, remove, tree, motion, classes, all, flight, scene,
             selection = std::vector<QAction*>(std::begin(needSelection), std::end(needSelection))] {
    fly->setChecked(flight->isOn());
    record->setText(flight->isRecording() ? tr("End the &recording") : tr("&Record a flight"));
    for (QAction* action : {save, rename, remove}) action->setEnabled(window_.flownCamera() != nullptr);
    tree->setChecked(window_.left()->currentWidget() == scene && !window_.left()->isHidden());
    for (QAction* action : selection) action->setEnabled(scene->selected() >= 0);
    for (QMenu* choices : {motion, classes}) choices->setEnabled(scene->selected() >= 0);
    all->setEnabled(!(window_.session().objectFilter() == ObjectFilter{}));
  });
}

} // namespace taa::app
