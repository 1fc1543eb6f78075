#include "core/sweep/ShotSweep.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/source/Capture.h"
#include "core/gl/ContextLock.h"
#include "core/inspect/Inspector.h"
#include "core/inspect/OpenedShot.h"
#include "core/scene/builtin/SceneSource.h"

#include <memory>
#include <string_view>

namespace taa {

namespace {

/// With an Inspector of its own. Throws Error, Cancelled.
std::unique_ptr<Inspector> openedShot(const ShotSweepRequest& request, const SessionFile& session,
                                      const Progress& progress) {
  auto inspector = std::make_unique<Inspector>();
  inspector->shot().setSettings(request.settings.front().settings);
  openShotOf(*inspector, session, progress);
  requireMeasurable(*inspector, request.metrics.referenceSamples);
  const int last = inspector->shot().frameCount() - 1;
  if (request.metrics.last > last)
    throw Error(say<"%1 has frames 0 to %2, so no frame %3">(session.source, last, request.metrics.last));
  keepReferences(*inspector, request.metrics);
  return inspector;
}

} // namespace

void sweepShots(const ShotSweepRequest& request, const SettingsMeasured& measured, const Progress& progress) {
  const int frames = request.metrics.last - request.metrics.first + 1;
  const int total = frames * static_cast<int>(request.count());
  int done = 0;
  // What is done between frames only asks whether to stop.
  const Progress tell = [&](std::string_view, int, int) {
    return !progress || progress(say<"Measuring settings">(), done, total);
  };
  gl::ContextLock lock;
  const Progress between = lock.passing(tell);
  std::unique_ptr<Inspector> inspector;
  for (std::size_t index = 0; index < request.count(); ++index) {
    if (index % request.settings.size() == 0) {
      inspector.reset(); // a thread has one at a time
      inspector = openedShot(request, request.shotOf(index), between);
    }
    const int before = static_cast<int>(index) * frames;
    const auto count = [&](int frame) { done = before + frame - request.metrics.first; };
    MetricsRequest metrics = request.metrics;
    if (request.hasSupersampling && index % request.settings.size() == 0)
      metrics.wanted.push_back(Metric::Supersampling);
    inspector->shot().setSettings(request.settingsOf(index).settings);
    measured(index, measureFrames(*inspector, metrics, between, count).front());
  }
}

} // namespace taa
