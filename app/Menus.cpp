#include "app/Menus.h"

#include "app/Icons.h"
#include "app/MainWindow.h"
#include "app/UserPresets.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ProfilerPanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/widgets/ReferenceDialog.h"
#include "core/scene/SceneSource.h"
#include "core/settings/Presets.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

#include <algorithm>

namespace taa::app {

namespace {

QList<QKeySequence> keys(std::initializer_list<const char*> names) {
  QList<QKeySequence> list;
  for (const char* name : names) list << QKeySequence(QLatin1String(name));
  return list;
}

constexpr std::size_t kBudgetsMiB[] = {256, 1024, 2048, 4096};
constexpr glm::ivec2 kSizes[] = {{640, 360},   {960, 540},   {1280, 720}, {1920, 1080},
                                 {2560, 1440}, {3840, 2160}, {7680, 4320}};

} // namespace

Menus::Menus(MainWindow& window) : QObject(&window), window_(window) {
  makeFile();
  makeEdit();
  makeView();
  makeFrame();
  makePipeline();
  makeProbe();
  makeHelp();
  refresh();
}

QAction* Menus::add(QMenu* menu, const QString& text, const QList<QKeySequence>& shortcuts,
                    std::function<void()> act) {
  auto* action = new QAction(text, menu);
  action->setShortcuts(shortcuts);
  connect(action, &QAction::triggered, this, [act = std::move(act)] { act(); });
  menu->addAction(action);
  commands_.push_back({menu->title().remove(QLatin1Char('&')), action});
  return action;
}

QAction* Menus::addCheck(QMenu* menu, const QString& text, const QKeySequence& key,
                         std::function<void(bool)> act) {
  QAction* action = add(menu, text, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key}, [] {});
  action->setCheckable(true);
  connect(action, &QAction::toggled, this, [act = std::move(act)](bool on) { act(on); });
  return action;
}

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

void Menus::makeEdit() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Edit"));
  Session& session = window_.session();
  undo_ = add(menu, tr("&Undo change of settings"), keys({"Ctrl+Z"}), [&session] { session.undo(); });
  redo_ = add(menu, tr("&Redo"), keys({"Ctrl+Shift+Z"}), [&session] { session.redo(); });
  menu->addSeparator();
  add(menu, tr("&Copy probed value"), keys({"Ctrl+C"}), [this] {
    window_.copyValue();
  })->setIcon(themedIcon(QStringLiteral("copy")));
  add(menu, tr("Copy &all probed values"), keys({"Ctrl+Shift+C"}), [this] { window_.copyAll(); });
  add(menu, tr("Copy profile as text"), {}, [this] { window_.copyProfile(false); });
  add(menu, tr("Copy profile as CSV"), {}, [this] { window_.copyProfile(true); });
  menu->addSeparator();
  add(menu, tr("&Search settings and intermediates"), keys({"Ctrl+F"}), [this] {
    window_.pipeline()->focusSearch();
  })->setIcon(themedIcon(QStringLiteral("search")));
  add(menu, tr("&Find a command…"), keys({"Ctrl+Shift+P"}), [this] { window_.showCommands(); });
}

