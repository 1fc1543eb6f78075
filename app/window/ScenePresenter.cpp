#include "app/window/ScenePresenter.h"

#include "app/panels/ScenePanel.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"

#include <optional>

namespace taa::app {

namespace {

int objectAt(const ProbeResult& probe) {
  return static_cast<int>(twin::at(probe.around[4], IntermediateId::objectId).x);
}

} // namespace

ScenePresenter::ScenePresenter(Session& session, ViewArea& views, ScenePanel& panel)
    : session_(session), views_(views), panel_(panel) {
  connectPanel();
  connectProbes();
  session_.onArrival<ObjectArea>(&panel_, &ScenePanel::setArea);
  connect(&panel_, &ScenePanel::areaChanged, this, &ScenePresenter::showArea);
  connect(&session_, &Session::statusChanged, this, &ScenePresenter::showStatus);
}

void ScenePresenter::connectPanel() {
  connect(&panel_, &ScenePanel::hiddenAsked, &session_.scene(), &SceneChoices::setHidden);
  connect(&panel_, &ScenePanel::isolationAsked, &session_.scene(), &SceneChoices::setIsolated);
  connect(&panel_, &ScenePanel::filterAsked, &session_.scene(), &SceneChoices::setObjectFilter);
  connect(&panel_, &ScenePanel::motionAsked, &session_.scene(), &SceneChoices::setMotionMode);
  connect(&panel_, &ScenePanel::classAsked, &session_.scene(), &SceneChoices::setObjectClass);
  connect(&panel_, &ScenePanel::locationAsked, &session_.scene(), &SceneChoices::locate);
  connect(&panel_, &ScenePanel::revealAsked, this, [this](glm::ivec2 pixel) {
    reveals_ = true; // the object is selected already
    session_.probes().setPixel(pixel);
    reveals_ = false;
    views_.active()->viewport()->reveal(pixel);
  });
}

// A new probe selects its object; while time runs on under the probe the selection stays.
void ScenePresenter::connectProbes() {
  connect(&session_.probes(), &ProbeChoices::changed, this, [this] { selectsProbed_ = !reveals_; });
  connect(&session_.probes(), &ProbeChoices::probeArrived, this, &ScenePresenter::selectProbed);
}

void ScenePresenter::selectProbed() {
  const ProbeResult* probe = session_.probes().result();
  // There is nothing around a probe that is off the screen or not there yet.
  if (!probe || probe->around.size() < 5 || !selectsProbed_ ||
      session_.probes().pixel() != glm::ivec2(probe->x, probe->y))
    return;
  selectsProbed_ = false;
  panel_.selectObject(objectAt(*probe));
}

void ScenePresenter::showStatus() {
  panel_.setStatus(session_.status());
  panel_.setChoices(session_.scene().objectFilter(), session_.scene().motionModes(),
                    session_.scene().objectClasses());
  showArea();
}

void ScenePresenter::showArea() {
  const auto area = panel_.area();
  views_.setFramed(area ? std::optional(area->box) : std::nullopt);
}

} // namespace taa::app
