// What the active probe's pixel is made of, looked for while nothing else is to be done.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/Subscriptions.h"
#include "core/jobs/context/Transport.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>

namespace taa {

class FollowingSamples final : public Job {
 public:
  FollowingSamples(JobContext& jobContext, const Transport& transport, const Subscriptions& subscriptions)
      : jobContext_(jobContext), transport_(transport), subscriptions_(subscriptions) {}

  void take(const request::SetLineage& subscriptions);
  void take(const request::Cancel&) { followed_ = now(); } // not again until something changes

  bool isDue() override;
  void step() override;

 private:
  /// What is followed: where, and which version of the frame on show.
  struct Followed {
    Probe probe;
    std::uint64_t version = 0;
    bool operator==(const Followed&) const = default;
  };
  std::optional<Followed> now() const;
  void follow();

  JobContext& jobContext_;
  const Transport& transport_;
  const Subscriptions& subscriptions_;
  int frames_ = 0;
  std::optional<Followed> followed_; // last, or given up
};

} // namespace taa
