#include "core/jobs/shown/ShownProbes.h"

#include <cstddef>
#include <memory>

namespace taa {

// What was found out about a pin holds as long as it is the same pin.
void ShownProbes::take(const request::SetPins& pins) {
  request::SetPins next = pins;
  for (ProbePin& pin : next.pins) {
    if (pin.anchor) continue;
    ProbePin known = pin;
    for (const ProbePin& old : wanted_.probes.pins) {
      known.anchor = old.anchor;
      if (known == old) pin.anchor = old.anchor;
    }
  }
  wanted_.probes = std::move(next);
  delivered_ = {};
}

void ShownProbes::deliver() {
  const std::pair now(desk_.version(), desk_.referenceVersion);
  if (delivered_ == now) return;
  delivered_ = now; // also when it fails: once is enough to tell
  for (int pin = 0; pin < static_cast<int>(wanted_.probes.pins.size()); ++pin) deliverPin(pin);
}

void ShownProbes::deliverPin(int index) {
  ProbePin& pin = wanted_.probes.pins[static_cast<std::size_t>(index)];
  const InspectedShot& shot = desk_.inspector.shot();
  // A pinned pixel may lie outside for a while, when the size changes.
  const bool isInside =
      pin.pixel.x >= 0 && pin.pixel.y >= 0 && pin.pixel.x < shot.width() && pin.pixel.y < shot.height();
  if (!isInside && !pin.anchor) return;
  desk_.attempt(RequestKind::Probes, [&] {
    ProbeResult result = probe(pin, index == wanted_.probes.active);
    traces_.noteShown(result);
    desk_.tell(RequestKind::Probes, std::move(result));
  });
}

ProbeResult ShownProbes::probe(ProbePin& pin, bool isActive) {
  const InspectedShot& shot = desk_.inspector.shot();
  Probes& probes = desk_.inspector.probes();
  pin = probes.anchored(pin);
  ProbeResult result{.pin = pin, .spot = probes.spot(pin), .around = {}};
  result.x = result.spot.pixel.x;
  result.y = result.spot.pixel.y;
  result.frame = shot.frame();
  if (result.spot.state == PinState::Seen || result.spot.state == PinState::Hidden) {
    result.around = probes.probeAround(result.x, result.y, 1);
    if (isActive) result.details = std::make_shared<const twin::Details>(probes.details(result.x, result.y));
    if (isActive && wanted_.probes.whatIf) result.whatIf = probes.whatIf(result.x, result.y);
  }
  result.exact = shot.isExact();
  result.settings = shot.usedSettings();
  result.info = shot.info();
  return result;
}

} // namespace taa
