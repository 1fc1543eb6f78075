#include "core/jobs/idle/Traces.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace taa {

void Traces::take(const request::SetTracing& wanted) {
  if (wanted.on == isWanted_) return;
  isWanted_ = wanted.on;
  known_.clear();
  filling_.reset();
  cursor_ = {};
}

void Traces::settle() {
  if (shotVersion_ != desk_.shotVersion()) {
    shotVersion_ = desk_.shotVersion();
    known_.clear();
    cursor_ = {};
  }
  if (transport_.isPlaying()) end();
}

void Traces::end() {
  if (!filling_) return;
  filling_.reset();
  cursor_ = {};
  desk_.endWork();
}

// The frames at which something is known of the pin.
std::set<int>& Traces::framesOf(const ProbePin& pin) {
  for (auto& [known, frames] : known_)
    if (isSamePlace(known, pin)) return frames;
  return known_.emplace_back(pin, std::set<int>()).second;
}

void Traces::deliver(const ProbePin& pin, int frame, const std::optional<TraceSample>& sample) {
  framesOf(pin).insert(frame);
  if (sample) desk_.tell(RequestKind::Traces, TraceDelivery{pin, frame, *sample, desk_.shotVersion()});
}

void Traces::noteShown(const ProbeResult& result) {
  if (!isWanted_ || !result.exact || result.around.empty() || result.spot.state != PinState::Seen) return;
  deliver(result.pin, result.frame, TraceSample{result.spot.pixel, result.around[4]});
}

std::vector<ProbePin> Traces::missingAt(int frame) {
  std::vector<ProbePin> missing;
  for (ProbePin& pin : wanted_.probes.pins)
    if (!framesOf(pin).contains(frame)) missing.push_back(pin = desk_.inspector.probes().anchored(pin));
  return missing;
}

// Any request is answered between two frames; then it goes on with what is still missing.
void Traces::step() {
  const bool isDone = desk_.attempt(RequestKind::Traces, [this] { fill(); });
  if (isDone || !desk_.waiting().any()) end();
}

void Traces::fill() {
  const int last = std::min(filling_->second, desk_.inspector.shot().frameCount() - 1);
  const int first = std::clamp(filling_->first, 0, last);
  for (int frame = first; frame <= last; ++frame) {
    const std::vector<ProbePin> missing = missingAt(frame);
    if (missing.empty()) continue;
    desk_.tellWork(WorkKind::Traces, say<"Tracing the probes">(), frame - first, last - first + 1);
    const auto goesOn = [this](std::string_view, int, int) { return !desk_.waiting().any(); };
    const auto samples = desk_.inspector.probes().traceFrame(frame, missing, cursor_, goesOn);
    for (std::size_t pin = 0; pin < missing.size(); ++pin) deliver(missing[pin], frame, samples[pin]);
    if (desk_.waiting().any()) throw Cancelled();
  }
}

} // namespace taa
