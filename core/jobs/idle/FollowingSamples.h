// What the active probe's pixel is made of, looked for while nothing else is to be done.
#pragma once

#include "core/jobs/desk/Job.h"
#include "core/jobs/desk/Transport.h"
#include "core/jobs/desk/Wanted.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>

namespace taa {

class FollowingSamples final : public Job {
 public:
  FollowingSamples(Desk& desk, const Transport& transport, const Wanted& wanted)
      : desk_(desk), transport_(transport), wanted_(wanted) {}

  void take(const request::SetLineage& wanted);
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

  Desk& desk_;
  const Transport& transport_;
  const Wanted& wanted_;
  int frames_ = 0;
  std::optional<Followed> followed_; // last, or given up
};

} // namespace taa
