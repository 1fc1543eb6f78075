#include "app/session/Pins.h"

#include <algorithm>
#include <utility>

namespace taa::app {

namespace {

bool isSamePin(const ProbePin& a, const ProbePin& b) {
  return a.pixel == b.pixel && a.follow == b.follow && (a.follow == Follow::Screen || a.frame == b.frame);
}

} // namespace

const ProbeResult* Pins::result(int pin) const {
  if (pin < 0 || pin >= count()) return nullptr;
  const std::optional<ProbeResult>& result = results_[static_cast<std::size_t>(pin)];
  return result ? &*result : nullptr;
}

glm::ivec2 Pins::pixel(int pin) const {
  const ProbePin& own = pins_.at(static_cast<std::size_t>(pin));
  const ProbeResult* last = result(pin);
  const bool hasMoved = own.follow == Follow::Surface && last && isSamePin(last->pin, own);
  return hasMoved ? last->spot.pixel : own.pixel;
}

std::vector<PinMark> Pins::marks() const {
  std::vector<PinMark> marks;
  for (int pin = 0; pin < count(); ++pin) {
    const ProbePin& own = pins_[static_cast<std::size_t>(pin)];
    const ProbeResult* last = result(pin);
    PinMark mark{pin + 1, pixel(pin), PinState::Seen, pin == active_, own.follow == Follow::Surface};
    if (last && isSamePin(last->pin, own)) mark.state = last->spot.state;
    if (mark.state == PinState::Seen || mark.state == PinState::Hidden) marks.push_back(mark);
  }
  std::ranges::stable_partition(marks, [](const PinMark& mark) { return !mark.isActive; });
  return marks;
}

bool Pins::add(const ProbePin& pin) {
  for (int known = 0; known < count(); ++known)
    if (isSamePin(pins_[static_cast<std::size_t>(known)], pin)) return setActive(known);
  if (count() >= kMaxPins) return false;
  pins_.push_back(pin);
  results_.emplace_back();
  active_ = count() - 1;
  return true;
}

bool Pins::remove(int pin) {
  if (pin < 0 || pin >= count()) return false;
  pins_.erase(pins_.begin() + pin);
  results_.erase(results_.begin() + pin);
  if (active_ > pin || active_ == count()) --active_;
  return true;
}

bool Pins::clear() {
  if (pins_.empty()) return false;
  *this = {};
  return true;
}

bool Pins::setActive(int pin) {
  if (pin < 0 || pin >= count() || pin == active_) return false;
  active_ = pin;
  return true;
}

bool Pins::replace(int pin, const ProbePin& by) {
  ProbePin& own = pins_.at(static_cast<std::size_t>(pin));
  if (own == by) return false;
  own = by;
  return true;
}

bool Pins::set(const std::vector<ProbePin>& pins, int active) {
  Pins next;
  for (const ProbePin& pin : pins) next.add(pin);
  for (std::size_t pin = 0; pin < next.pins_.size(); ++pin)
    for (std::size_t known = 0; known < pins_.size(); ++known)
      if (isSamePin(next.pins_[pin], pins_[known])) next.results_[pin] = results_[known];
  next.active_ = std::clamp(active, std::min(0, next.count() - 1), next.count() - 1);
  if (next.pins_ == pins_ && next.active_ == active_) return false;
  *this = std::move(next);
  return true;
}

bool Pins::forgetSurfaces() {
  bool changed = false;
  for (int pin = 0; pin < count(); ++pin) {
    ProbePin& own = pins_[static_cast<std::size_t>(pin)];
    if (own.follow != Follow::Surface) continue;
    own = {.pixel = pixel(pin)};
    changed = true;
  }
  return changed;
}

bool Pins::take(ProbeResult&& result) {
  for (std::size_t pin = 0; pin < pins_.size(); ++pin) {
    if (!isSamePin(pins_[pin], result.pin)) continue;
    pins_[pin].anchor = result.pin.anchor;
    results_[pin] = std::move(result);
    return true;
  }
  return false;
}

} // namespace taa::app
