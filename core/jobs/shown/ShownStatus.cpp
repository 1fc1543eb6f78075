#include "core/jobs/shown/ShownStatus.h"

#include "core/render/CaptureFacts.h"
#include "core/render/Jitter.h"

#include <utility>

namespace taa {

void ShownStatus::deliverBefore() {
  if (jobContext_.isOpen() && (seekTarget_.frame || !jobContext_.inspector.shot().isExact())) deliver();
}

void ShownStatus::deliver() {
  if (!std::exchange(jobContext_.isStatusOld, false)) return;
  const InspectedShot& shot = jobContext_.inspector.shot();
  if (jobContext_.isOpen() && shot.areAllExact()) jobContext_.noteExact();
  Status status;
  status.width = shot.width();
  status.height = shot.height();
  status.settings = shot.settings();
  status.taken = jobContext_.taken();
  status.capture = shot.capture();
  status.jitterPeriod = status.capture ? status.capture->jitterPeriod : jitterPeriod(status.settings.jitter);
  status.playing = transport_.isPlaying();
  status.driver = shot.driver();
  status.referenceGoal = subscriptions_.referenceSamples;
  status.checkpointBudget = shot.checkpointBudget();
  status.playback = transport_.playback();
  status.shotVersion = jobContext_.shotVersion();
  status.inexactSince = jobContext_.inexactSince();
  if (jobContext_.isOpen()) addShot(status);
  jobContext_.tell(RequestKind::None, std::move(status));
}

void ShownStatus::addShot(Status& status) const {
  const InspectedShot& shot = jobContext_.inspector.shot();
  status.source = shot.source();
  status.camera = shot.camera();
  status.cameras = shot.cameras();
  status.animations = shot.scene().animationNames;
  status.choice = shot.choice();
  status.warnings = shot.scene().warnings;
  status.objects = changes_.objects();
  status.motionModes = shot.motionModes();
  status.frameCount = shot.frameCount();
  status.framesPerSecond = shot.scene().shot.framesPerSecond;
  status.info = shot.info();
  status.exact = shot.isExact();
  if (seekTarget_.frame && seekTarget_.isNear && *seekTarget_.frame != shot.frame())
    status.goal = seekTarget_.frame;
  status.times = shot.times();
  status.cuts = shot.scene().shot.cuts;
  status.restarts = shot.restarts();
  status.keptFrames = shot.keptFrames();
  status.outline = changes_.outline();
  status.filter = shot.objectFilter();
  status.objectClasses = shot.objectClasses();
  status.tracks = shot.cameraTracks();
  status.pose = shot.cameraPose();
  status.recording = flight_.isRecording();
  status.recordedFrames = flight_.isRecording() ? flight_.recording().frameCount(jobContext_.now()) : 0;
  status.opened = changes_.opened();
}

} // namespace taa
