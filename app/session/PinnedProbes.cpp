#include "app/session/PinnedProbes.h"

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

PinnedProbes::PinnedProbes(Outbox& outbox, UndoStack& undo, const Status& status)
    : outbox_(outbox), undo_(undo), status_(status) {}

std::optional<glm::ivec2> PinnedProbes::pick() const {
  if (pins_.active() < 0) return {};
  return pins_.pixel(pins_.active());
}

void PinnedProbes::arrived(std::vector<ProbeResult>&& results) {
  bool isPinned = false;
  for (ProbeResult& result : results) isPinned = pins_.take(std::move(result)) || isPinned;
  if (isPinned) Q_EMIT probeArrived();
}

void PinnedProbes::forgetSurfaces() {
  if (pins_.forgetSurfaces()) send();
}

glm::ivec2 PinnedProbes::inPicture(glm::ivec2 pixel) const {
  if (status_.frameCount == 0) return pixel; // nothing is open, so that its size is not known
  return glm::clamp(pixel, glm::ivec2(0), glm::ivec2(status_.width, status_.height) - 1);
}

void PinnedProbes::send() {
  outbox_.post(request::SetPins{pins_.all(), pins_.active(), wantsWhatIf_});
  Q_EMIT pickChanged();
}

void PinnedProbes::keepInPicture() {
  bool changed = false;
  for (int pin = 0; pin < pins_.count(); ++pin) {
    ProbePin moved = pins_.all()[static_cast<std::size_t>(pin)];
    if (moved.anchor) continue; // it is where its surface is
    moved.pixel = inPicture(moved.pixel);
    changed = pins_.replace(pin, moved) || changed;
  }
  if (changed) send();
}

namespace {

/// All pins, of a scene.
struct PinsOfScene {
  std::string source;
  std::vector<ProbePin> pins;
  int active = -1;
  // Which is active is no change to take back.
  bool operator==(const PinsOfScene& other) const { return pins == other.pins; }
};

/// Surfaces are of their scene: in another one their pins are where they were.
std::vector<ProbePin> pinsIn(const std::string& source, PinsOfScene state) {
  if (state.source == source) return state.pins;
  for (ProbePin& pin : state.pins) pin = {.pixel = pin.pixel};
  return state.pins;
}

/// A probe that was pinned and the way it is dragged on are one step.
std::string moveOf(int pin) {
  return "pin." + std::to_string(pin);
}

} // namespace

// Changes the pins and notes how they were.
void PinnedProbes::change(const QString& what, const std::string& key, const std::function<bool()>& act) {
  const auto state = [this] { return PinsOfScene{status_.source, pins_.all(), pins_.active()}; };
  PinsOfScene before = state();
  if (!act()) return;
  if (!(state() == before)) {
    UndoStep step = stepBackTo<PinsOfScene>(std::move(before), state, [this](const PinsOfScene& to) {
      if (pins_.set(pinsIn(status_.source, to), to.active)) send();
    });
    step.what = what;
    step.key = key;
    undo_.push(std::move(step));
  }
  send();
}

void PinnedProbes::setPick(std::optional<glm::ivec2> pixel) {
  const int active = pins_.active();
  if (!pixel) return removePin(active);
  if (active < 0) return addPin(*pixel);
  if (inPicture(*pixel) == pick()) return;
  const Follow follow = pins_.all()[static_cast<std::size_t>(active)].follow;
  change(tr("move of probe %1").arg(active + 1), moveOf(active), [&] {
    return pins_.replace(active, {inPicture(*pixel), follow, status_.info.frame, {}});
  });
}

void PinnedProbes::movePick(int dx, int dy) {
  if (const auto from = pick()) setPick(*from + glm::ivec2(dx, dy));
}

void PinnedProbes::addPin(glm::ivec2 pixel, Follow follow) {
  if (pins_.count() >= kMaxPins)
    return outbox_.guarded(
        [] { throw Error(say<"there are nine probes already; remove one to pin another">()); });
  undo_.endGesture();
  change(tr("pinning of probe %1").arg(pins_.count() + 1), moveOf(pins_.count()), [&] {
    return pins_.add({inPicture(pixel), follow, status_.info.frame, {}});
  });
}

void PinnedProbes::removePin(int pin) {
  change(tr("removal of probe %1").arg(pin + 1), {}, [&] { return pins_.remove(pin); });
}

void PinnedProbes::removeAllPins() {
  change(tr("removal of all probes"), {}, [&] { return pins_.clear(); });
}

void PinnedProbes::setActivePin(int pin) {
  if (!pins_.setActive(pin)) return;
  send();
}

void PinnedProbes::setFollow(int pin, Follow follow) {
  if (pin < 0 || pin >= pins_.count()) return;
  if (pins_.all()[static_cast<std::size_t>(pin)].follow == follow) return;
  change(tr("change of what probe %1 follows").arg(pin + 1), {}, [&] {
    return pins_.replace(pin, {pins_.pixel(pin), follow, status_.info.frame, {}});
  });
}

void PinnedProbes::setWhatIf(bool wanted) {
  if (wanted == wantsWhatIf_) return;
  wantsWhatIf_ = wanted;
  outbox_.post(request::SetPins{pins_.all(), pins_.active(), wantsWhatIf_});
}

void PinnedProbes::setPins(const std::vector<ProbePin>& pins, int active) {
  if (pins_.set(pins, active)) send();
}

} // namespace taa::app
