// What the render thread does about pinned probes: finds where each is in the frame on show, and delivers it.
#include "core/jobs/RenderWorker.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace taa {

// What was found out about a pin holds as long as it is the same pin.
void RenderWorker::applyPins(const PinWish& wish) {
  PinWish next = wish;
  for (ProbePin& pin : next.pins) {
    if (pin.anchor) continue;
    ProbePin known = pin;
    for (const ProbePin& old : pins_.pins) {
      known.anchor = old.anchor;
      if (known == old) pin.anchor = old.anchor;
    }
  }
  pins_ = std::move(next);
  pinsDelivered_ = 0;
}

void RenderWorker::deliverPins() {
  if (pinsDelivered_ == version_) return;
  pinsDelivered_ = version_; // also when it fails: once is enough to tell
  for (int pin = 0; pin < static_cast<int>(pins_.pins.size()); ++pin) deliverPin(pin);
}

void RenderWorker::deliverPin(int index) {
  ProbePin& pin = pins_.pins[static_cast<std::size_t>(index)];
  // A pinned pixel may lie outside for a while, when the size changes.
  const bool isInside = pin.pixel.x >= 0 && pin.pixel.y >= 0 && pin.pixel.x < inspector_.shot().width() &&
                        pin.pixel.y < inspector_.shot().height();
  if (!isInside && !pin.anchor) return;
  attempt(RequestKind::Probes, [&] {
    pin = inspector_.probes().anchored(pin);
    ProbeResult result{.pin = pin, .spot = inspector_.probes().spot(pin), .around = {}};
    result.x = result.spot.pixel.x;
    result.y = result.spot.pixel.y;
    result.frame = inspector_.shot().frame();
    if (result.spot.state == PinState::Seen || result.spot.state == PinState::Hidden) {
      result.around = inspector_.probes().probeAround(result.x, result.y, 1);
      if (index == pins_.active)
        result.details =
            std::make_shared<const twin::Details>(inspector_.probes().details(result.x, result.y));
      if (index == pins_.active && pins_.whatIf)
        result.whatIf = inspector_.probes().whatIf(result.x, result.y);
    }
    result.exact = inspector_.shot().isExact();
    result.settings = inspector_.shot().settings();
    result.info = inspector_.shot().info();
    traceShown(result);
    if (listener_.onProbe) listener_.onProbe(std::move(result));
  });
}

} // namespace taa
