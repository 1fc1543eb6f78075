#include "app/window/ProbeFeed.h"

#include "app/panels/ProbePanel.h"
#include "app/session/PinnedProbes.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"

namespace taa::app {

ProbeFeed::ProbeFeed(PinnedProbes& probes, ViewArea& views, ProbePanel& panel)
    : probes_(probes), views_(views), panel_(panel) {
  connect(&panel_, &ProbePanel::removeRequested, this, [this] { probes_.setPick({}); });
  connect(&panel_, &ProbePanel::pinChosen, &probes_, &PinnedProbes::setActivePin);
  connect(&panel_, &ProbePanel::followChosen, this,
          [this](Follow follow) { probes_.setFollow(probes_.activePin(), follow); });
  connect(&panel_, &ProbePanel::intermediateChosen, this,
          [this](IntermediateId id) { views_.active()->setIntermediate(id); });
  connect(&panel_, &ProbePanel::whatIfWanted, &probes_, &PinnedProbes::setWhatIf);
  connect(&views_, &ViewArea::pinned, this, [this](glm::ivec2 pixel) { probes_.addPin(pixel); });
  connect(&views_, &ViewArea::picked, this, [this](glm::ivec2 pixel) { probes_.setPick(pixel); });
  connect(&views_, &ViewArea::pickMoved, this, [this](int dx, int dy) {
    probes_.movePick(dx, dy);
    if (probes_.pick()) views_.active()->viewport()->reveal(*probes_.pick());
  });
  connect(&probes_, &PinnedProbes::pickChanged, this, &ProbeFeed::showPick);
  connect(&probes_, &PinnedProbes::probeArrived, this, &ProbeFeed::showProbe);
}

void ProbeFeed::showPick() {
  panel_.setPins(probes_.pins(), probes_.activePin());
  panel_.setPick(probes_.pick());
  showProbe();
}

void ProbeFeed::showProbe() {
  views_.setMarks(probes_.pinMarks()); // those that follow surfaces have moved
  if (const ProbeResult* result = probes_.probe()) panel_.setResult(*result);
}

} // namespace taa::app
