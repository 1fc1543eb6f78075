// Measures the flicker of what is shown up to the frame on show while nothing else is to be done.
#pragma once

#include "core/jobs/Job.h"
#include "core/jobs/Transport.h"
#include "core/jobs/Wanted.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>

namespace taa {

class FlickerMeasuring final : public Job {
 public:
  FlickerMeasuring(Desk& desk, const Transport& transport, const Wanted& wanted)
      : desk_(desk), transport_(transport), wanted_(wanted) {}

  void take(const request::SetReferenceSamples&) { stoppedAt_ = 0; }
  void take(const request::Cancel&) { stoppedAt_ = desk_.version(); }
  void settle() override { endIfDone(); }

  bool isDue() override { return lane().has_value(); }
  /// Any request is answered first, and what is there of the frames is kept.
  void step() override;

 private:
  std::optional<int> lane() const;
  void endIfDone();

  Desk& desk_;
  const Transport& transport_;
  const Wanted& wanted_;
  std::uint64_t stoppedAt_ = 0; // version that it was cancelled or failed for
  bool isTold_ = false;         // somebody was told that it is under way
};

} // namespace taa
