// Draws the reference of the frame on show while nothing else is to be done.
#pragma once

#include "core/jobs/Job.h"
#include "core/jobs/Transport.h"
#include "core/jobs/Wanted.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>

namespace taa {

class ReferenceDrawing final : public Job {
 public:
  ReferenceDrawing(Desk& desk, const Transport& transport, Wanted& wanted)
      : desk_(desk), transport_(transport), wanted_(wanted) {}

  void take(const request::SetReferenceSamples& wanted);
  void take(const request::Cancel&) { stoppedAt_ = desk_.version(); }
  void settle() override { endIfDone(); }

  bool isDue() override { return lane().has_value(); }
  /// Until the next picture that is shown, or a request.
  void step() override;

 private:
  std::optional<int> lane() const;
  void endIfDone();

  Desk& desk_;
  const Transport& transport_;
  Wanted& wanted_;
  std::uint64_t stoppedAt_ = 0; // version that it was cancelled or failed for
  bool isTold_ = false;         // somebody was told that it is under way
};

} // namespace taa
