#include "app/window/ProbeFeed.h"

#include "app/panels/ProbePanel.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"

namespace taa::app {

ProbeFeed::ProbeFeed(Session& session, ViewArea& views, ProbePanel& panel)
    : session_(session), views_(views), panel_(panel) {
  connect(&panel_, &ProbePanel::removeRequested, this, [this] { session_.probes().setPick({}); });
  connect(&panel_, &ProbePanel::pinChosen, &session_.probes(), &PinnedProbes::setActivePin);
  connect(&panel_, &ProbePanel::followChosen, this,
          [this](Follow follow) { session_.probes().setFollow(session_.probes().activePin(), follow); });
  connect(&panel_, &ProbePanel::intermediateChosen, this,
          [this](IntermediateId id) { views_.active()->setIntermediate(id); });
  connect(&panel_, &ProbePanel::whatIfWanted, &session_.probes(), &PinnedProbes::setWhatIf);
  connect(&views_, &ViewArea::pinned, this, [this](glm::ivec2 pixel) { session_.probes().addPin(pixel); });
  connect(&views_, &ViewArea::picked, this, [this](glm::ivec2 pixel) { session_.probes().setPick(pixel); });
  connect(&views_, &ViewArea::pickMoved, this, [this](int dx, int dy) {
    session_.probes().movePick(dx, dy);
    if (session_.probes().pick()) views_.active()->viewport()->reveal(*session_.probes().pick());
  });
  connect(&session_.probes(), &PinnedProbes::pickChanged, this, &ProbeFeed::showPick);
  connect(&session_.probes(), &PinnedProbes::probeArrived, this, &ProbeFeed::showProbe);
}

void ProbeFeed::showPick() {
  panel_.setPins(session_.probes().pins(), session_.probes().activePin());
  panel_.setPick(session_.probes().pick());
  showProbe();
}

void ProbeFeed::showProbe() {
  views_.setMarks(session_.probes().pinMarks()); // those that follow surfaces have moved
  if (const ProbeResult* result = session_.probes().probe()) panel_.setResult(*result);
}

} // namespace taa::app
