#include "core/sweep/ShotSweep.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/source/Capture.h"
#include "core/inspect/Inspector.h"
#include "core/scene/SceneSource.h"

#include <string_view>

namespace taa {

void openShotOf(Inspector& inspector, const SessionFile& session, const Progress& progress) {
  InspectedShot& shot = inspector.shot();
  if (isBuiltinScene(session.source) || !capture::isCapture(session.source))
    shot.setSize(session.size.x, session.size.y);
  shot.open(session.source, progress);
  if (!session.camera.empty() && !session.track) shot.setCamera(session.camera);
  if (session.track) shot.setCameraTrack(*session.track);
  shot.setMotionModes(session.motionModes);
  shot.setObjectFilter(session.filter);
  shot.setObjectClasses(session.objectClasses);
  shot.setRestarts(session.restarts);
}

void sweepShot(const ShotSweepRequest& request, const SettingsMeasured& measured, const Progress& progress) {
  if (request.settings.empty()) return;
  const int frames = request.metrics.last - request.metrics.first + 1;
  const int total = frames * static_cast<int>(request.settings.size());
  int done = 0;
  const auto tell = [&] { return !progress || progress(say<"Measuring settings">(), done, total); };
  // What is done between frames only asks whether to stop.
  const Progress between = [&](std::string_view, int, int) { return tell(); };
  Inspector inspector;
  inspector.shot().setSettings(request.settings.front().settings);
  openShotOf(inspector, request.shot, between);
  requireMeasurable(inspector, request.metrics.referenceSamples);
  keepReferences(inspector, request.metrics);
  for (std::size_t index = 0; index < request.settings.size(); ++index) {
    const int before = static_cast<int>(index) * frames;
    const auto count = [&](int frame) { done = before + frame - request.metrics.first; };
    inspector.shot().setSettings(request.settings[index].settings);
    measured(index, measureFrames(inspector, request.metrics, between, count).front());
  }
}

} // namespace taa
