// The session's pins: each change goes to the render thread whole.
#include "app/session/Session.h"

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

std::optional<glm::ivec2> Session::pick() const {
  if (pins_.active() < 0) return {};
  return pins_.pixel(pins_.active());
}

glm::ivec2 Session::inPicture(glm::ivec2 pixel) const {
  if (!isOpen()) return pixel;
  return glm::clamp(pixel, glm::ivec2(0), glm::ivec2(status_.width, status_.height) - 1);
}

void Session::sendPins() {
  ask(request::SetPins{pins_.all(), pins_.active(), wantsWhatIf_});
  Q_EMIT pickChanged();
}

// The picture may have become smaller.
void Session::keepPinsInPicture() {
  bool changed = false;
  for (int pin = 0; pin < pins_.count(); ++pin) {
    ProbePin moved = pins_.all()[static_cast<std::size_t>(pin)];
    if (moved.anchor) continue; // it is where its surface is
    moved.pixel = inPicture(moved.pixel);
    changed = pins_.replace(pin, moved) || changed;
  }
  if (changed) sendPins();
}

namespace {

/// All pins, of a scene.
struct PinnedProbes {
  std::string source;
  std::vector<ProbePin> pins;
  int active = -1;
  // Which is active is no change to take back.
  bool operator==(const PinnedProbes& other) const { return pins == other.pins; }
};

/// Surfaces are of their scene: in another one their pins are where they were.
std::vector<ProbePin> pinsIn(const std::string& source, PinnedProbes state) {
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
void Session::changePins(const QString& what, const std::string& key, const std::function<bool()>& change) {
  const auto state = [this] { return PinnedProbes{status_.source, pins_.all(), pins_.active()}; };
  PinnedProbes before = state();
  if (!change()) return;
  if (!(state() == before)) {
    UndoStep step = stepBackTo<PinnedProbes>(std::move(before), state, [this](const PinnedProbes& to) {
      if (pins_.set(pinsIn(status_.source, to), to.active)) sendPins();
    });
    step.what = what;
    step.key = key;
    undo_.push(std::move(step));
  }
  sendPins();
}

void Session::setPick(std::optional<glm::ivec2> pixel) {
  const int active = pins_.active();
  if (!pixel) return removePin(active);
  if (active < 0) return addPin(*pixel);
  if (inPicture(*pixel) == pick()) return;
  const Follow follow = pins_.all()[static_cast<std::size_t>(active)].follow;
  changePins(tr("move of probe %1").arg(active + 1), moveOf(active), [&] {
    return pins_.replace(active, {inPicture(*pixel), follow, status_.info.frame, {}});
  });
}

void Session::movePick(int dx, int dy) {
  if (const auto from = pick()) setPick(*from + glm::ivec2(dx, dy));
}

void Session::addPin(glm::ivec2 pixel, Follow follow) {
  if (pins_.count() >= kMostPins)
    return guarded([] { throw Error(say<"there are nine probes already; remove one to pin another">()); });
  undo_.endGesture();
  changePins(tr("pinning of probe %1").arg(pins_.count() + 1), moveOf(pins_.count()), [&] {
    return pins_.add({inPicture(pixel), follow, status_.info.frame, {}});
  });
}

void Session::removePin(int pin) {
  changePins(tr("removal of probe %1").arg(pin + 1), {}, [&] { return pins_.remove(pin); });
}

void Session::removeAllPins() {
  changePins(tr("removal of all probes"), {}, [&] { return pins_.clear(); });
}

void Session::setActivePin(int pin) {
  if (!pins_.setActive(pin)) return;
  sendPins();
}

void Session::setFollow(int pin, Follow follow) {
  if (pin < 0 || pin >= pins_.count()) return;
  if (pins_.all()[static_cast<std::size_t>(pin)].follow == follow) return;
  changePins(tr("change of what probe %1 follows").arg(pin + 1), {}, [&] {
    return pins_.replace(pin, {pins_.pixel(pin), follow, status_.info.frame, {}});
  });
}

void Session::setWhatIf(bool wanted) {
  if (wanted == wantsWhatIf_) return;
  wantsWhatIf_ = wanted;
  ask(request::SetPins{pins_.all(), pins_.active(), wantsWhatIf_});
}

void Session::setPins(const std::vector<ProbePin>& pins, int active) {
  if (pins_.set(pins, active)) sendPins();
}

} // namespace taa::app
