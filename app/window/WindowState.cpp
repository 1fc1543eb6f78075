#include "app/window/WindowState.h"

#include "app/docks/Workspace.h"
#include "app/panels/LeftArea.h"
#include "app/panels/LowerArea.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ScenePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"

#include <QJsonArray>

#include <algorithm>
#include <vector>

namespace taa::app {

namespace {

QJsonArray probesJson(const std::vector<Probe>& probes) {
  QJsonArray array;
  for (const Probe& probe : probes)
    array << QJsonObject{{QStringLiteral("x"), probe.pixel.x},
                         {QStringLiteral("y"), probe.pixel.y},
                         {QStringLiteral("frame"), probe.frame},
                         {QStringLiteral("followsSurface"), probe.follow == Follow::Surface}};
  return array;
}

std::vector<Probe> probesFrom(const QJsonArray& array) {
  std::vector<Probe> probes;
  for (const QJsonValue& value : array) {
    const QJsonObject probe = value.toObject();
    if (static_cast<int>(probes.size()) < kMaxProbes)
      probes.push_back(
          {{std::max(0, probe[QStringLiteral("x")].toInt()), std::max(0, probe[QStringLiteral("y")].toInt())},
           probe[QStringLiteral("followsSurface")].toBool() ? Follow::Surface : Follow::Screen,
           std::max(0, probe[QStringLiteral("frame")].toInt()),
           {}});
  }
  return probes;
}

} // namespace

QJsonObject WindowState::capture() const {
  QJsonObject state;
  state[QStringLiteral("views")] = of_.views.state();
  state[QStringLiteral("timeline")] = of_.timeline.state();
  state[QStringLiteral("plots")] = of_.plots.state();
  state[QStringLiteral("pipeline")] = of_.pipeline.state();
  state[QStringLiteral("probe")] = of_.probe.state();
  state[QStringLiteral("scene")] = of_.session.scene().state();
  state[QStringLiteral("sceneTree")] = of_.scene.state();
  state[QStringLiteral("probes")] = probesJson(of_.session.probes().all());
  state[QStringLiteral("activeProbe")] = of_.session.probes().active();
  state[QStringLiteral("verdicts")] = of_.session.verdicts().areOn();
  state[QStringLiteral("looping")] = of_.session.isLooping();
  state[QStringLiteral("referenceSamples")] = of_.session.status().referenceGoal;
  state[QStringLiteral("panels")] = panels();
  state[QStringLiteral("docks")] = of_.workspace.state();
  return state;
}

QJsonObject WindowState::panels() const {
  const LowerPage page = of_.lower.current();
  return {{QStringLiteral("pipeline"), !of_.left.isHidden()},
          {QStringLiteral("scene"), of_.left.page() == LeftPage::Scene},
          {QStringLiteral("probe"), !of_.probe.isHidden()},
          {QStringLiteral("lower"), of_.lower.shows(page) ? lowerPageId(page) : QString()}};
}

void WindowState::apply(const QJsonObject& state) const {
  const UndoStack::Quiet quiet(of_.session.undoStack());
  applyPanels(state[QStringLiteral("panels")].toObject());
  // A lesson says which panels are read, and leaves them where they are.
  if (const QJsonValue docks = state[QStringLiteral("docks")]; docks.isObject())
    of_.workspace.setState(docks.toObject());
  applySession(state);
  of_.views.setState(state[QStringLiteral("views")].toObject());
  of_.timeline.setState(state[QStringLiteral("timeline")].toObject());
  of_.plots.setState(state[QStringLiteral("plots")].toObject());
  of_.pipeline.setState(state[QStringLiteral("pipeline")].toObject());
  of_.probe.setState(state[QStringLiteral("probe")].toObject());
  of_.scene.setState(state[QStringLiteral("sceneTree")].toObject());
}

void WindowState::applyPanels(const QJsonObject& panels) const {
  if (const QJsonValue shown = panels[QStringLiteral("pipeline")]; shown.isBool())
    of_.left.setShown(shown.toBool());
  if (const QJsonValue shown = panels[QStringLiteral("probe")]; shown.isBool())
    of_.probe.setVisible(shown.toBool());
  of_.left.setPage(panels[QStringLiteral("scene")].toBool() ? LeftPage::Scene : LeftPage::Pipeline);
  if (const QJsonValue page = panels[QStringLiteral("lower")]; page.isString())
    of_.lower.setShown(lowerPageWithId(page.toString()).value_or(of_.lower.current()),
                       !page.toString().isEmpty());
}

void WindowState::applySession(const QJsonObject& state) const {
  if (const QJsonValue looping = state[QStringLiteral("looping")]; looping.isBool()) {
    of_.session.setLooping(looping.toBool());
    of_.timeline.setLooping(of_.session.isLooping());
  }
  of_.session.verdicts().setOn(state[QStringLiteral("verdicts")].toBool(true));
  if (const int samples = state[QStringLiteral("referenceSamples")].toInt(); samples > 0)
    of_.session.post(request::SetReferenceSamples{samples});
  if (const QJsonValue scene = state[QStringLiteral("scene")]; scene.isObject())
    of_.session.scene().setState(scene.toObject());
  const std::vector<Probe> probes = probesFrom(state[QStringLiteral("probes")].toArray());
  const int last = static_cast<int>(probes.size()) - 1;
  of_.session.probes().set(probes, std::clamp(state[QStringLiteral("activeProbe")].toInt(-1), -1, last));
}

} // namespace taa::app
