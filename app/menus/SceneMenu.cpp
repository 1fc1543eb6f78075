#include "app/menus/SceneMenu.h"

#include "app/commands/CameraFiles.h"
#include "app/commands/Flight.h"
#include "app/panels/LeftArea.h"
#include "app/panels/ScenePanel.h"
#include "app/session/SceneChoices.h"
#include "app/style/Text.h"

#include <QAction>
#include <QString>

#include <array>
#include <cstddef>
#include <optional>

namespace taa::app {

SceneMenu::SceneMenu(Commands& commands, const Targets& on, QWidget* parent)
    : CommandMenu(tr("&Scene"), commands, parent), choices_(on.choices) {
  setToolTipsVisible(true);
  addFlight(on.flight);
  addCameras(on.cameras);
  addSeparator();
  addTree(on.left, on.scene);
  addSelection(on.scene);
  QAction* all =
      add(tr("Show &all objects"), keys({"Ctrl+Shift+H"}), [&scene = on.scene] { scene.showAll(); });
  onRefresh([this, all] {
    allow(all, whyFixed());
    if (all->isEnabled()) all->setEnabled(!(choices_.objectFilter() == ObjectFilter{}));
  });
}

void SceneMenu::addFlight(Flight& flight) {
  QAction* fly = addCheck(tr("&Fly the camera"), QKeySequence(QStringLiteral("Shift+F")),
                          [&flight](bool on) { flight.setOn(on); });
  QAction* record =
      add(tr("&Record a flight"), keys({"Ctrl+Shift+R"}), [&flight] { flight.toggleRecording(); });
  QAction* back = add(tr("&Back to the scene's camera"), keys({"Backspace"}), [&flight] { flight.reset(); });
  onRefresh([this, fly, record, back, &flight] {
    for (QAction* action : {fly, record, back}) allow(action, whyFixed());
    if (flight.isOn() && !whyFixed().isEmpty()) flight.setOn(false);
    fly->setChecked(flight.isOn());
    record->setText(flight.isRecording() ? tr("End the &recording") : tr("&Record a flight"));
  });
}

void SceneMenu::addCameras(CameraFiles& cameras) {
  QAction* save = add(tr("Sa&ve the flown camera…"), {}, [&cameras] { cameras.askWhereToSave(); });
  QAction* open = add(tr("Open a recorded &camera…"), {}, [&cameras] { cameras.askForFile(); });
  QAction* rename =
      add(tr("Re&name the flown camera…"), keys({"Ctrl+F2"}), [&cameras] { cameras.askForName(); });
  QAction* remove =
      add(tr("&Delete the flown camera"), keys({"Ctrl+Shift+Del"}), [&cameras] { cameras.remove(); });
  onRefresh([this, save, open, rename, remove, &cameras] {
    allow(open, whyFixed());
    for (QAction* action : {save, rename, remove}) action->setEnabled(cameras.flown() != nullptr);
  });
}

void SceneMenu::addTree(LeftArea& left, ScenePanel& scene) {
  QAction* tree = addCheck(tr("&Objects in place of the pipeline"), QKeySequence(QStringLiteral("F8")),
                           [&left](bool on) { left.openPage(on ? LeftPage::Scene : LeftPage::Pipeline); });
  onRefresh([tree, &left] { tree->setChecked(left.shows(LeftPage::Scene)); });
  add(tr("&Search objects"), keys({"Ctrl+Shift+F"}), [&left, &scene] {
    left.openPage(LeftPage::Scene);
    scene.focusFilter();
  });
}

void SceneMenu::addSelection(ScenePanel& scene) {
  const std::array needSelection{
      add(tr("&Hide or show the selected object"), keys({"Ctrl+H"}), [&scene] { scene.hideSelected(); }),
      add(tr("&Isolate the selected object, or show all again"), keys({"Ctrl+I"}),
          [&scene] { scene.isolateSelected(); }),
      add(tr("&Probe the selected object"), keys({"Ctrl+J"}), [&scene] { scene.revealSelected(); })};
  QMenu* motion = addMenu(tr("&Motion of the selected object"));
  for (std::size_t mode = 0; mode < kMotionModes.size(); ++mode)
    commands_.add(motion, qtext(kMotionModes[mode].label),
                  {QKeySequence(QStringLiteral("Ctrl+Shift+%1").arg(mode + 1))},
                  [&scene, mode] { scene.setMotionOfSelected(static_cast<MotionMode>(mode)); });
  QMenu* classes = addMenu(tr("&Class of the selected object"));
  int number = static_cast<int>(kMotionModes.size());
  for (const std::optional<ObjectClass> offered : ScenePanel::classChoices())
    commands_.add(classes, ScenePanel::classLabel(offered),
                  {QKeySequence(QStringLiteral("Ctrl+Shift+%1").arg(++number))},
                  [&scene, offered] { scene.setClassOfSelected(offered); });
  onRefresh([this, needSelection, motion, classes, &scene] {
    const bool isSelected = scene.selected() >= 0;
    const auto& [hide, isolate, probe] = needSelection;
    probe->setEnabled(isSelected);
    for (QAction* action : {hide, isolate, motion->menuAction(), classes->menuAction()}) {
      allow(action, whyFixed());
      if (!isSelected) action->setEnabled(false);
    }
  });
}

} // namespace taa::app