void Menus::makeView() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&View"));
  ViewArea* views = window_.views();
  add(menu, tr("&Intermediate…"), keys({"I"}),
      [this, views] { window_.chooseIntermediate(views->activeIndex()); });
  add(menu, tr("Keys act on view A"), keys({"Ctrl+1"}), [views] {
    views->setActive(0);
    views->active()->viewport()->setFocus();
  });
  add(menu, tr("Keys act on view B"), keys({"Ctrl+2"}), [views] {
    views->setTwoViews(true);
    views->setActive(1);
    views->active()->viewport()->setFocus();
  });
  twoViews_ = addCheck(menu, tr("&Two views"), QKeySequence(QStringLiteral("V")),
                       [views](bool on) { views->setTwoViews(on); });
  linked_ = addCheck(menu, tr("&Look at the same place in both"), QKeySequence(QStringLiteral("L")),
                     [views](bool on) { views->setLinked(on); });
  QMenu* arrangement = menu->addMenu(tr("&Arrangement"));
  auto* group = new QActionGroup(this);
  const std::pair<Arrangement, QString> choices[] = {{Arrangement::Automatic, tr("Whichever is larger")},
                                                     {Arrangement::Beside, tr("Side by side")},
                                                     {Arrangement::Stacked, tr("One above the other")}};
  for (const auto& [choice, text] : choices) {
    QAction* action = add(arrangement, text, {}, [views, choice = choice] { views->setArrangement(choice); });
    action->setCheckable(true);
    arrangements_ << group->addAction(action);
  }
  menu->addSeparator();
  add(menu, tr("&Fit"), keys({"F"}), [views] {
    views->active()->viewport()->fit();
  })->setIcon(themedIcon(QStringLiteral("fit")));
  add(menu, tr("&One to one"), keys({"1"}), [views] { views->active()->viewport()->oneToOne(); });
  add(menu, tr("Zoom in"), keys({"+", "="}), [views] { views->active()->viewport()->zoomBy(1); });
  add(menu, tr("Zoom out"), keys({"-"}), [views] { views->active()->viewport()->zoomBy(-1); });
  menu->addSeparator();
  QAction* panel = addCheck(menu, tr("Pipeline panel"), QKeySequence(QStringLiteral("F9")),
                            [this](bool on) { window_.setPanelVisible(window_.pipeline(), on); });
  panel->setChecked(true);
  panel = addCheck(menu, tr("Probe panel"), QKeySequence(QStringLiteral("F10")),
                   [this](bool on) { window_.setPanelVisible(window_.probe(), on); });
  panel->setChecked(true);
  profiler_ = addCheck(menu, tr("Profiler panel"), QKeySequence(QStringLiteral("F11")),
                       [this](bool on) { window_.setPanelVisible(window_.profiler(), on); });
  panel = addCheck(menu, tr("Pictures in the headings of stages"), QKeySequence(QStringLiteral("T")),
                   [this](bool on) { window_.pipeline()->setShowsThumbnails(on); });
  panel->setChecked(true);
  menu->addSeparator();
  makePictures(menu->addMenu(tr("&Picture")));
  QMenu* theme = menu->addMenu(tr("T&heme"));
  auto* themes = new QActionGroup(this);
  const std::pair<ThemeChoice, QString> looks[] = {{ThemeChoice::System, tr("As the system")},
                                                   {ThemeChoice::Dark, tr("Dark")},
                                                   {ThemeChoice::Light, tr("Light")}};
  for (const auto& [choice, text] : looks) {
    QAction* action = add(theme, text, {}, [this, choice = choice] { window_.setTheme(choice); });
    action->setCheckable(true);
    themes_ << themes->addAction(action);
  }
}

void Menus::makePictures(QMenu* menu) {
  ViewArea* views = window_.views();
  add(menu, tr("Brighter by half a stop"), keys({"E"}), [views] { views->active()->changeExposure(0.5f); });
  add(menu, tr("Darker by half a stop"), keys({"Shift+E"}),
      [views] { views->active()->changeExposure(-0.5f); });
  add(menu, tr("&Normalize: fit the range to the visible values"), keys({"N"}), [views] {
    views->active()->normalize();
  })->setIcon(themedIcon(QStringLiteral("auto-range")));
  add(menu, tr("Normalize always"), keys({"Shift+N"}),
      [views] { views->active()->setAlwaysAuto(!views->active()->isAlwaysAuto()); });
  add(menu, tr("&Reset"), keys({"R"}), [views] {
    views->active()->resetStyle();
  })->setIcon(themedIcon(QStringLiteral("reset")));
  add(menu, tr("Next color &map"), keys({"M"}), [views] { views->active()->nextColorMap(); });
  const QString channels[] = {tr("First channel"), tr("Second channel"), tr("Third channel")};
  for (int channel = 0; channel < 3; ++channel)
    add(menu, channels[channel], {QKeySequence(QStringLiteral("Alt+%1").arg(channel + 1))},
        [views, channel] { views->active()->toggleChannel(channel); });
  marks_ = addCheck(menu, tr("Mark NaN red, infinite green, negative blue"),
                    QKeySequence(QStringLiteral("X")), [views](bool on) {
                      if (views->active()->style().markInvalid != on) views->active()->toggleMarks();
                    });
}

