#include "core/jobs/idle/ThumbnailDrawing.h"

#include "core/measure/StageShares.h"

#include <utility>

namespace taa {

std::optional<Job::Clock::time_point> ThumbnailDrawing::dueAt() {
  if (!jobContext_.isOpen()) return {};
  return schedule_.dueAt(jobContext_.version(), Clock::now(),
                         transport_.isPlaying() ? std::optional(transport_.nextFrameAt()) : std::nullopt);
}

bool ThumbnailDrawing::isDue() {
  const auto due = dueAt();
  return due && *due <= Clock::now();
}

void ThumbnailDrawing::step() {
  const Clock::time_point began = Clock::now();
  // Shares first, then the thumbnails, which wait.
  if (!transport_.isPlaying() && sharesDelivered_ != jobContext_.version()) {
    deliverShares();
    return;
  }
  const bool isDrawn = jobContext_.attempt(RequestKind::Thumbnails, [&] {
    const IntermediateId id = schedule_.next();
    jobContext_.tell(RequestKind::Thumbnails,
                     Thumbnail{id, jobContext_.inspector.shot().frame(),
                               jobContext_.inspector.views().thumbnail(id, schedule_.texels()),
                               jobContext_.shotVersion()});
  });
  if (!isDrawn) {
    schedule_.want({});
    return;
  } // told once; wanted again when the window says so
  schedule_.drawn(began, Clock::now());
}

void ThumbnailDrawing::deliverShares() {
  sharesDelivered_ = jobContext_.version();
  jobContext_.attempt(RequestKind::Thumbnails, [this] {
    const InspectedShot& shot = jobContext_.inspector.shot();
    StageShares shares{.frame = shot.frame(), .startsHistory = shot.info().startsHistory, .stages = {}};
    shares.stages = sharesOf(jobContext_.inspector.views().images(shareRows()), shot.usedSettings());
    jobContext_.tell(RequestKind::Thumbnails, std::move(shares));
  });
}

} // namespace taa
