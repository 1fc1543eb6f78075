// The tree of the scene and the flown camera in the window.
#include "app/window/MainWindow.h"

#include "app/menus/Menus.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ScenePanel.h"
#include "app/panels/StatusLine.h"
#include "app/panels/TimelinePanel.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/legend/Legend.h"
#include "app/widgets/Prompt.h"
#include "app/widgets/bars/FlightBar.h"
#include "app/window/Flight.h"
#include "core/base/Files.h"
#include "core/io/CameraTrackJson.h"

#include <QFileDialog>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

/// From the first of so many frames to the last one.
double secondsOf(int frames, const Status& status) {
  return std::max(0, frames - 1) / status.framesPerSecond;
}

int objectAt(const ProbeResult& probe) {
  return static_cast<int>(twin::at(probe.around[4], IntermediateId::objectId).x);
}

} // namespace

void MainWindow::makeLeft() {
  scene_ = new ScenePanel;
  left_ = new QTabWidget;
  left_->setDocumentMode(true);
  left_->setObjectName(QStringLiteral("left"));
  left_->setAccessibleName(tr("Pipeline or scene"));
  left_->tabBar()->setAccessibleName(tr("Pipeline or scene"));
  left_->tabBar()->setDrawBase(false);
  for (QWidget* panel : {static_cast<QWidget*>(left_), static_cast<QWidget*>(scene_)}) {
    panel->setAutoFillBackground(true);
    panel->setBackgroundRole(QPalette::AlternateBase);
  }
  left_->addTab(pipeline_, tr("Pipeline"));
  left_->addTab(scene_, tr("Scene"));
  flight_ = new Flight(session_, views_, this);
  flightBar_ = new FlightBar(views_, kLegendHeight + 8);
}

void MainWindow::connectScene() {
  connect(pipeline_, &PipelinePanel::comparisonRequested, this, &MainWindow::comparePresets);
  showUserPresets();
  connect(&session_, &Session::stageSharesArrived, pipeline_, &PipelinePanel::setShares);
  connect(&session_, &Session::statusChanged, pipeline_,
          [this] { pipeline_->setFrame(session_.status().info.frame, session_.status().playing); });
  connect(scene_, &ScenePanel::hiddenAsked, &session_, &Session::setHidden);
  connect(scene_, &ScenePanel::isolationAsked, &session_, &Session::setIsolated);
  connect(scene_, &ScenePanel::filterAsked, &session_, &Session::setObjectFilter);
  connect(scene_, &ScenePanel::motionAsked, &session_, &Session::setMotionMode);
  connect(scene_, &ScenePanel::classAsked, &session_, &Session::setObjectClass);
  connect(scene_, &ScenePanel::locationAsked, &session_, &Session::locate);
  connect(scene_, &ScenePanel::revealAsked, this, [this](glm::ivec2 pixel) {
    reveals_ = true; // the object is selected already
    session_.setPick(pixel);
    reveals_ = false;
    views_->active()->viewport()->reveal(pixel);
  });
  connect(&session_, &Session::objectAreaArrived, scene_, &ScenePanel::setArea);
  const auto showArea = [this] {
    const auto area = scene_->area();
    views_->setFramed(area ? std::optional(area->box) : std::nullopt);
  };
  connect(scene_, &ScenePanel::areaChanged, this, showArea);
  connect(scene_, &ScenePanel::selectionChanged, this, [this] { menus_->refresh(); });
  connect(&session_, &Session::statusChanged, this, [this, showArea] {
    scene_->setStatus(session_.status());
    scene_->setChoices(session_.objectFilter(), session_.motionModes(), session_.objectClasses());
    showArea();
  });
  // A new pick selects its object; while time runs on under the probe the selection stays.
  connect(&session_, &Session::pickChanged, this, [this] { selectsPicked_ = !reveals_; });
  connect(&session_, &Session::probeArrived, this, [this] {
    const ProbeResult* probe = session_.probe();
    // There is nothing around a pin that is off the screen or not there yet.
    if (!probe || probe->around.size() < 5 || !selectsPicked_ ||
        session_.pick() != glm::ivec2(probe->x, probe->y))
      return;
    selectsPicked_ = false;
    scene_->selectObject(objectAt(*probe));
  });
  connect(flight_, &Flight::changed, this, [this] {
    flightBar_->setFlight(flight_->isOn(), static_cast<double>(flight_->speed()));
    flightBar_->setRecording(
        flight_->isRecording()
            ? std::optional(std::pair(flight_->recordedFrames(),
                                      secondsOf(flight_->recordedFrames(), session_.status())))
            : std::nullopt);
    menus_->refresh();
  });
  connect(flight_, &Flight::recorded, this, [this](const CameraTrackHandle& track) {
    const int frames = static_cast<int>(track->poses.size());
    messages_->showNote(tr("%1 has %n frames from frame %2 on, %3 s.", nullptr, frames)
                            .arg(QString::fromStdString(track->name))
                            .arg(track->firstFrame)
                            .arg(secondsOf(frames, session_.status()), 0, 'f', 2));
  });
  connect(flightBar_, &FlightBar::recordRequested, flight_, &Flight::toggleRecording);
  connect(flightBar_, &FlightBar::resetRequested, flight_, &Flight::reset);
  connect(flightBar_, &FlightBar::endRequested, flight_, [this] { flight_->setOn(false); });
}

