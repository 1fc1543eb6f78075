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
  file.settings = {chosen_.presetId, chosen_.presetSettings, chosen_.settings};
  file.motionModes = motionModes_.value();
  file.objectClasses = classes_.value();
  file.restarts = restarts_.value();
  file.checkpointsMiB = static_cast<int>(status_.checkpointBudget >> 20);
  return file;
}

// What was changed before is of another session.
void Session::restore(const SessionFile& file) {
  const UndoStack::Quiet quiet(undo_);
  open(QString::fromStdString(file.source), false);
  setPlaying(false);
  use({file.settings.settings, file.settings.presetSettings, file.settings.preset});
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
  undo_.clear();
}

void Session::exportSequence(const SequenceRequest& request) {
  ask([&](Renderer& renderer) { renderer.exportSequence(request); });
}

} // namespace taa::app
