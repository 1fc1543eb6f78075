#include "app/menus/FrameMenu.h"

#include "app/commands/GoToPrompts.h"
#include "app/menus/PlaybackMenu.h"
#include "app/panels/TimelinePanel.h"
#include "app/session/Session.h"
#include "app/style/Icons.h"
#include "app/style/Text.h"

#include "core/render/CaptureFacts.h"

#include <QAction>

#include <algorithm>
#include <cstddef>

namespace taa::app {

namespace {

constexpr std::size_t kBudgetsMiB[] = {256, 1024, 2048, 4096};
constexpr glm::ivec2 kSizes[] = {{640, 360},   {960, 540},   {1280, 720}, {1920, 1080},
                                 {2560, 1440}, {3840, 2160}, {7680, 4320}};

} // namespace

FrameMenu::FrameMenu(Commands& commands, Session& session, TimelinePanel& timeline, GoToPrompts& prompts,
                     QWidget* parent)
    : CommandMenu(tr("F&rame"), commands, parent), session_(session) {
  addSteps(prompts);
  addLooping(timeline);
  addMenu(new PlaybackMenu(commands_, timeline, this));
  addMenu(new MarksMenu(commands_, timeline, prompts, this));
  addRestarts(timeline);
  addMenu(new MetricsMenu(commands_, timeline, this));
  add(tr("&Stop what is under way"), keys({"Ctrl+."}), [&session] {
    session.post(request::Cancel{});
  })->setIcon(themedIcon(QStringLiteral("stop")));
  addSeparator();
  addCameras();
  addAnimations();
  addObjects();
  addSizes(prompts);
  addBudgets();
}

void FrameMenu::addSteps(GoToPrompts& prompts) {
  Session& session = session_;
  QAction* play = add(tr("&Play"), keys({"Space"}), [&session] { session.togglePlaying(); });
  onRefresh([&session, play] { play->setText(session.status().playing ? tr("&Pause") : tr("&Play")); });
  add(tr("Step &back"), keys({","}), [&session] {
    session.post(request::Step{-1});
  })->setIcon(themedIcon(QStringLiteral("previous")));
  add(tr("Step &forward"), keys({"."}), [&session] {
    session.post(request::Step{1});
  })->setIcon(themedIcon(QStringLiteral("next")));
  add(tr("Ten back"), keys({"Shift+,"}), [&session] { session.post(request::Step{-10}); });
  add(tr("Ten forward"), keys({"Shift+."}), [&session] { session.post(request::Step{10}); });
  add(tr("First frame"), keys({"Home"}), [&session] {
    session.seek(0);
  })->setIcon(themedIcon(QStringLiteral("first")));
  add(tr("Last frame"), keys({"End"}), [&session] {
    session.seek(session.status().frameCount - 1);
  })->setIcon(themedIcon(QStringLiteral("last")));
  add(tr("&Go to frame…"), keys({"G"}), [&prompts] { prompts.askForFrame(); });
  QAction* length = add(tr("Length of the shot…"), {}, [&prompts] { prompts.askForLength(); });
  onRefresh([&session, length] { allow(length, session.scene().whyFixed()); });
}

void FrameMenu::addLooping(TimelinePanel& timeline) {
  QAction* looping =
      addCheck(tr("Start again at the end"), QKeySequence(QStringLiteral("Ctrl+L")), [&timeline](bool on) {
        timeline.setLooping(on);
        Q_EMIT timeline.loopToggled(on);
      });
  onRefresh([this, looping] { looping->setChecked(session_.isLooping()); });
}

void FrameMenu::addRestarts(TimelinePanel& timeline) {
  add(tr("&Restart the history here, or no longer"), keys({"Shift+R"}), [this, &timeline] {
    if (session_.isOpen()) session_.scene().toggleRestart(timeline.frame());
  });
  QAction* restarts = add(tr("Take all restarts awa&y"), {}, [this] { session_.scene().removeRestarts(); });
  onRefresh([this, restarts] { restarts->setEnabled(!session_.scene().restarts().empty()); });
}

void FrameMenu::addSizes(GoToPrompts& prompts) {
  QMenu* menu = addMenu(tr("Render si&ze"));
  Session& session = session_;
  for (const glm::ivec2 size : kSizes) {
    const QString name = QStringLiteral("%1×%2").arg(size.x).arg(size.y);
    QAction* action = commands_.add(menu, name, {}, [&session, size] {
      session.post(request::SetSize{size.x, size.y});
    });
    connect(menu, &QMenu::aboutToShow, action, [action, name, &session, size] {
      action->setText(tr("%1 (%2)").arg(name, session.memoryText(size)));
    });
  }
  commands_.add(menu, tr("Other…"), {}, [&prompts] { prompts.askForSize(); });
  menu->setToolTipsVisible(true);
  onRefresh([&session, menu] {
    const auto& capture = session.status().capture;
    const QString whyNot = capture ? sentence(whyOneSize(*capture)) : QString();
    for (QAction* action : menu->actions()) allow(action, whyNot);
  });
}

void FrameMenu::addBudgets() {
  QMenu* menu = addMenu(tr("Memory for &kept frames"));
  Session& session = session_;
  for (const std::size_t size : kBudgetsMiB) {
    const QString text = size < 1024 ? tr("%1 MiB").arg(size) : tr("%1 GiB").arg(size / 1024);
    QAction* action = commands_.add(
        menu, text, {}, [&session, size] { session.post(request::SetCheckpointBudget{size << 20}); });
    action->setCheckable(true);
    onRefresh(
        [&session, action, size] { action->setChecked(session.status().checkpointBudget == size << 20); });
  }
}

void FrameMenu::addCameras() {
  QMenu* menu = addMenu(tr("&Camera"));
  onRefresh([this, menu] { refreshCameras(menu); });
}

void FrameMenu::refreshCameras(QMenu* menu) {
  const Status& status = session_.status();
  if (status.cameras != cameraNames_) {
    cameraNames_ = status.cameras;
    menu->clear();
    for (const std::string& name : cameraNames_) {
      const QString text = QString::fromStdString(name);
      menu->addAction(text, &session_, [this, text] { session_.scene().setCamera(text); })
          ->setCheckable(true);
    }
  }
  for (QAction* action : menu->actions()) action->setChecked(action->text().toStdString() == status.camera);
}

void FrameMenu::addAnimations() {
  QMenu* menu = addMenu(tr("Anima&tion"));
  onRefresh([this, menu] { refreshAnimations(menu); });
}

// One is chosen where there are several.
void FrameMenu::refreshAnimations(QMenu* menu) {
  const Status& status = session_.status();
  if (status.animations != animationNames_) {
    animationNames_ = status.animations;
    menu->clear();
    const auto offer = [&](const QString& text, const std::string& name) {
      QAction* action = menu->addAction(text, &session_, [this, name] {
        session_.choose({name, session_.status().choice.frames});
      });
      action->setCheckable(true);
      action->setData(QString::fromStdString(name));
    };
    for (const std::string& name : animationNames_)
      offer(QString::fromStdString(name).replace(u'&', QStringLiteral("&&")), name);
    offer(tr("All at once"), std::string(kAllAnimations));
  }
  const std::string& chosen = status.choice.animation;
  const std::string playing = chosen.empty() && !animationNames_.empty() ? animationNames_.front() : chosen;
  for (QAction* action : menu->actions())
    action->setChecked(action->data().toString().toStdString() == playing);
  menu->setEnabled(animationNames_.size() > 1);
}

void FrameMenu::addObjects() {
  QMenu* menu = addMenu(tr("&Motion of objects"));
  onRefresh([this, menu] { refreshObjects(menu); });
}

// A submenu for each object of the scene, with the motion it is given.
void FrameMenu::refreshObjects(QMenu* menu) {
  const Status& status = session_.status();
  if (status.objects != objectNames_) {
    objectNames_ = status.objects;
    menu->clear();
    for (const std::string& name : objectNames_) {
      QMenu* modes = menu->addMenu(QString::fromStdString(name).replace(u'&', QStringLiteral("&&")));
      for (std::size_t mode = 0; mode < kMotionModes.size(); ++mode)
        modes
            ->addAction(
                qtext(kMotionModes[mode].label), &session_,
                [this, name, mode] { session_.scene().setMotionMode(name, static_cast<MotionMode>(mode)); })
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
