#include "core/jobs/idle/ThumbnailDrawing.h"

#include "core/measure/StageShares.h"

#include <utility>

namespace taa {

std::optional<Job::Clock::time_point> ThumbnailDrawing::dueAt() {
  if (!desk_.isOpen()) return {};
  return schedule_.dueAt(desk_.version(), Clock::now(),
                         transport_.isPlaying() ? std::optional(transport_.nextFrameAt()) : std::nullopt);
}

bool ThumbnailDrawing::isDue() {
  const auto due = dueAt();
  return due && *due <= Clock::now();
}

void ThumbnailDrawing::step() {
  const Clock::time_point began = Clock::now();
  // Shares first, then the thumbnails, which wait.
  if (!transport_.isPlaying() && sharesDelivered_ != desk_.version()) {
    deliverShares();
    return;
  }
  const bool isDrawn = desk_.attempt(RequestKind::Thumbnails, [&] {
    const IntermediateId id = schedule_.next();
    desk_.tell(RequestKind::Thumbnails,
               Thumbnail{id, desk_.inspector.shot().frame(),
                         desk_.inspector.views().thumbnail(id, schedule_.texels()), desk_.shotVersion()});
  });
  if (!isDrawn) {
    schedule_.want({});
    return;
  } // told once; wanted again when the window says so
  schedule_.drawn(began, Clock::now());
}

void ThumbnailDrawing::deliverShares() {
  sharesDelivered_ = desk_.version();
  desk_.attempt(RequestKind::Thumbnails, [this] {
    const InspectedShot& shot = desk_.inspector.shot();
    StageShares shares{.frame = shot.frame(), .startsHistory = shot.info().startsHistory, .stages = {}};
    shares.stages = sharesOf(desk_.inspector.views().images(shareRows()), shot.usedSettings());
    desk_.tell(RequestKind::Thumbnails, std::move(shares));
  });
}

} // namespace taa
