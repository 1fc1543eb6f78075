// The session as a file says it, and back.
#include "app/Session.h"

#include <cstddef>

namespace taa::app {

SessionFile Session::file() const {
  SessionFile file;
  file.source = status_.source;
  file.camera = sceneCamera_;
  for (const CameraTrackHandle& track : status_.tracks)
    if (track->name == status_.camera) file.track = *track;
  file.filter = filter_.value();
  file.frame = status_.goal.value_or(status_.info.frame);
  file.size = {status_.width, status_.height};
  file.settings = {presetId_, presetSettings_, settings_};
  file.motionModes = motionModes_.value();
  file.objectClasses = classes_.value();
  file.restarts = restarts_.value();
  file.checkpointsMiB = static_cast<int>(status_.checkpointBudget >> 20);
  return file;
}

void Session::restore(const SessionFile& file) {
  open(QString::fromStdString(file.source), false);
  setPlaying(false);
  history_.record({settings_}, "");
  presetId_ = file.settings.preset;
  presetSettings_ = file.settings.presetSettings;
  useSettings(file.settings.settings);
  setSize(file.size.x, file.size.y);
  setCheckpointBudget(static_cast<std::size_t>(file.checkpointsMiB) << 20);
  if (file.track)
    addCameraTrack(*file.track);
  else if (!file.camera.empty())
    setCamera(QString::fromStdString(file.camera));
  setObjectFilter(file.filter);
  setMotionModes(file.motionModes);
  setObjectClasses(file.objectClasses);
  setRestarts(file.restarts);
  seek(file.frame);
  Q_EMIT settingsChanged(); // the name changes even where no value does
}

void Session::exportSequence(const SequenceRequest& request) {
  ask([&](Renderer& renderer) { renderer.exportSequence(request); });
}

} // namespace taa::app
