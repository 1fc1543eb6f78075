// What of the window lasts: its state as JSON, sessions, shaders on disk.
#include "app/dialogs/GlslWindow.h"
#include "app/panels/LowerArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ScenePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/session/SessionKeeper.h"
#include "app/session/ShaderWatch.h"
#include "app/views/ViewArea.h"
#include "app/window/Exports.h"
#include "app/window/MainWindow.h"

#include <QFileDialog>
#include <QJsonArray>
#include <QSplitter>
#include <QTabWidget>

#include <algorithm>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

QJsonValue bytesJson(const QByteArray& bytes) {
  return QString::fromLatin1(bytes.toBase64());
}

QByteArray jsonBytes(const QJsonValue& value) {
  return QByteArray::fromBase64(value.toString().toLatin1());
}

QJsonArray pinsJson(const std::vector<ProbePin>& pins) {
  QJsonArray array;
  for (const ProbePin& pin : pins)
    array << QJsonObject{{QStringLiteral("x"), pin.pixel.x},
                         {QStringLiteral("y"), pin.pixel.y},
                         {QStringLiteral("frame"), pin.frame},
                         {QStringLiteral("followsSurface"), pin.follow == Follow::Surface}};
  return array;
}

std::vector<ProbePin> pinsFrom(const QJsonArray& array) {
  std::vector<ProbePin> pins;
  for (const QJsonValue& value : array) {
    const QJsonObject pin = value.toObject();
    if (static_cast<int>(pins.size()) < kMostPins)
      pins.push_back(
          {{std::max(0, pin[QStringLiteral("x")].toInt()), std::max(0, pin[QStringLiteral("y")].toInt())},
           pin[QStringLiteral("followsSurface")].toBool() ? Follow::Surface : Follow::Screen,
           std::max(0, pin[QStringLiteral("frame")].toInt()),
           {}});
  }
  return pins;
}

} // namespace

QJsonObject MainWindow::state() const {
  QJsonObject state;
  state[QStringLiteral("views")] = views_->state();
  state[QStringLiteral("timeline")] = timeline_->state();
  state[QStringLiteral("plots")] = plots_->state();
  state[QStringLiteral("pipeline")] = pipeline_->state();
  state[QStringLiteral("probe")] = probe_->state();
  state[QStringLiteral("scene")] = session_.sceneState();
  state[QStringLiteral("sceneTree")] = scene_->state();
  state[QStringLiteral("pins")] = pinsJson(session_.pins());
  state[QStringLiteral("activePin")] = session_.activePin();
  state[QStringLiteral("looping")] = session_.isLooping();
  state[QStringLiteral("referenceSamples")] = session_.status().referenceGoal;
  QJsonObject panels;
  panels[QStringLiteral("pipeline")] = !left_->isHidden();
  panels[QStringLiteral("scene")] = left_->currentWidget() == scene_;
  panels[QStringLiteral("probe")] = !probe_->isHidden();
  panels[QStringLiteral("lower")] =
      lower_->shows(lower_->current()) ? lowerPageId(lower_->current()) : QString();
  state[QStringLiteral("panels")] = panels;
  state[QStringLiteral("columns")] = bytesJson(columns_->saveState());
  if (lower_->shows(lower_->current())) // else nothing is divided
    state[QStringLiteral("rows")] = bytesJson(rows_->saveState());
  return state;
}

void MainWindow::setState(const QJsonObject& state) {
  const UndoStack::Quiet quiet(session_.undoStack());
  const QJsonObject panels = state[QStringLiteral("panels")].toObject();
  const std::pair<QString, QWidget*> known[] = {{QStringLiteral("pipeline"), pipeline_},
                                                {QStringLiteral("probe"), probe_}};
  for (const auto& [key, panel] : known)
    if (panels[key].isBool()) setPanelVisible(panel, panels[key].toBool());
  left_->setCurrentIndex(left_->indexOf(panels[QStringLiteral("scene")].toBool()
                                            ? static_cast<QWidget*>(scene_)
                                            : static_cast<QWidget*>(pipeline_)));
  if (const QJsonValue page = panels[QStringLiteral("lower")]; page.isString())
    lower_->setShown(lowerPageWithId(page.toString()).value_or(lower_->current()),
                     !page.toString().isEmpty());
  columns_->restoreState(jsonBytes(state[QStringLiteral("columns")]));
  rows_->restoreState(jsonBytes(state[QStringLiteral("rows")]));
  if (state[QStringLiteral("looping")].isBool()) {
    session_.setLooping(state[QStringLiteral("looping")].toBool());
    timeline_->setLooping(session_.isLooping());
  }
  if (const int samples = state[QStringLiteral("referenceSamples")].toInt(); samples > 0)
    session_.setReferenceSamples(samples);
  if (state[QStringLiteral("scene")].isObject())
    session_.setSceneState(state[QStringLiteral("scene")].toObject());
  const std::vector<ProbePin> pins = pinsFrom(state[QStringLiteral("pins")].toArray());
  session_.setPins(
      pins, std::clamp(state[QStringLiteral("activePin")].toInt(-1), -1, static_cast<int>(pins.size()) - 1));
  views_->setState(state[QStringLiteral("views")].toObject());
  timeline_->setState(state[QStringLiteral("timeline")].toObject());
  plots_->setState(state[QStringLiteral("plots")].toObject());
  pipeline_->setState(state[QStringLiteral("pipeline")].toObject());
  probe_->setState(state[QStringLiteral("probe")].toObject());
  scene_->setState(state[QStringLiteral("sceneTree")].toObject());
}

void MainWindow::connectFiles() {
  keeper_ = new SessionKeeper(*this, settings_);
  exports_ = new Exports(*this);
  connect(&session_, &Session::shadersReloaded, messages_, &MessagesBar::showShaders);
  connect(keeper_, &SessionKeeper::said, messages_, &MessagesBar::showNote);
  connect(keeper_, &SessionKeeper::failed, messages_, &MessagesBar::showError);
  connect(exports_, &Exports::said, messages_, &MessagesBar::showNote);
  connect(exports_, &Exports::failed, messages_, &MessagesBar::showError);
  if (const QString folder = ShaderWatch::folder(); !folder.isEmpty()) {
    shaders_ = new ShaderWatch(folder, this);
    connect(shaders_, &ShaderWatch::changed, &session_, &Session::reloadShaders);
  }
}

void MainWindow::openSource(const QString& source) {
  if (isSessionName(source.toStdString()))
    keeper_->open(source);
  else
    session_.open(source);
}

void MainWindow::askForFile() {
  auto* dialog = new QFileDialog(
      this, tr("Open a scene or a session"), {},
      tr("Scenes and sessions (*.gltf *.glb *.taa.json);;glTF 2.0 scenes (*.gltf *.glb);;Sessions "
         "(*.taa.json);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openSource);
  dialog->open();
}

void MainWindow::readGlsl() {
  auto* window = findChild<GlslWindow*>();
  if (!window) window = new GlslWindow(session_, this);
  window->showStage(intermediate(views_->active()->id()).stage);
  window->show();
  window->raise();
  window->activateWindow();
}

} // namespace taa::app
