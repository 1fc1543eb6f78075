#include "core/jobs/idle/Traces.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace taa {

void Traces::take(const request::SetTracing& subscriptions) {
  if (subscriptions.on == isWanted_) return;
  isWanted_ = subscriptions.on;
  known_.clear();
  filling_.reset();
  inIdleTime_.reset();
  cursor_ = {};
}

void Traces::take(const request::TraceInIdleTime& subscriptions) {
  inIdleTime_ = {subscriptions.first, subscriptions.last};
  firstUnsure_ = std::max(0, subscriptions.first);
}

void Traces::take(const request::Cancel&) {
  inIdleTime_.reset();
  end();
}

void Traces::settle() {
  if (shotVersion_ != jobContext_.shotVersion()) {
    shotVersion_ = jobContext_.shotVersion();
    known_.clear();
    cursor_ = {};
    if (inIdleTime_) firstUnsure_ = std::max(0, inIdleTime_->first);
  }
  if (transport_.isPlaying()) end();
}

void Traces::end() {
  if (!filling_) return;
  filling_.reset();
  cursor_ = {};
  jobContext_.endWork();
}

// The frames at which something is known of the probe.
std::set<int>& Traces::framesOf(const Probe& probe) {
  for (auto& [known, frames] : known_)
    if (isSamePlace(known, probe)) return frames;
  return known_.emplace_back(probe, std::set<int>()).second;
}

void Traces::deliver(const Probe& probe, int frame, const std::optional<TraceSample>& sample) {
  framesOf(probe).insert(frame);
  if (sample)
    jobContext_.tell(RequestKind::Traces, TraceDelivery{probe, frame, *sample, jobContext_.shotVersion()});
}

void Traces::noteShown(const ProbeResult& result) {
  if (!isWanted_ || !result.exact || result.around.empty() || result.spot.state != ProbeState::Seen) return;
  deliver(result.probe, result.frame, TraceSample{result.spot.pixel, result.around[4]});
}

std::vector<Probe> Traces::missingAt(int frame) {
  std::vector<Probe> missing;
  for (Probe& probe : subscriptions_.probes.all)
    if (!framesOf(probe).contains(frame))
      missing.push_back(probe = jobContext_.inspector.probes().anchored(probe));
  return missing;
}

// Any request is answered between two frames; then it goes on with what is still missing.
void Traces::step() {
  const bool isDone = jobContext_.attempt(RequestKind::Traces, [this] { fill(); });
  if (isDone || !jobContext_.waiting().any()) end();
}

void Traces::fill() {
  const int last = std::min(filling_->second, jobContext_.inspector.shot().frameCount() - 1);
  const int first = std::max(filling_->first, 0);
  for (int frame = first; frame <= last; ++frame) {
    if (missingAt(frame).empty()) continue;
    jobContext_.tellWork(WorkKind::Traces, say<"Tracing the probes">(), frame - first, last - first + 1);
    trace(frame);
    if (jobContext_.waiting().any()) throw Cancelled();
  }
}

void Traces::trace(int frame) {
  const std::vector<Probe> missing = missingAt(frame);
  const auto goesOn = [this](std::string_view, int, int) { return !jobContext_.waiting().any(); };
  const auto samples = jobContext_.inspector.probes().traceFrame(frame, missing, cursor_, goesOn);
  for (std::size_t probe = 0; probe < missing.size(); ++probe) deliver(missing[probe], frame, samples[probe]);
}

std::optional<int> Traces::firstMissing() {
  const int last = std::min(inIdleTime_->second, jobContext_.inspector.shot().frameCount() - 1);
  for (; firstUnsure_ <= last; ++firstUnsure_)
    for (const Probe& probe : subscriptions_.probes.all)
      if (!framesOf(probe).contains(firstUnsure_)) return firstUnsure_;
  return {};
}

bool Traces::isMissingOne() {
  return inIdleTime_ && isWanted_ && jobContext_.isOpen() && !transport_.isPlaying() && firstMissing();
}

// A frame that cannot be made is not tried again.
void Traces::makeOne() {
  const bool isDone = jobContext_.attempt(RequestKind::Traces, [this] { trace(*firstMissing()); });
  if (!isDone && !jobContext_.waiting().any()) inIdleTime_.reset();
}

} // namespace taa
