// What the session asks of the scene: hidden objects, motion modes, the camera that is flown.
#include "app/session/Session.h"

#include "core/io/CameraTrackJson.h"

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

void Session::takeSceneStatus() {
  motionModes_.arrived(status_.motionModes);
  filter_.arrived(status_.filter);
  classes_.arrived(status_.objectClasses);
  restarts_.arrived(status_.restarts);
  FlownCameras flown{{}, status_.camera};
  for (const CameraTrackHandle& track : status_.tracks) flown.tracks.push_back(*track);
  flown_.arrived(flown);
  const bool isFlown = std::ranges::any_of(
      status_.tracks, [&](const CameraTrackHandle& track) { return track->name == status_.camera; });
  if (!isFlown) sceneCamera_ = status_.camera;
}

void Session::setMotionMode(const std::string& object, MotionMode mode) {
  std::vector<MotionOverride> modes = motionModes_.value();
  std::erase_if(modes, [&](const MotionOverride& known) { return known.node == object; });
  modes.push_back({object, mode});
  setMotionModes(modes);
}

void Session::noteScene(UndoStep step, const QString& what) {
  step.what = what;
  step.isVoid = nullptr; // what was asked for may not be there yet
  step.ofScene = true;
  if (isOpen()) undo_.push(std::move(step));
}

// To be called before something is asked of the scene that undo is to take back.
template <class Value>
void Session::noteAsked(const Asked<Value>& asked, const Value& value, void (Session::*set)(const Value&),
                        const QString& what) {
  if (value == asked.value()) return;
  noteScene(stepBackTo<Value>(
                asked.value(), [&asked] { return asked.value(); },
                [this, set](const Value& before) { (this->*set)(before); }),
            what);
}

void Session::setMotionModes(const std::vector<MotionOverride>& modes) {
  noteAsked(motionModes_, modes, &Session::setMotionModes, tr("change of how objects move"));
  motionModes_.ask(modes, ask(request::SetMotionModes{modes}));
}

void Session::setObjectFilter(const ObjectFilter& filter) {
  noteAsked(filter_, filter, &Session::setObjectFilter, tr("change of what is drawn"));
  // Also where it is the same: what was just opened has none.
  filter_.ask(filter, ask(request::SetObjectFilter{filter}));
}

void Session::setHidden(const std::string& object, bool hidden) {
  ObjectFilter filter = filter_.value();
  std::erase(filter.hidden, object);
  if (hidden) filter.hidden.push_back(object);
  setObjectFilter(filter);
}

void Session::setIsolated(const std::vector<std::string>& objects) {
  ObjectFilter filter = filter_.value();
  filter.isolated = objects;
  setObjectFilter(filter);
}

void Session::setObjectClass(const std::string& object, std::optional<ObjectClass> objectClass) {
  std::vector<ClassOverride> classes = classes_.value();
  std::erase_if(classes, [&](const ClassOverride& known) { return known.object == object; });
  if (objectClass) classes.push_back({object, *objectClass});
  setObjectClasses(classes);
}

void Session::setObjectClasses(const std::vector<ClassOverride>& classes) {
  noteAsked(classes_, classes, &Session::setObjectClasses, tr("change of what class objects are of"));
  classes_.ask(classes, ask(request::SetObjectClasses{classes}));
}

void Session::toggleRestart(int frame) {
  std::vector<int> frames = restarts_.value();
  if (std::erase(frames, frame) == 0) frames.push_back(frame);
  std::ranges::sort(frames);
  setRestarts(frames);
}

void Session::removeRestarts() {
  setRestarts({});
}

void Session::setRestarts(const std::vector<int>& frames) {
  noteAsked(restarts_, frames, &Session::setRestarts, tr("change of where history restarts"));
  restarts_.ask(frames, ask(request::SetRestarts{frames}));
}

void Session::useCameras(const FlownCameras& cameras) {
  flown_.ask(cameras, ask(request::SetFlownCameras{cameras}));
}

// To be called before the cameras change.
void Session::noteCameras(const QString& what, const std::string& key) {
  UndoStep step = stepBackTo<FlownCameras>(
      flown_.value(), [this] { return flown_.value(); },
      [this](const FlownCameras& before) { useCameras(before); });
  step.key = key;
  noteScene(std::move(step), what);
}

// A flight is a part of its recording.
void Session::fly(const CameraPose& pose, std::chrono::duration<double> took) {
  if (!status_.recording) noteCameras(tr("flight"), kFlight);
  flown_.giveUp();
  const auto ticks = std::chrono::duration_cast<FlightRecording::Clock::duration>(took);
  ask(request::Fly{pose, ticks});
}

void Session::setRecording(bool recording) {
  if (recording && !status_.recording) {
    undo_.endGesture();
    noteCameras(tr("recording of a flight"), kFlight);
  }
  flown_.giveUp();
  ask(request::SetRecording{recording});
}

void Session::addCameraTrack(const CameraTrack& track) {
  noteCameras(tr("opening of camera %1").arg(QString::fromStdString(track.name)));
  flown_.giveUp();
  ask(request::AddCameraTrack{track});
}

void Session::replaceCamera(const std::optional<CameraTrack>& before,
                            const std::optional<CameraTrack>& after) {
  std::string scenes = sceneCamera_;
  if (scenes.empty() && !status_.cameras.empty()) scenes = status_.cameras.front(); // the scene's come first
  useCameras(replaced(flown_.value(), before, after, scenes));
}

void Session::removeCamera(const std::string& name) {
  const auto track = trackNamed(flown_.value(), name);
  if (!track) return;
  noteCameras(tr("removal of camera %1").arg(QString::fromStdString(name)));
  replaceCamera(track, {});
}

bool Session::renameCamera(const std::string& name, const std::string& newName) {
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

void Session::backToSceneCamera() {
  if (!sceneCamera_.empty()) setCamera(QString::fromStdString(sceneCamera_));
}

void Session::locate(const std::vector<int>& objects) {
  ask(request::Locate{objects});
}

QJsonObject Session::sceneState() const {
  QJsonArray tracks;
  for (const CameraTrackHandle& track : status_.tracks)
    tracks << QJsonDocument::fromJson(QByteArray::fromStdString(cameraTrackJson(*track).dump())).object();
  return {{QStringLiteral("camera"), QString::fromStdString(status_.camera)},
          {QStringLiteral("tracks"), tracks}};
}

void Session::setSceneState(const QJsonObject& state) {
  guarded([&] {
    for (const QJsonValue& track : state[QStringLiteral("tracks")].toArray()) {
      const QByteArray text = QJsonDocument(track.toObject()).toJson();
      addCameraTrack(cameraTrackFrom(nlohmann::ordered_json::parse(text.toStdString())));
    }
  });
  const QString camera = state[QStringLiteral("camera")].toString();
  if (!camera.isEmpty()) setCamera(camera);
}

} // namespace taa::app
