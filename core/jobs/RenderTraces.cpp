// What the render thread does about traces: every exact frame on show adds what is at the pins; the others
// are filled in on demand, beside what is shown.
#include "core/jobs/RenderWorker.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace taa {

void RenderWorker::applyTraces(const Wishes& wishes) {
  if (wishes.tracing && *wishes.tracing != traces_.wanted) {
    traces_ = {};
    traces_.wanted = *wishes.tracing;
    pinsDelivered_ = 0; // the frame on show is a part of it
  }
  if (wishes.fillTraces) traces_.filling = wishes.fillTraces;
  if (traces_.subject != subject_) {
    traces_.subject = subject_;
    traces_.known.clear();
    traces_.cursor = {};
  }
  if ((wishes.cancel || playing_) && traces_.filling) {
    traces_.filling.reset();
    traces_.cursor = {};
    if (listener_.onWork) listener_.onWork({});
  }
}

// The frames at which something is known of the pin.
std::set<int>& RenderWorker::tracedFrames(const ProbePin& pin) {
  for (auto& [known, frames] : traces_.known)
    if (isSamePlace(known, pin)) return frames;
  return traces_.known.emplace_back(pin, std::set<int>()).second;
}

void RenderWorker::deliverTrace(const ProbePin& pin, int frame, const std::optional<TraceSample>& sample) {
  tracedFrames(pin).insert(frame);
  if (sample && listener_.onTrace) listener_.onTrace({pin, frame, *sample, subject_});
}

// What a probe of the frame on show has seen anyway.
void RenderWorker::traceShown(const ProbeResult& result) {
  if (!traces_.wanted || !result.exact || result.around.empty() || result.spot.state != PinState::Seen)
    return;
  deliverTrace(result.pin, result.frame, TraceSample{result.spot.pixel, result.around[4]});
}

bool RenderWorker::wantsToFillTraces() const {
  return traces_.filling && isOpen() && !playing_ && !goal_ && !needsRefinement() && !pins_.pins.empty();
}

// Any wish is answered between two frames; then it goes on with what is still missing.
void RenderWorker::fillTraces() {
  const int last = std::min(traces_.filling->second, inspector_.shot().frameCount() - 1);
  const int first = std::clamp(traces_.filling->first, 0, last);
  const bool isDone = attempt(RequestKind::Traces, [&] {
    for (int frame = first; frame <= last; ++frame) {
      std::vector<ProbePin> missing;
      for (ProbePin& pin : pins_.pins)
        if (!tracedFrames(pin).contains(frame)) missing.push_back(pin = inspector_.probes().anchored(pin));
      if (missing.empty()) continue;
      if (listener_.onWork) listener_.onWork({"Tracing the probes", frame - first, last - first + 1});
      const auto stops = [this](std::string_view, int, int) { return !ends_ && !pending_(isAny); };
      const auto samples = inspector_.probes().traceFrame(frame, missing, traces_.cursor, stops);
      for (std::size_t pin = 0; pin < missing.size(); ++pin) deliverTrace(missing[pin], frame, samples[pin]);
      if (ends_ || pending_(isAny)) throw Cancelled();
    }
  });
  if (!isDone && pending_(isAny)) return;
  traces_.filling.reset();
  traces_.cursor = {};
  if (listener_.onWork) listener_.onWork({});
}

} // namespace taa
