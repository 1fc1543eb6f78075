// What the frames are a function of: source, size, camera, settings, objects. Changed as requests say.
#pragma once

#include "core/jobs/context/JobContext.h"
#include "core/jobs/shot/CameraFlight.h"
#include "core/jobs/shot/Previews.h"
#include "core/jobs/shot/SeekTarget.h"
#include "core/requests/Requests.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace taa {

class ShotChanges {
 public:
  ShotChanges(JobContext& jobContext, CameraFlight& flight, SeekTarget& seekTarget, Previews& previews)
      : jobContext_(jobContext), flight_(flight), seekTarget_(seekTarget), previews_(previews) {}

  /// Whether it could be opened.
  bool open(const request::Open& open);

  void take(const request::SetSize& size);
  void take(const request::SetFlownCameras& flown);
  void take(const request::AddCameraTrack& added);
  void take(const request::SetCamera& camera);
  void take(const request::SetMotionModes& modes);
  void take(const request::SetSettings& settings);
  void take(const request::SetOtherLanes& others);
  void take(const request::SetObjectFilter& filter);
  void take(const request::SetObjectClasses& classes);
  void take(const request::SetRestarts& restarts);
  void take(const request::SetCheckpointBudget& budget);
  void take(const request::SetSceneBudget& budget);

  // Of the scene that is open
  const std::vector<std::string>& objects() const { return objects_; } ///< see Status
  const std::shared_ptr<const SceneOutline>& outline() const { return outline_; }
  RequestId opened() const { return opened_; } ///< the request that opened it

 private:
  /// What is so already is no change.
  void changeIf(bool isOther, RequestKind kind, const std::function<void()>& action);

  JobContext& jobContext_;
  CameraFlight& flight_;
  SeekTarget& seekTarget_;
  Previews& previews_;
  std::vector<std::string> objects_;
  std::shared_ptr<const SceneOutline> outline_;
  RequestId opened_ = 0;
};

} // namespace taa
