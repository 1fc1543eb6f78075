#include "core/inspect/ExaminedShot.h"

#include "core/gl/Context.h"
#include "core/gl/ContextLock.h"
#include "core/inspect/UsedShaders.h"

#include <memory>
#include <string>
#include <utility>

namespace taa {

namespace {

/// Expects the current context.
doctor::DoctorSource openedForDoctor(const SessionFile& shot, const Progress& progress) {
  doctor::DoctorSource source = doctor::openForDoctor(
      {shot.source, shot.track ? std::string() : shot.camera, shot.size, shot.settings.settings, shot.choice},
      progress);
  if (shot.track) source.request.track = std::make_shared<const CameraTrack>(*shot.track);
  source.request.motionModes = shot.motionModes;
  source.request.filter = shot.filter;
  source.request.objectClasses = shot.objectClasses;
  source.request.restarts = shot.restarts;
  return source;
}

} // namespace

doctor::Diagnosis examineShot(const ExaminationRequest& request, const doctor::DiagnosisTold& told,
                              const Progress& progress) {
  gl::ContextLock lock;
  const UsedShaders shaders; // before the context: everything is compiled from them
  const gl::Context context;
  doctor::Examination examination = doctor::examinationOf(
      openedForDoctor(request.shot, lock.passing(progress)), request.frames, request.first);
  examination.read = [draw = std::exchange(examination.read, {})](int frame) {
    const gl::ContextLock drawing;
    return draw(frame);
  };
  doctor::Diagnosis diagnosis;
  lock.restDuring([&] { diagnosis = doctor::examine(examination, progress, told); });
  return diagnosis;
}

doctor::CorrectedLook lookAtCorrectedShot(const ExaminationRequest& request,
                                          const doctor::Diagnosis& diagnosis, const Settings& healthy,
                                          const Progress& progress) {
  gl::ContextLock lock;
  const UsedShaders shaders; // before the context: everything is compiled from them
  const gl::Context context;
  const Progress passing = lock.passing(progress);
  doctor::DoctorSource source = openedForDoctor(request.shot, passing);
  return doctor::lookAtCorrected(source, diagnosis, request.shot.settings.settings, healthy, passing,
                                 request.first);
}

} // namespace taa