void Menus::makeFrame() {
  QMenu* menu = window_.menuBar()->addMenu(tr("F&rame"));
  Session& session = window_.session();
  play_ = add(menu, tr("&Play"), keys({"Space"}), [&session] { session.togglePlaying(); });
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
  looping_ =
      addCheck(menu, tr("Start again at the end"), QKeySequence(QStringLiteral("Ctrl+L")), [this](bool on) {
        window_.session().setLooping(on);
        window_.timeline()->setLooping(on);
      });
  add(menu, tr("&Stop what is under way"), keys({"Ctrl+."}), [&session] {
    session.cancel();
  })->setIcon(themedIcon(QStringLiteral("stop")));
  menu->addSeparator();
  cameras_ = menu->addMenu(tr("&Camera"));
  objects_ = menu->addMenu(tr("&Motion of objects"));
  QMenu* sizes = menu->addMenu(tr("Render si&ze"));
  for (const glm::ivec2 size : kSizes) {
    const QString name = QStringLiteral("%1×%2").arg(size.x).arg(size.y);
    QAction* action = add(sizes, name, {}, [&session, size] { session.setSize(size.x, size.y); });
    connect(sizes, &QMenu::aboutToShow, action, [action, name, &session, size] {
      action->setText(tr("%1 (%2)").arg(name, session.memoryText(size)));
    });
  }
  add(sizes, tr("Other…"), {}, [this] { window_.askForSize(); });
  QMenu* budgets = menu->addMenu(tr("Memory for &kept frames"));
  for (const std::size_t size : kBudgetsMiB) {
    const QString text = size < 1024 ? tr("%1 MiB").arg(size) : tr("%1 GiB").arg(size / 1024);
    budgets_ << add(budgets, text, {}, [&session, size] { session.setCheckpointBudget(size << 20); });
    budgets_.back()->setCheckable(true);
  }
}

void Menus::makePipeline() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Pipeline"));
  menu->setToolTipsVisible(true);
  Session& session = window_.session();
  QMenu* presets = menu->addMenu(tr("&Preset"));
  presets->setToolTipsVisible(true);
  int number = 0;
  std::string group = builtinPresets().front().group;
  for (const Preset& preset : builtinPresets()) {
    if (preset.group != group) presets->addSeparator();
    group = preset.group;
    const QString id = QString::fromStdString(preset.id);
    const QList<QKeySequence> key =
        ++number <= 9 ? QList<QKeySequence>{QKeySequence(QStringLiteral("Ctrl+Alt+%1").arg(number))}
                      : QList<QKeySequence>();
    add(presets, QString::fromStdString(preset.label), key, [&session, id] {
      session.setPreset(id);
    })->setToolTip(QString::fromStdString(preset.description));
  }
  QMenu* own = menu->addMenu(tr("&My presets"));
  connect(own, &QMenu::aboutToShow, this, [this, own] {
    own->clear();
    for (const UserPreset& preset : userPresets(window_.presetFolder()))
      own->addAction(preset.label, this, [this, path = preset.path] { window_.session().setPreset(path); });
    if (own->isEmpty()) own->addAction(tr("None saved yet"))->setEnabled(false);
  });
  add(menu, tr("&Save as preset…"), keys({"Ctrl+S"}), [this] { window_.askForPresetName(); });
  add(menu, tr("Open a preset &file…"), keys({"Ctrl+Shift+O"}), [this] { window_.askForPresetFile(); });
  add(menu, tr("&Back to the preset"), keys({"Ctrl+R"}), [&session] { session.backToPreset(); });
  menu->addSeparator();
  add(menu, tr("&Unfold all stages"), keys({"Ctrl+Down"}),
      [this] { window_.pipeline()->setAllExpanded(true); });
  add(menu, tr("&Fold all stages"), keys({"Ctrl+Up"}), [this] { window_.pipeline()->setAllExpanded(false); });
  menu->addSeparator();
  add(menu, tr("&Measure what each stage costs"), keys({"Shift+F11"}), [this] { window_.measureStages(); });
  add(menu, tr("Reload &shaders"), keys({"F5"}), [&session] { session.reloadShaders(); });
}

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

