// The session's pins: each change goes to the render thread whole.
#include "app/Session.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <glm/common.hpp>

#include <cstddef>
#include <optional>
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
  ask([&](Renderer& renderer) { renderer.setPins({pins_.all(), pins_.active(), wantsWhatIf_}); });
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

void Session::setPick(std::optional<glm::ivec2> pixel) {
  const int active = pins_.active();
  if (!pixel) return removePin(active);
  if (active < 0) return addPin(*pixel);
  if (inPicture(*pixel) == pick()) return;
  const Follow follow = pins_.all()[static_cast<std::size_t>(active)].follow;
  if (pins_.replace(active, {inPicture(*pixel), follow, status_.info.frame, {}})) sendPins();
}

void Session::movePick(int dx, int dy) {
  if (const auto from = pick()) setPick(*from + glm::ivec2(dx, dy));
}

void Session::addPin(glm::ivec2 pixel, Follow follow) {
  if (pins_.count() >= kMostPins)
    return guarded([] { throw Error(say<"there are nine probes already; remove one to pin another">()); });
  if (pins_.add({inPicture(pixel), follow, status_.info.frame, {}})) sendPins();
}

void Session::removePin(int pin) {
  if (pins_.remove(pin)) sendPins();
}

void Session::removeAllPins() {
  if (pins_.clear()) sendPins();
}

void Session::setActivePin(int pin) {
  if (!pins_.setActive(pin)) return;
  sendPins();
}

void Session::setFollow(int pin, Follow follow) {
  if (pin < 0 || pin >= pins_.count()) return;
  if (pins_.all()[static_cast<std::size_t>(pin)].follow == follow) return;
  if (pins_.replace(pin, {pins_.pixel(pin), follow, status_.info.frame, {}})) sendPins();
}

void Session::setWhatIf(bool wanted) {
  if (wanted == wantsWhatIf_) return;
  wantsWhatIf_ = wanted;
  ask([&](Renderer& renderer) { renderer.setPins({pins_.all(), pins_.active(), wantsWhatIf_}); });
}

void Session::setPins(const std::vector<ProbePin>& pins, int active) {
  if (pins_.set(pins, active)) sendPins();
}

} // namespace taa::app
