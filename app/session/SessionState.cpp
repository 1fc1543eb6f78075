// The session as a file says it, and back.
#include "app/session/Session.h"

#include <cstddef>
#include <optional>
#include <utility>

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

void Session::restore(const SessionFile& file) {
  std::optional<SessionFile> before;
  if (isOpen()) before = this->file();
  open(QString::fromStdString(file.source), false);
  beforeOpening_ = std::move(before);
  apply(file);
}

void Session::apply(const SessionFile& file) {
  const UndoStack::Quiet quiet(undo_);
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
}

void Session::exportSequence(const SequenceRequest& request) {
  ask(request::ExportSequence{request});
}

} // namespace taa::app
