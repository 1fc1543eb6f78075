// Draws small pictures of the stages, and counts what the stages changed, where nothing else waits.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/Transport.h"
#include "core/jobs/idle/ThumbnailSchedule.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>

namespace taa {

class ThumbnailDrawing final : public Job {
 public:
  ThumbnailDrawing(JobContext& jobContext, const Transport& transport)
      : jobContext_(jobContext), transport_(transport) {}

  void take(const request::SetThumbnails& subscriptions) {
    schedule_.want({subscriptions.width, subscriptions.height});
  }

  bool isDue() override;
  void step() override;
  std::optional<Clock::time_point> wakesAt() override { return dueAt(); }
  bool isAwaited() const override { return false; }

 private:
  std::optional<Clock::time_point> dueAt();
  void deliverShares();

  JobContext& jobContext_;
  const Transport& transport_;
  ThumbnailSchedule schedule_;
  std::uint64_t sharesDelivered_ = 0; // version
};

} // namespace taa
