// What of the window lasts: its state as JSON, sessions, shaders on disk.
#include "app/Exports.h"
#include "app/MainWindow.h"
#include "app/SessionKeeper.h"
#include "app/ShaderWatch.h"
#include "app/panels/LowerArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/views/ViewArea.h"
#include "app/widgets/GlslWindow.h"

#include <QFileDialog>
#include <QJsonArray>
#include <QSplitter>

namespace taa::app {

namespace {

/// The state of a part of the window that has one.
template <class Part>
void keepPart(QJsonObject& state, const QString& key, const Part& part) {
  if constexpr (requires { part.state(); }) state[key] = part.state();
}

template <class Part>
void restorePart(const QJsonObject& state, const QString& key, Part& part) {
  if constexpr (requires { part.setState(QJsonObject()); })
    if (state[key].isObject()) part.setState(state[key].toObject());
}

template <class Shot>
void keepScene(QJsonObject& state, const Shot& shot) {
  if constexpr (requires { shot.sceneState(); }) state[QStringLiteral("scene")] = shot.sceneState();
}

template <class Shot>
void restoreScene(const QJsonObject& state, Shot& shot) {
  if constexpr (requires { shot.setSceneState(QJsonObject()); })
    if (state[QStringLiteral("scene")].isObject())
      shot.setSceneState(state[QStringLiteral("scene")].toObject());
}

QJsonValue bytesJson(const QByteArray& bytes) {
  return QString::fromLatin1(bytes.toBase64());
}

QByteArray jsonBytes(const QJsonValue& value) {
  return QByteArray::fromBase64(value.toString().toLatin1());
}

} // namespace

QJsonObject MainWindow::state() const {
  QJsonObject state;
  keepPart(state, QStringLiteral("views"), *views_);
  keepPart(state, QStringLiteral("pipeline"), *pipeline_);
  keepPart(state, QStringLiteral("probe"), *probe_);
  keepPart(state, QStringLiteral("timeline"), *timeline_);
  keepPart(state, QStringLiteral("plots"), *plots_);
  keepScene(state, session_);
  if (const auto pick = session_.pick()) state[QStringLiteral("pick")] = QJsonArray{pick->x, pick->y};
  state[QStringLiteral("looping")] = session_.isLooping();
  QJsonObject panels;
  panels[QStringLiteral("pipeline")] = !pipeline_->isHidden();
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
  const QJsonObject panels = state[QStringLiteral("panels")].toObject();
  const std::pair<QString, QWidget*> known[] = {{QStringLiteral("pipeline"), pipeline_},
                                                {QStringLiteral("probe"), probe_}};
  for (const auto& [key, panel] : known)
    if (panels[key].isBool()) setPanelVisible(panel, panels[key].toBool());
  if (const QJsonValue page = panels[QStringLiteral("lower")]; page.isString())
    lower_->setShown(lowerPageWithId(page.toString()).value_or(lower_->current()),
                     !page.toString().isEmpty());
  columns_->restoreState(jsonBytes(state[QStringLiteral("columns")]));
  rows_->restoreState(jsonBytes(state[QStringLiteral("rows")]));
  if (state[QStringLiteral("looping")].isBool()) {
    session_.setLooping(state[QStringLiteral("looping")].toBool());
    timeline_->setLooping(session_.isLooping());
  }
  restoreScene(state, session_);
  const QJsonArray pick = state[QStringLiteral("pick")].toArray();
  if (pick.size() == 2)
    session_.setPick(glm::ivec2(pick[0].toInt(), pick[1].toInt()));
  else
    session_.setPick({});
  restorePart(state, QStringLiteral("views"), *views_);
  restorePart(state, QStringLiteral("pipeline"), *pipeline_);
  restorePart(state, QStringLiteral("probe"), *probe_);
  restorePart(state, QStringLiteral("timeline"), *timeline_);
  restorePart(state, QStringLiteral("plots"), *plots_);
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
