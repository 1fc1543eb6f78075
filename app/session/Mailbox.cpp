#include "app/session/Mailbox.h"

#include <algorithm>
#include <utility>

namespace taa::app {

namespace {

constexpr std::size_t kMostProfiles = 120; // the panel shows no more
constexpr std::size_t kMostFigures = 4096; // some seconds of a window that does not look

void keepNewest(std::vector<Thumbnail>& thumbnails, Thumbnail newest) {
  const auto old = std::ranges::find(thumbnails, newest.id, &Thumbnail::id);
  if (old != thumbnails.end())
    *old = std::move(newest);
  else
    thumbnails.push_back(std::move(newest));
}

void keepNewest(std::vector<ProbeResult>& probes, ProbeResult newest) {
  const auto old = std::ranges::find(probes, newest.pin, &ProbeResult::pin);
  if (old != probes.end())
    *old = std::move(newest);
  else
    probes.push_back(std::move(newest));
}

} // namespace

RenderListener listenerOf(Mailbox& mailbox) {
  RenderListener listener;
  listener.onPicture = [&mailbox](ViewResult result) {
    if (result.view < 0 || result.view >= kViewCount) return;
    mailbox.put([&](Delivery& delivery) {
      delivery.pictures[static_cast<std::size_t>(result.view)] = std::move(result);
    });
  };
  listener.onProbe = [&mailbox](ProbeResult result) {
    mailbox.put([&](Delivery& delivery) { keepNewest(delivery.probes, std::move(result)); });
  };
  listener.onStatus = [&mailbox](Status status) {
    mailbox.put([&](Delivery& delivery) { delivery.status = std::move(status); });
  };
  listener.onWork = [&mailbox](Work work) {
    mailbox.put([&](Delivery& delivery) { delivery.work = std::move(work); });
  };
  listener.onError = [&mailbox](Failure failure) {
    mailbox.put([&](Delivery& delivery) { delivery.errors.push_back(std::move(failure)); });
  };
  listener.onProfile = [&mailbox](FrameProfile profile) {
    mailbox.put([&](Delivery& delivery) {
      if (delivery.profiles.size() < kMostProfiles) delivery.profiles.push_back(std::move(profile));
    });
  };
  listener.onStageCosts = [&mailbox](StageCosts costs) {
    mailbox.put([&](Delivery& delivery) { delivery.costs = std::move(costs); });
  };
  listener.onThumbnail = [&mailbox](Thumbnail thumbnail) {
    mailbox.put([&](Delivery& delivery) { keepNewest(delivery.thumbnails, std::move(thumbnail)); });
  };
  listener.onFigures = [&mailbox](FrameFigures figures) {
    mailbox.put([&](Delivery& delivery) {
      if (delivery.figures.size() < kMostFigures) delivery.figures.push_back(figures);
    });
  };
  listener.onShaders = [&mailbox](std::string error) {
    mailbox.put([&](Delivery& delivery) { delivery.shaders = std::move(error); });
  };
  listener.onExported = [&mailbox](ExportResult result) {
    mailbox.put([&](Delivery& delivery) { delivery.exported = std::move(result); });
  };
  listener.onStageShares = [&mailbox](StageShares shares) {
    mailbox.put([&](Delivery& delivery) { delivery.shares = std::move(shares); });
  };
  listener.onObjectArea = [&mailbox](ObjectArea area) {
    mailbox.put([&](Delivery& delivery) { delivery.area = std::move(area); });
  };
  listener.onTrace = [&mailbox](TraceDelivery trace) {
    mailbox.put([&](Delivery& delivery) { delivery.traces.push_back(std::move(trace)); });
  };
  return listener;
}

} // namespace taa::app
