#include "core/jobs/shot/ShotChanges.h"

#include "core/settings/Parameters.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace taa {

bool ShotChanges::open(const request::Open& open) {
  flight_.end(); // of the old one, which stays where the new one is refused
  seekTarget_.frame.reset();
  InspectedShot& shot = jobContext_.inspector.shot();
  const Progress told = [this](std::string_view doing, int done, int total) {
    if (jobContext_.waiting().stopOpening()) return false;
    jobContext_.tellWork(WorkKind::Opening, std::string(doing), done, total);
    return true;
  };
  const bool isOpened = jobContext_.change(RequestKind::Source, [&] {
    shot.open(open.source, told, open.choice, open.budget);
    objects_ = objectNames(shot.scene());
    objects_.resize(std::min(objects_.size(), kMaxObjects));
    outline_ = std::make_shared<const SceneOutline>(outlineOf(shot.scene(), shot.source()));
  });
  if (isOpened) opened_ = jobContext_.latest(RequestKind::Source);
  jobContext_.endWork();
  return isOpened;
}

void ShotChanges::changeIf(bool isOther, RequestKind kind, const std::function<void()>& action) {
  if (isOther) jobContext_.change(kind, action);
}

void ShotChanges::take(const request::SetSize& size) {
  InspectedShot& shot = jobContext_.inspector.shot();
  changeIf(size.width != shot.width() || size.height != shot.height(), RequestKind::Size,
           [&] { shot.setSize(size.width, size.height); });
}

void ShotChanges::take(const request::SetFlownCameras& flown) {
  flight_.end();
  changeIf(jobContext_.isOpen(), RequestKind::FlownCameras,
           [&] { jobContext_.inspector.shot().setFlownCameras(flown.cameras); });
}

void ShotChanges::take(const request::AddCameraTrack& added) {
  flight_.end();
  changeIf(jobContext_.isOpen(), RequestKind::FlownCameras,
           [&] { jobContext_.inspector.shot().setCameraTrack(added.track); });
}

void ShotChanges::take(const request::SetCamera& camera) {
  flight_.end();
  InspectedShot& shot = jobContext_.inspector.shot();
  changeIf(jobContext_.isOpen() && camera.name != shot.camera(), RequestKind::Camera,
           [&] { shot.setCamera(camera.name); });
}

void ShotChanges::take(const request::SetMotionModes& modes) {
  InspectedShot& shot = jobContext_.inspector.shot();
  changeIf(jobContext_.isOpen() && modes.modes != shot.motionModes(), RequestKind::MotionModes,
           [&] { shot.setMotionModes(modes.modes); });
}

void ShotChanges::take(const request::SetSettings& settings) {
  InspectedShot& shot = jobContext_.inspector.shot();
  if (settings.settings == shot.settings()) {
    previews_.withdraw();
    return;
  }
  if (previews_.tell(settings.settings)) return; // newer ones are taken up next
  if (jobContext_.change(RequestKind::Settings, [&] { shot.setSettings(settings.settings); }))
    previews_.cameTrue();
  else
    previews_.withdraw();
}

// Lane 0 is the one of the settings.
void ShotChanges::take(const request::SetOtherLanes& others) {
  InspectedShot& shot = jobContext_.inspector.shot();
  jobContext_.change(RequestKind::Lanes, [&] {
    std::vector<Settings> lanes{shot.settings()};
    lanes.insert(lanes.end(), others.lanes.begin(), others.lanes.end());
    shot.changeLanes(lanes);
  });
}

void ShotChanges::take(const request::SetObjectFilter& filter) {
  InspectedShot& shot = jobContext_.inspector.shot();
  changeIf(jobContext_.isOpen() && !(filter.filter == shot.objectFilter()), RequestKind::Objects,
           [&] { shot.setObjectFilter(filter.filter); });
}

void ShotChanges::take(const request::SetObjectClasses& classes) {
  InspectedShot& shot = jobContext_.inspector.shot();
  changeIf(jobContext_.isOpen() && classes.classes != shot.objectClasses(), RequestKind::Classes,
           [&] { shot.setObjectClasses(classes.classes); });
}

void ShotChanges::take(const request::SetRestarts& restarts) {
  InspectedShot& shot = jobContext_.inspector.shot();
  changeIf(jobContext_.isOpen() && restarts.frames != shot.restarts(), RequestKind::Restarts,
           [&] { shot.setRestarts(restarts.frames); });
}

void ShotChanges::take(const request::SetCheckpointBudget& budget) {
  jobContext_.inspector.shot().setCheckpointBudget(budget.bytes);
  jobContext_.isStatusOld = true;
}

void ShotChanges::take(const request::SetSceneBudget& budget) {
  jobContext_.inspector.shot().setSceneBudget(budget.budget);
}

} // namespace taa
