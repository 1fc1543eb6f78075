#include "core/inspect/OpenedShot.h"

#include "core/capture/source/Capture.h"
#include "core/inspect/Inspector.h"
#include "core/scene/builtin/SceneSource.h"

namespace taa {

void openShotOf(Inspector& inspector, const SessionFile& session, const Progress& progress) {
  InspectedShot& shot = inspector.shot();
  if (isBuiltinScene(session.source) || !capture::isCapture(session.source))
    shot.setSize(session.size.x, session.size.y);
  shot.open(session.source, progress, session.choice);
  if (!session.camera.empty() && !session.track) shot.setCamera(session.camera);
  if (session.track) shot.setCameraTrack(*session.track);
  shot.setMotionModes(session.motionModes);
  shot.setObjectFilter(session.filter);
  shot.setObjectClasses(session.objectClasses);
  shot.setRestarts(session.restarts);
}

} // namespace taa
