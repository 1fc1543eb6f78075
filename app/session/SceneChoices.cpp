#include "app/session/SceneChoices.h"

#include "app/session/Outbox.h"
#include "app/style/Text.h"
#include "app/undo/UndoStack.h"
#include "core/io/CameraTrackJson.h"
#include "core/render/CaptureFacts.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

constexpr const char* kFlight = "flight";

std::optional<CameraTrack> trackNamed(const FlownCameras& cameras, const std::string& name) {
  const auto found = std::ranges::find(cameras.tracks, name, &CameraTrack::name);
  return found == cameras.tracks.end() ? std::nullopt : std::optional(*found);
}

} // namespace

SceneChoices::SceneChoices(Outbox& outbox, UndoStack& undo, const Status& status)
    : outbox_(outbox), undo_(undo), status_(status) {}

template <class Act>
void SceneChoices::forEachPending(const Act& act) {
  act(motionModes_);
  act(filter_);
  act(classes_);
  act(restarts_);
  act(flown_);
}

void SceneChoices::refused(RequestId request) {
  forEachPending([request](auto& pending) { pending.refused(request); });
}

void SceneChoices::giveUpBefore(RequestId opened) {
  forEachPending([opened](auto& pending) { pending.giveUpBefore(opened); });
}

void SceneChoices::takeStatus() {
  const LatestRequests& taken = status_.taken;
  motionModes_.arrived(status_.motionModes, taken.of(RequestKind::MotionModes));
  filter_.arrived(status_.filter, taken.of(RequestKind::Objects));
  classes_.arrived(status_.objectClasses, taken.of(RequestKind::Classes));
  restarts_.arrived(status_.restarts, taken.of(RequestKind::Restarts));
  FlownCameras flown{{}, status_.camera};
  for (const CameraTrackHandle& track : status_.tracks) flown.tracks.push_back(*track);
  flown_.arrived(flown, taken.of(RequestKind::FlownCameras));
  const bool isFlown = std::ranges::any_of(
      status_.tracks, [&](const CameraTrackHandle& track) { return track->name == status_.camera; });
  if (!isFlown) sceneCamera_ = status_.camera;
}

void SceneChoices::setMotionMode(const std::string& object, MotionMode mode) {
  std::vector<MotionOverride> modes = motionModes_.value();
  std::erase_if(modes, [&](const MotionOverride& known) { return known.node == object; });
  modes.push_back({object, mode});
  setMotionModes(modes);
}

void SceneChoices::note(UndoStep step, const QString& what) {
  step.what = what;
  step.isVoid = nullptr; // what was posted may not be there yet
  step.ofScene = true;
  if (status_.frameCount > 0) undo_.push(std::move(step));
}

// To be called before a change is posted that undo is to take back.
template <class Value>
void SceneChoices::noteChange(const Pending<Value>& pending, const Value& value,
                              void (SceneChoices::*set)(const Value&), const QString& what) {
  if (value == pending.value()) return;
  note(stepBackTo<Value>(
           pending.value(), [&pending] { return pending.value(); },
           [this, set](const Value& before) { (this->*set)(before); }),
       what);
}

void SceneChoices::setMotionModes(const std::vector<MotionOverride>& modes) {
  noteChange(motionModes_, modes, &SceneChoices::setMotionModes, tr("change of how objects move"));
  motionModes_.sent(modes, outbox_.post(request::SetMotionModes{modes}));
}

void SceneChoices::setObjectFilter(const ObjectFilter& filter) {
  noteChange(filter_, filter, &SceneChoices::setObjectFilter, tr("change of what is drawn"));
  // Also where it is the same: what was just opened has none.
  filter_.sent(filter, outbox_.post(request::SetObjectFilter{filter}));
}

QString SceneChoices::whyFixed() const {
  return status_.capture ? sentence(whyNoScene()) : QString();
}

QString SceneChoices::whyNoSurfaces() const {
  return status_.capture ? tr("A capture has no surfaces to follow, only pictures of them.") : QString();
}

QString SceneChoices::whyNoEngineOutput() const {
  const bool hasOutput = status_.capture && status_.capture->hasOutput;
  return hasOutput ? QString() : sentence(taa::whyNoEngineOutput());
}

void SceneChoices::setHidden(const std::string& object, bool hidden) {
  ObjectFilter filter = filter_.value();
  std::erase(filter.hidden, object);
  if (hidden) filter.hidden.push_back(object);
  setObjectFilter(filter);
}

void SceneChoices::setIsolated(const std::vector<std::string>& objects) {
  ObjectFilter filter = filter_.value();
  filter.isolated = objects;
  setObjectFilter(filter);
}

void SceneChoices::setObjectClass(const std::string& object, std::optional<ObjectClass> objectClass) {
  std::vector<ClassOverride> classes = classes_.value();
  std::erase_if(classes, [&](const ClassOverride& known) { return known.object == object; });
  if (objectClass) classes.push_back({object, *objectClass});
  setObjectClasses(classes);
}

