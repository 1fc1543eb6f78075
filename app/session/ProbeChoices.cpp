#include "app/session/ProbeChoices.h"

#include "app/session/Outbox.h"
#include "app/undo/UndoStack.h"
#include "core/base/Error.h"
#include "core/base/Say.h"

#include <glm/common.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

ProbeChoices::ProbeChoices(Outbox& outbox, UndoStack& undo, const Status& status)
    : outbox_(outbox), undo_(undo), status_(status) {}

std::optional<glm::ivec2> ProbeChoices::pixel() const {
  if (probes_.active() < 0) return {};
  return probes_.pixel(probes_.active());
}

void ProbeChoices::arrived(std::vector<ProbeResult>&& results) {
  bool isKnown = false;
  for (ProbeResult& result : results) isKnown = probes_.take(std::move(result)) || isKnown;
  if (isKnown) Q_EMIT probeArrived();
}

void ProbeChoices::forgetSurfaces() {
  if (probes_.forgetSurfaces()) send();
}

glm::ivec2 ProbeChoices::inPicture(glm::ivec2 pixel) const {
  if (status_.frameCount == 0) return pixel; // nothing is open, so that its size is not known
  return glm::clamp(pixel, glm::ivec2(0), glm::ivec2(status_.width, status_.height) - 1);
}

void ProbeChoices::post() {
  outbox_.post(request::SetProbes{probes_.all(), probes_.active(), wantsWhatIf_, other_, wantsReference_});
}

void ProbeChoices::send() {
  post();
  Q_EMIT changed();
}

void ProbeChoices::keepInPicture() {
  bool changed = false;
  for (int probe = 0; probe < probes_.count(); ++probe) {
    Probe moved = probes_.all()[static_cast<std::size_t>(probe)];
    if (moved.anchor) continue; // it is where its surface is
    moved.pixel = inPicture(moved.pixel);
    changed = probes_.replace(probe, moved) || changed;
  }
  if (changed) send();
}

namespace {

/// All probes, of a scene.
struct ProbesOfScene {
  std::string source;
  std::vector<Probe> probes;
  int active = -1;
  // Which is active is no change to take back.
  bool operator==(const ProbesOfScene& other) const { return probes == other.probes; }
};

/// Surfaces are of their scene: in another one their probes are where they were.
std::vector<Probe> probesIn(const std::string& source, ProbesOfScene state) {
  if (state.source == source) return state.probes;
  for (Probe& probe : state.probes) probe = {.pixel = probe.pixel};
  return state.probes;
}

/// A probe that was set and the way it is dragged on are one step.
std::string moveOf(int probe) {
  return "probe." + std::to_string(probe);
}

} // namespace

// Changes the probes and notes how they were.
void ProbeChoices::change(const QString& what, const std::string& key, const std::function<bool()>& act) {
  const auto state = [this] { return ProbesOfScene{status_.source, probes_.all(), probes_.active()}; };
  ProbesOfScene before = state();
  if (!act()) return;
  if (!(state() == before)) {
    UndoStep step = stepBackTo<ProbesOfScene>(std::move(before), state, [this](const ProbesOfScene& to) {
      if (probes_.set(probesIn(status_.source, to), to.active)) send();
    });
    step.what = what;
    step.key = key;
    undo_.push(std::move(step));
  }
  send();
}

void ProbeChoices::findWorst(IntermediateId row, WorstStep step) {
  outbox_.post(request::FindWorst{row, 0, pixel(), step});
}

void ProbeChoices::setPixel(std::optional<glm::ivec2> pixel) {
  const int active = probes_.active();
  if (!pixel) {
    remove(active);
    return;
  }
  if (active < 0) {
    add(*pixel);
    return;
  }
  if (inPicture(*pixel) == this->pixel()) return;
  const Follow follow = probes_.all()[static_cast<std::size_t>(active)].follow;
  change(tr("move of probe %1").arg(active + 1), moveOf(active), [&] {
    return probes_.replace(active, {inPicture(*pixel), follow, status_.info.frame, {}});
  });
}

void ProbeChoices::move(int dx, int dy) {
  if (const auto from = pixel()) setPixel(*from + glm::ivec2(dx, dy));
}

void ProbeChoices::add(glm::ivec2 pixel, Follow follow) {
  if (probes_.count() >= kMaxProbes) {
    outbox_.guarded([] { throw Error(say<"there are nine probes already; remove one to set another">()); });
    return;
  }
  undo_.endGesture();
  change(tr("addition of probe %1").arg(probes_.count() + 1), moveOf(probes_.count()), [&] {
    return probes_.add({inPicture(pixel), follow, status_.info.frame, {}});
  });
}

void ProbeChoices::remove(int probe) {
  change(tr("removal of probe %1").arg(probe + 1), {}, [&] { return probes_.remove(probe); });
}

void ProbeChoices::removeAll() {
  change(tr("removal of all probes"), {}, [&] { return probes_.clear(); });
}

void ProbeChoices::setActive(int probe) {
  if (!probes_.setActive(probe)) return;
  send();
}

void ProbeChoices::setFollow(int probe, Follow follow) {
  if (probe < 0 || probe >= probes_.count()) return;
  if (probes_.all()[static_cast<std::size_t>(probe)].follow == follow) return;
  change(tr("change of what probe %1 follows").arg(probe + 1), {}, [&] {
    return probes_.replace(probe, {probes_.pixel(probe), follow, status_.info.frame, {}});
  });
}

void ProbeChoices::setWhatIf(bool wanted) {
  if (wanted == wantsWhatIf_) return;
  wantsWhatIf_ = wanted;
  post();
}

void ProbeChoices::setReference(bool wanted) {
  if (wanted == wantsReference_) return;
  wantsReference_ = wanted;
  post();
}

void ProbeChoices::setOtherSide(const std::optional<OtherSide>& other) {
  if (other == other_) return;
  other_ = other;
  post();
}

void ProbeChoices::set(const std::vector<Probe>& probes, int active) {
  if (probes_.set(probes, active)) send();
}

} // namespace taa::app
