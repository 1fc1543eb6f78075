// What the session asks of the scene: hidden objects, motion modes, the camera that is flown.
#include "app/Session.h"

#include "core/io/CameraTrackJson.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace taa::app {

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

void Session::setMotionModes(const std::vector<MotionOverride>& modes) {
  motionModes_.ask(modes);
  ask([&](Renderer& renderer) { renderer.setMotionModes(modes); });
}

void Session::setObjectFilter(const ObjectFilter& filter) {
  filter_.ask(filter); // also where it is the same: what was just opened has none
  ask([&](Renderer& renderer) { renderer.setObjectFilter(filter); });
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
  classes_.ask(classes);
  ask([&](Renderer& renderer) { renderer.setObjectClasses(classes); });
}

void Session::toggleRestart(int frame) {
  std::vector<int> frames = restarts_.value();
  if (std::erase(frames, frame) == 0) frames.push_back(frame);
  std::ranges::sort(frames);
  changeRestarts(frames);
}

void Session::removeRestarts() {
  changeRestarts({});
}

void Session::changeRestarts(const std::vector<int>& frames) {
  if (frames == restarts_.value()) return;
  history_.record({settings_, {}, RestartChange{restarts_.value(), frames}}, "");
  setRestarts(frames);
  Q_EMIT settingsChanged(); // there is a step more
}

void Session::setRestarts(const std::vector<int>& frames) {
  restarts_.ask(frames);
  ask([&](Renderer& renderer) { renderer.setRestarts(frames); });
}

void Session::fly(const CameraPose& pose) {
  flown_.giveUp();
  ask([&](Renderer& renderer) { renderer.fly(pose); });
}

void Session::setRecording(bool recording) {
  flown_.giveUp();
  ask([&](Renderer& renderer) { renderer.setRecording(recording); });
}

void Session::addCameraTrack(const CameraTrack& track) {
  flown_.giveUp();
  ask([&](Renderer& renderer) { renderer.addCameraTrack(track); });
}

namespace {

std::optional<CameraTrack> trackNamed(const FlownCameras& cameras, const std::string& name) {
  const auto found = std::ranges::find(cameras.tracks, name, &CameraTrack::name);
  return found == cameras.tracks.end() ? std::nullopt : std::optional(*found);
}

} // namespace

void Session::useCamera(const std::optional<CameraTrack>& before, const std::optional<CameraTrack>& after) {
  std::string scenes = sceneCamera_;
  if (scenes.empty() && !status_.cameras.empty()) scenes = status_.cameras.front(); // the scene's come first
  flown_.ask(replaced(flown_.value(), before, after, scenes));
  ask([&](Renderer& renderer) { renderer.setFlownCameras(flown_.value()); });
  Q_EMIT settingsChanged(); // there is a step more or less
}

void Session::removeCamera(const std::string& name) {
  const auto track = trackNamed(flown_.value(), name);
  if (!track) return;
  history_.record({settings_, CameraChange{track, {}}}, "");
  useCamera(track, {});
}

bool Session::renameCamera(const std::string& name, const std::string& newName) {
  const auto track = trackNamed(flown_.value(), name);
  if (!track || name == newName) return track.has_value();
  const bool isTaken =
      trackNamed(flown_.value(), newName) || std::ranges::count(status_.cameras, newName) > 0;
  if (newName.empty() || isTaken) return false;
  CameraTrack after = *track;
  after.name = newName;
  history_.record({settings_, CameraChange{track, after}}, "");
  useCamera(track, after);
  return true;
}

void Session::backToSceneCamera() {
  if (!sceneCamera_.empty()) setCamera(QString::fromStdString(sceneCamera_));
}

void Session::locate(const std::vector<int>& objects) {
  ask([&](Renderer& renderer) { renderer.locate(objects); });
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
