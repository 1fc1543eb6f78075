#include "app/window/ProbeFeed.h"

#include "app/panels/ProbePanel.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"

namespace taa::app {

ProbeFeed::ProbeFeed(Session& session, ViewArea& views, ProbePanel& panel)
    : session_(session), views_(views), panel_(panel) {
  connect(&panel_, &ProbePanel::removeRequested, this, [this] { session_.setPick({}); });
  connect(&panel_, &ProbePanel::pinChosen, &session_, &Session::setActivePin);
  connect(&panel_, &ProbePanel::followChosen, this,
          [this](Follow follow) { session_.setFollow(session_.activePin(), follow); });
  connect(&panel_, &ProbePanel::intermediateChosen, this,
          [this](IntermediateId id) { views_.active()->setIntermediate(id); });
  connect(&panel_, &ProbePanel::whatIfWanted, &session_, &Session::setWhatIf);
  connect(&views_, &ViewArea::pinned, this, [this](glm::ivec2 pixel) { session_.addPin(pixel); });
  connect(&views_, &ViewArea::picked, this, [this](glm::ivec2 pixel) { session_.setPick(pixel); });
  connect(&views_, &ViewArea::pickMoved, this, [this](int dx, int dy) {
    session_.movePick(dx, dy);
    if (session_.pick()) views_.active()->viewport()->reveal(*session_.pick());
  });
  connect(&session_, &Session::pickChanged, this, &ProbeFeed::showPick);
  connect(&session_, &Session::probeArrived, this, &ProbeFeed::showProbe);
}

void ProbeFeed::showPick() {
  panel_.setPins(session_.pins(), session_.activePin());
  panel_.setPick(session_.pick());
  showProbe();
}

void ProbeFeed::showProbe() {
  views_.setMarks(session_.pinMarks()); // those that follow surfaces have moved
  if (const ProbeResult* result = session_.probe()) panel_.setResult(*result);
}

} // namespace taa::app