void SceneChoices::setObjectClasses(const std::vector<ClassOverride>& classes) {
  noteChange(classes_, classes, &SceneChoices::setObjectClasses, tr("change of what class objects are of"));
  classes_.sent(classes, outbox_.post(request::SetObjectClasses{classes}));
}

void SceneChoices::toggleRestart(int frame) {
  std::vector<int> frames = restarts_.value();
  if (std::erase(frames, frame) == 0) frames.push_back(frame);
  std::ranges::sort(frames);
  setRestarts(frames);
}

void SceneChoices::removeRestarts() {
  setRestarts({});
}

void SceneChoices::setRestarts(const std::vector<int>& frames) {
  noteChange(restarts_, frames, &SceneChoices::setRestarts, tr("change of where history restarts"));
  restarts_.sent(frames, outbox_.post(request::SetRestarts{frames}));
}

void SceneChoices::useCameras(const FlownCameras& cameras) {
  flown_.sent(cameras, outbox_.post(request::SetFlownCameras{cameras}));
}

// To be called before the cameras change.
void SceneChoices::noteCameras(const QString& what, const std::string& key) {
  UndoStep step = stepBackTo<FlownCameras>(
      flown_.value(), [this] { return flown_.value(); },
      [this](const FlownCameras& before) { useCameras(before); });
  step.key = key;
  note(std::move(step), what);
}

void SceneChoices::setCamera(const QString& name) {
  if (name.toStdString() != status_.camera) noteCameras(tr("choice of camera %1").arg(name));
  flown_.giveUp();
  outbox_.post(request::SetCamera{name.toStdString()});
}

// A flight is a part of its recording.
void SceneChoices::fly(const CameraPose& pose, std::chrono::duration<double> took) {
  if (!status_.recording) noteCameras(tr("flight"), kFlight);
  flown_.giveUp();
  const auto ticks = std::chrono::duration_cast<FlightRecording::Clock::duration>(took);
  outbox_.post(request::Fly{pose, ticks});
}

void SceneChoices::setRecording(bool recording) {
  if (recording && !status_.recording) {
    undo_.endGesture();
    noteCameras(tr("recording of a flight"), kFlight);
  }
  flown_.giveUp();
  outbox_.post(request::SetRecording{recording});
}

void SceneChoices::addCameraTrack(const CameraTrack& track) {
  noteCameras(tr("opening of camera %1").arg(QString::fromStdString(track.name)));
  flown_.giveUp();
  outbox_.post(request::AddCameraTrack{track});
}

void SceneChoices::replaceCamera(const std::optional<CameraTrack>& before,
                                 const std::optional<CameraTrack>& after) {
  std::string scenes = sceneCamera_;
  if (scenes.empty() && !status_.cameras.empty()) scenes = status_.cameras.front(); // the scene's come first
  useCameras(replaced(flown_.value(), before, after, scenes));
}

void SceneChoices::removeCamera(const std::string& name) {
  const auto track = trackNamed(flown_.value(), name);
  if (!track) return;
  noteCameras(tr("removal of camera %1").arg(QString::fromStdString(name)));
  replaceCamera(track, {});
}

bool SceneChoices::renameCamera(const std::string& name, const std::string& newName) {
  const auto track = trackNamed(flown_.value(), name);
  if (!track || name == newName) return track.has_value();
  const bool isTaken =
      trackNamed(flown_.value(), newName) || std::ranges::count(status_.cameras, newName) > 0;
  if (newName.empty() || isTaken) return false;
  CameraTrack after = *track;
  after.name = newName;
  noteCameras(tr("new name of camera %1").arg(QString::fromStdString(newName)));
  replaceCamera(track, after);
  return true;
}

void SceneChoices::backToSceneCamera() {
  if (!sceneCamera_.empty()) setCamera(QString::fromStdString(sceneCamera_));
}

void SceneChoices::locate(const std::vector<int>& objects) {
  outbox_.post(request::Locate{objects});
}

QJsonObject SceneChoices::state() const {
  QJsonArray tracks;
  for (const CameraTrackHandle& track : status_.tracks)
    tracks << QJsonDocument::fromJson(QByteArray::fromStdString(cameraTrackJson(*track).dump())).object();
  return {{QStringLiteral("camera"), QString::fromStdString(status_.camera)},
          {QStringLiteral("tracks"), tracks}};
}

void SceneChoices::setState(const QJsonObject& state) {
  outbox_.guarded([&] {
    for (const QJsonValue& track : state[QStringLiteral("tracks")].toArray()) {
      const QByteArray text = QJsonDocument(track.toObject()).toJson();
      addCameraTrack(cameraTrackFrom(nlohmann::json::parse(text.toStdString())));
    }
  });
  const QString camera = state[QStringLiteral("camera")].toString();
  if (!camera.isEmpty()) setCamera(camera);
}

} // namespace taa::app
