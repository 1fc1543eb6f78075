// Delivers metrics of each frame on show, and measures those of the other frames while nothing else is to be
// done.
#pragma once

#include "core/inspect/MetricCursor.h"
#include "core/jobs/context/Job.h"
#include "core/jobs/context/Subscriptions.h"
#include "core/jobs/context/Transport.h"
#include "core/jobs/idle/ThumbnailDrawing.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>
#include <set>
#include <utility>

namespace taa {

class MetricMeasuring final : public Job {
 public:
  MetricMeasuring(JobContext& jobContext, const Transport& transport, Subscriptions& subscriptions,
                  ThumbnailDrawing& thumbnails)
      : jobContext_(jobContext), transport_(transport), subscriptions_(subscriptions),
        thumbnails_(thumbnails) {}

  void take(const request::SetMetrics& subscriptions);
  void take(const request::SetReferenceSamples&) { forget(); }
  void take(const request::Cancel&) { isStopped_ = true; }
  void settle() override;

  bool isDue() override { return frame().has_value(); }
  /// One frame; any request is answered first, and what is there of its reference is kept.
  void step() override;
  /// Those of the frame on show.
  void deliver();

 private:
  void forget();
  std::optional<int> frame() const;
  bool isMissing(int frame) const;
  int firstOfRow(int frame) const;
  void tell(FrameMetrics metrics);
  bool isWhole(const FrameMetrics& metrics) const;
  void endIfDone();

  JobContext& jobContext_;
  const Transport& transport_;
  Subscriptions& subscriptions_;
  ThumbnailDrawing& thumbnails_;
  std::pair<std::uint64_t, std::uint64_t> deliveredOf_; // versions of frame and reference
  std::uint64_t shotVersion_ = 0;                       // what follows is of this one
  std::set<int> known_;                                 // frames whose metrics are whole
  std::optional<std::pair<int, int>> row_;              // frames that are measured one after the other
  int around_ = 0;                                      // the frame on show when that was decided
  MetricCursor cursor_;
  bool isStopped_ = false; // cancelled or failed
  bool isTold_ = false;    // somebody was told that it is under way
};

} // namespace taa