// The Tab key goes through the areas as the eye does; within one, in the order in which it was made.
void MainWindow::orderFocus() {
  const QWidget* areas[] = {messages_, left_, views_, probe_, rows_, timeline_, statusLine_};
  const auto areaOf = [&](const QWidget* widget) {
    return std::ranges::find_if(areas, [&](const QWidget* area) { return area->isAncestorOf(widget); });
  };
  // What rows_ holds besides the columns lies below them: areas are looked through in their order.
  std::vector<QWidget*> order;
  for (QWidget* at = nextInFocusChain(); at != this; at = at->nextInFocusChain())
    if (at->focusPolicy() != Qt::NoFocus && areaOf(at) != std::end(areas)) order.push_back(at);
  std::ranges::stable_sort(order, {}, areaOf);
  for (std::size_t i = 1; i < order.size(); ++i) setTabOrder(order[i - 1], order[i]);
}

void MainWindow::showScene(bool shown) {
  left_->setVisible(true);
  left_->setCurrentWidget(shown ? static_cast<QWidget*>(scene_) : pipeline_);
  menus_->refresh();
}

void MainWindow::searchPipeline() {
  showScene(false);
  pipeline_->focusSearch();
}

CameraTrackHandle MainWindow::flownCamera() const {
  const Status& status = session_.status();
  for (const CameraTrackHandle& track : status.tracks)
    if (track->name == status.camera) return track;
  return nullptr;
}

void MainWindow::askToSaveCamera() {
  const CameraTrackHandle track = flownCamera();
  if (!track) return;
  auto* dialog = new QFileDialog(this, tr("Save the flown camera"), QString::fromStdString(track->name),
                                 tr("Camera paths (*.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("json"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, track](const QString& file) {
    try {
      writeFile(file.toStdString(), cameraTrackJson(*track).dump(1) + '\n');
    } catch (const Error& error) {
      messages_->showError(QString::fromUtf8(error.what()));
    }
  });
  dialog->open();
}

void MainWindow::askForCameraName() {
  const CameraTrackHandle track = flownCamera();
  if (!track) return;
  auto* prompt = new Prompt(
      tr("Name of the flown camera"), QString::fromStdString(track->name),
      [this, name = track->name](const QString& text) {
        return session_.renameCamera(name, text.trimmed().toStdString());
      },
      this);
  prompt->open();
}

void MainWindow::askForCamera() {
  auto* dialog = new QFileDialog(this, tr("Open a recorded camera"), {}, tr("Camera paths (*.json)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    try {
      session_.addCameraTrack(readCameraTrack(file.toStdString()));
    } catch (const Error& error) {
      messages_->showError(QString::fromUtf8(error.what()));
    }
  });
  dialog->open();
}

} // namespace taa::app