void Menus::makeHelp() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Help"));
  add(menu, tr("&Keys"), keys({"?"}), [this] {
    window_.showKeys();
  })->setIcon(themedIcon(QStringLiteral("keyboard")));
  add(menu, tr("&Reference of parameters and intermediates"), keys({"F1"}), [this] {
    auto* dialog = new ReferenceDialog(&window_);
    dialog->open();
  });
  add(menu, tr("&About TAA Inspector"), {}, [this] {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About TAA Inspector"),
        tr("TAA Inspector %1\n\nSteps temporal anti-aliasing frame by frame and shows everything it "
           "computes.\n\nDriver: %2\nQt %3")
            .arg(QStringLiteral(TAA_VERSION),
                 QString::fromStdString(window_.session().status().driver.renderer),
                 QString::fromLatin1(qVersion())),
        QMessageBox::Close, &window_);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
}

void Menus::makeCameras() {
  const Status& status = window_.session().status();
  if (status.cameras != cameraNames_) {
    cameraNames_ = status.cameras;
    cameras_->clear();
    for (const std::string& name : cameraNames_) {
      const QString text = QString::fromStdString(name);
      cameras_->addAction(text, &window_.session(), [this, text] { window_.session().setCamera(text); })
          ->setCheckable(true);
    }
  }
  for (QAction* action : cameras_->actions())
    action->setChecked(action->text().toStdString() == status.camera);
}

// A submenu for each object of the scene, with the motion it is given.
void Menus::makeObjects() {
  const Status& status = window_.session().status();
  if (status.objects != objectNames_) {
    objectNames_ = status.objects;
    objects_->clear();
    for (const std::string& name : objectNames_) {
      QMenu* menu = objects_->addMenu(QString::fromStdString(name).replace(u'&', QStringLiteral("&&")));
      for (std::size_t mode = 0; mode < kMotionModes.size(); ++mode)
        menu->addAction(
                QString::fromUtf8(kMotionModes[mode].label.data()), &window_.session(),
                [this, name, mode] { window_.session().setMotionMode(name, static_cast<MotionMode>(mode)); })
            ->setCheckable(true);
    }
  }
  objects_->setEnabled(!objectNames_.empty());
  for (int object = 0; object < objects_->actions().size(); ++object) {
    const auto chosen = std::ranges::find(status.motionModes, objectNames_[static_cast<std::size_t>(object)],
                                          &MotionOverride::node);
    const MotionMode current = chosen == status.motionModes.end() ? MotionMode::PerObject : chosen->mode;
    const QList<QAction*> modes = objects_->actions().at(object)->menu()->actions();
    for (int mode = 0; mode < modes.size(); ++mode)
      modes.at(mode)->setChecked(static_cast<int>(current) == mode);
  }
}

void Menus::refresh() {
  const Session& session = window_.session();
  const ViewArea* views = window_.views();
  twoViews_->setChecked(views->showsTwo());
  linked_->setChecked(views->areLinked());
  profiler_->setChecked(!window_.profiler()->isHidden());
  looping_->setChecked(session.isLooping());
  marks_->setChecked(views->active()->style().markInvalid);
  play_->setText(session.status().playing ? tr("&Pause") : tr("&Play"));
  undo_->setEnabled(session.canUndo());
  redo_->setEnabled(session.canRedo());
  for (int index = 0; index < budgets_.size(); ++index)
    budgets_[index]->setChecked(session.status().checkpointBudget == kBudgetsMiB[index] << 20);
  themes_[static_cast<int>(window_.theme())]->setChecked(true);
  arrangements_[static_cast<int>(views->arrangement())]->setChecked(true);
  makeCameras();
  makeObjects();
}

} // namespace taa::app
