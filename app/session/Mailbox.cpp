#include "app/session/Mailbox.h"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>
#include <variant>
#include <vector>

namespace taa::app {

namespace {

constexpr std::size_t kMaxProfiles = 120; // the panel shows no more
constexpr std::size_t kMaxMetrics = 4096; // some seconds of a window that does not look

void keepNewest(std::vector<Thumbnail>& thumbnails, Thumbnail newest) {
  const auto old = std::ranges::find(thumbnails, newest.id, &Thumbnail::id);
  if (old != thumbnails.end())
    *old = std::move(newest);
  else
    thumbnails.push_back(std::move(newest));
}

void keepNewest(std::vector<ProbeResult>& probes, ProbeResult newest) {
  const auto old = std::ranges::find(probes, newest.probe, &ProbeResult::probe);
  if (old != probes.end())
    *old = std::move(newest);
  else
    probes.push_back(std::move(newest));
}

// What becomes of each kind of result.
struct Keep {
  Delivery& delivery;

  void operator()(ViewResult result) const {
    if (result.view < 0 || result.view >= kViewCount) return;
    delivery.pictures[static_cast<std::size_t>(result.view)] = std::move(result);
  }
  void operator()(ProbeResult result) const { keepNewest(delivery.probes, std::move(result)); }
  void operator()(Status status) const { delivery.status = std::move(status); }
  void operator()(Work work) const { delivery.work = std::move(work); }
  void operator()(Failure failure) const { delivery.errors.push_back(std::move(failure)); }
  void operator()(FrameProfile profile) const {
    if (delivery.profiles.size() < kMaxProfiles) delivery.profiles.push_back(std::move(profile));
  }
  void operator()(StageCosts costs) const { delivery.costs = std::move(costs); }
  void operator()(Thumbnail thumbnail) const { keepNewest(delivery.thumbnails, std::move(thumbnail)); }
  void operator()(FrameMetrics metrics) const {
    if (delivery.metrics.size() < kMaxMetrics) delivery.metrics.push_back(std::move(metrics));
  }
  void operator()(ShadersRead shaders) const { delivery.shaders = std::move(shaders); }
  void operator()(ExportResult exported) const { delivery.exported = std::move(exported); }
  void operator()(ObjectArea area) const { delivery.area = std::move(area); }
  void operator()(WorstDelivery worst) const { delivery.worst = worst; }
  void operator()(LineageDelivery lineage) const { delivery.lineage = std::move(lineage); }
  void operator()(StageShares shares) const { delivery.shares = std::move(shares); }
  void operator()(TraceDelivery trace) const { delivery.traces.push_back(std::move(trace)); }
  void operator()(VerdictDelivery verdict) const { delivery.verdict = std::move(verdict); }
};

} // namespace

void Mailbox::put(Answer answer) {
  {
    const std::lock_guard lock(mutex_);
    std::visit(Keep{delivery_}, std::move(answer.result));
    if (posted_) return;
    posted_ = true;
  }
  post_();
}

} // namespace taa::app
