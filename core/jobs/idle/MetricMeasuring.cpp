#include "core/jobs/idle/MetricMeasuring.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace taa {

namespace {

constexpr int kFramesInARow = 8; ///< since each goes on from the one before

bool isOverTimeMetric(Metric metric) {
  return metricInfo(metric).isOverTime;
}

bool needsReferenceFor(Metric metric) {
  return metricInfo(metric).needsReference;
}

bool isCheapMetric(Metric metric) {
  return !metricInfo(metric).isCostly;
}

// Where each takes many frames before it the first of a row is dear.
int framesInARow(const std::vector<Metric>& subscriptions) {
  return std::ranges::any_of(subscriptions, isOverTimeMetric) ? 4 * kFlickerFrames : kFramesInARow;
}

} // namespace

void MetricMeasuring::take(const request::SetMetrics& subscriptions) {
  subscriptions_.metrics = subscriptions.metrics;
  deliveredOf_ = {};
  forget();
}

void MetricMeasuring::forget() {
  shotVersion_ = jobContext_.shotVersion();
  known_.clear();
  row_.reset();
  cursor_ = {};
  isStopped_ = false;
}

void MetricMeasuring::settle() {
  if (shotVersion_ != jobContext_.shotVersion()) forget();
  endIfDone();
}

void MetricMeasuring::deliver() {
  const std::pair now(jobContext_.version(), jobContext_.referenceVersion);
  if (subscriptions_.metrics.empty() || deliveredOf_ == now) return;
  deliveredOf_ = now;        // also when it fails: once is enough to tell
  std::vector<Metric> cheap; // the others come while nothing else is to be done
  std::ranges::copy_if(subscriptions_.metrics, std::back_inserter(cheap), isCheapMetric);
  jobContext_.attempt(RequestKind::Metrics, [&] {
    const int lanes = jobContext_.inspector.shot().laneCount();
    for (int lane = 0; lane < lanes; ++lane) tell(jobContext_.inspector.metrics().measure(cheap, lane));
  });
}

bool MetricMeasuring::isWhole(const FrameMetrics& metrics) const {
  const int samples = subscriptions_.referenceSamples;
  if (std::ranges::any_of(subscriptions_.metrics, needsReferenceFor) && metrics.referenceSamples != samples)
    return false;
  return std::ranges::none_of(subscriptions_.metrics, [&](Metric metric) {
    if (!isCheapMetric(metric) && !metrics.at(metric)) return true;
    const int needed = metricInfo(metric).needsReference ? samples : 0;
    return isOverTimeMetric(metric) && samplesOf(metrics, overTimeOf(metric)).value_or(-1) < needed;
  });
}

void MetricMeasuring::tell(FrameMetrics metrics) {
  if (metrics.lane == 0 && metrics.exact && isWhole(metrics)) known_.insert(metrics.frame);
  metrics.shotVersion = jobContext_.shotVersion();
  jobContext_.tell(RequestKind::Metrics, std::move(metrics));
}

bool MetricMeasuring::isMissing(int frame) const {
  const auto [first, last] = transport_.frames();
  return frame >= first && frame <= last && !known_.contains(frame);
}

// Of those before it as many as one way brings along.
int MetricMeasuring::firstOfRow(int frame) const {
  const int now = jobContext_.inspector.shot().frame();
  int first = frame;
  while (frame < now && frame - first + 1 < framesInARow(subscriptions_.metrics) && isMissing(first - 1))
    --first;
  return first;
}

// The next frame whose metrics are missing: of those that are played the nearest to the one on show, and what
// is missing right behind it.
std::optional<int> MetricMeasuring::frame() const {
  if (subscriptions_.metrics.empty() || isStopped_ || shotVersion_ != jobContext_.shotVersion() ||
      !jobContext_.isOpen() || transport_.isPlaying())
    return {};
  const int now = jobContext_.inspector.shot().frame();
  if (row_ && around_ == now)
    for (int frame = row_->first; frame <= row_->second; ++frame)
      if (isMissing(frame)) return frame;
  const int count = jobContext_.inspector.shot().frameCount();
  for (int distance = 0; distance <= count; ++distance)
    for (const int frame : {now + distance, now - distance})
      if (isMissing(frame)) return firstOfRow(frame);
  return {};
}

void MetricMeasuring::step() {
  const int frame = *this->frame();
  const int now = jobContext_.inspector.shot().frame();
  if (!row_ || around_ != now || frame < row_->first || frame > row_->second) {
    row_ = {frame, frame + framesInARow(subscriptions_.metrics) - 1};
    around_ = now;
  }
  const auto [first, last] = transport_.frames();
  const auto done = std::ranges::count_if(
      known_, [from = first, to = last](int known) { return known >= from && known <= to; });
  isTold_ = true;
  jobContext_.tellWork(WorkKind::Metrics, say<"Measuring the frames">(), static_cast<int>(done),
                       last - first + 1);
  const auto goesOn = [this](std::string_view, int, int) {
    return !jobContext_.waiting().any() && !thumbnails_.isDue(); // they come first, too
  };
  const bool isDone = jobContext_.attempt(RequestKind::Metrics, [&] {
    try {
      tell(jobContext_.inspector.metrics().measureFrame(frame, subscriptions_.metrics,
                                                        subscriptions_.referenceSamples, cursor_, goesOn));
    } catch (const Cancelled&) { // goes on later
    }
  });
  if (!isDone) isStopped_ = true;
  endIfDone();
}

// There is nothing more to measure.
void MetricMeasuring::endIfDone() {
  if (!isTold_ || frame()) return;
  isTold_ = false;
  if (!transport_.isPlaying()) cursor_ = {}; // else it goes on soon
  jobContext_.endWork();
}

} // namespace taa
