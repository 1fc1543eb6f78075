// Time, cameras, objects, size.
#include "app/menus/Menus.h"

#include "app/panels/TimelinePanel.h"
#include "app/style/Icons.h"
#include "app/style/Text.h"
#include "app/window/MainWindow.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include <algorithm>
#include <string>

namespace taa::app {

namespace {

constexpr std::size_t kBudgetsMiB[] = {256, 1024, 2048, 4096};
constexpr glm::ivec2 kSizes[] = {{640, 360},   {960, 540},   {1280, 720}, {1920, 1080},
                                 {2560, 1440}, {3840, 2160}, {7680, 4320}};

} // namespace

void Menus::makeFrame() {
  QMenu* menu = window_.menuBar()->addMenu(tr("F&rame"));
  Session& session = window_.session();
  QAction* play = add(menu, tr("&Play"), keys({"Space"}), [&session] { session.togglePlaying(); });
  add(menu, tr("Step &back"), keys({","}), [&session] {
    session.step(-1);
  })->setIcon(themedIcon(QStringLiteral("previous")));
  add(menu, tr("Step &forward"), keys({"."}), [&session] {
    session.step(1);
  })->setIcon(themedIcon(QStringLiteral("next")));
  add(menu, tr("Ten back"), keys({"Shift+,"}), [&session] { session.step(-10); });
  add(menu, tr("Ten forward"), keys({"Shift+."}), [&session] { session.step(10); });
  add(menu, tr("First frame"), keys({"Home"}), [&session] {
    session.seek(0);
  })->setIcon(themedIcon(QStringLiteral("first")));
  add(menu, tr("Last frame"), keys({"End"}), [&session] {
    session.seek(session.status().frameCount - 1);
  })->setIcon(themedIcon(QStringLiteral("last")));
  add(menu, tr("&Go to frame…"), keys({"G"}), [this] { window_.askForFrame(); });
  QAction* looping =
      addCheck(menu, tr("Start again at the end"), QKeySequence(QStringLiteral("Ctrl+L")), [this](bool on) {
        window_.timeline()->setLooping(on);
        Q_EMIT window_.timeline()->loopToggled(on);
      });
  makePlayback(menu->addMenu(tr("Speed and &range")));
  makeFrameMarks(menu->addMenu(tr("&Marks")));
  add(menu, tr("&Restart the history here, or no longer"), keys({"Shift+R"}), [this] {
    if (window_.session().isOpen()) window_.session().toggleRestart(window_.timeline()->frame());
  });
  QAction* restarts = add(menu, tr("Take all restarts awa&y"), {}, [&session] { session.removeRestarts(); });
  onRefresh([&session, restarts] { restarts->setEnabled(!session.restarts().empty()); });
  makeFigures(menu->addMenu(tr("F&igure under the timeline")));
  add(menu, tr("&Stop what is under way"), keys({"Ctrl+."}), [&session] {
    session.cancel();
  })->setIcon(themedIcon(QStringLiteral("stop")));
  menu->addSeparator();
  makeCameras(menu->addMenu(tr("&Camera")));
  makeObjects(menu->addMenu(tr("&Motion of objects")));
  makeSizes(menu->addMenu(tr("Render si&ze")));
  makeBudgets(menu->addMenu(tr("Memory for &kept frames")));
  onRefresh([&session, play, looping] {
    play->setText(session.status().playing ? tr("&Pause") : tr("&Play"));
    looping->setChecked(session.isLooping());
  });
}

void Menus::makeSizes(QMenu* menu) {
  Session& session = window_.session();
  for (const glm::ivec2 size : kSizes) {
    const QString name = QStringLiteral("%1×%2").arg(size.x).arg(size.y);
    QAction* action = add(menu, name, {}, [&session, size] { session.setSize(size.x, size.y); });
    connect(menu, &QMenu::aboutToShow, action, [action, name, &session, size] {
      action->setText(tr("%1 (%2)").arg(name, session.memoryText(size)));
    });
  }
  add(menu, tr("Other…"), {}, [this] { window_.askForSize(); });
}

void Menus::makeBudgets(QMenu* menu) {
  Session& session = window_.session();
  for (const std::size_t size : kBudgetsMiB) {
    const QString text = size < 1024 ? tr("%1 MiB").arg(size) : tr("%1 GiB").arg(size / 1024);
    QAction* action = add(menu, text, {}, [&session, size] { session.setCheckpointBudget(size << 20); });
    action->setCheckable(true);
    onRefresh(
        [&session, action, size] { action->setChecked(session.status().checkpointBudget == size << 20); });
  }
}

void Menus::makeCameras(QMenu* menu) {
  onRefresh([this, menu] {
    const Status& status = window_.session().status();
    if (status.cameras != cameraNames_) {
      cameraNames_ = status.cameras;
      menu->clear();
      for (const std::string& name : cameraNames_) {
        const QString text = QString::fromStdString(name);
        menu->addAction(text, &window_.session(), [this, text] { window_.session().setCamera(text); })
            ->setCheckable(true);
      }
    }
    for (QAction* action : menu->actions()) action->setChecked(action->text().toStdString() == status.camera);
  });
}

void Menus::makeObjects(QMenu* menu) {
  onRefresh([this, menu] { refreshObjects(menu); });
}

// A submenu for each object of the scene, with the motion it is given.
void Menus::refreshObjects(QMenu* menu) {
  const Status& status = window_.session().status();
  if (status.objects != objectNames_) {
    objectNames_ = status.objects;
    menu->clear();
    for (const std::string& name : objectNames_) {
      QMenu* modes = menu->addMenu(QString::fromStdString(name).replace(u'&', QStringLiteral("&&")));
      for (std::size_t mode = 0; mode < kMotionModes.size(); ++mode)
        modes
            ->addAction(
                tableText(kMotionModes[mode].label), &window_.session(),
                [this, name, mode] { window_.session().setMotionMode(name, static_cast<MotionMode>(mode)); })
            ->setCheckable(true);
    }
  }
  menu->setEnabled(!objectNames_.empty());
  for (int object = 0; object < menu->actions().size(); ++object) {
    const auto chosen = std::ranges::find(status.motionModes, objectNames_[static_cast<std::size_t>(object)],
                                          &MotionOverride::node);
    const MotionMode current = chosen == status.motionModes.end() ? MotionMode::PerObject : chosen->mode;
    const QList<QAction*> modes = menu->actions().at(object)->menu()->actions();
    for (int mode = 0; mode < modes.size(); ++mode)
      modes.at(mode)->setChecked(static_cast<int>(current) == mode);
  }
}

} // namespace taa::app
