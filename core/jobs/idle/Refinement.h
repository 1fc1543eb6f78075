// What is made of the frame on show little by little while nothing else is to be done, lane by lane.
#pragma once

#include "core/jobs/desk/Job.h"
#include "core/jobs/desk/Transport.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>

namespace taa {

class Refinement : public Job {
 public:
  Refinement(Desk& desk, const Transport& transport) : desk_(desk), transport_(transport) {}

  void take(const request::SetReferenceSamples&) { goOn(); }
  void take(const request::FindWorst&) { goOn(); }
  void take(const request::Cancel&) { stop(); }
  void settle() override { endIfDone(); }

  bool isDue() override { return lane().has_value(); }
  /// Until the next picture that is to be shown, or a request: what is there is kept.
  void step() override;

 protected:
  Desk& desk() { return desk_; }
  const Desk& desk() const { return desk_; }
  void goOn() { stoppedAt_ = 0; }

 private:
  /// Whether somebody wants more of this lane than there is.
  virtual bool isWanted(int lane) const = 0;
  /// Throws Cancelled where a request waits.
  virtual void refine(int lane) = 0;

  std::optional<int> lane() const;
  void stop() { stoppedAt_ = desk_.version(); }
  void endIfDone();

  Desk& desk_;
  const Transport& transport_;
  std::uint64_t stoppedAt_ = 0; // version that it was cancelled or failed for
  bool isTold_ = false;         // somebody was told that it is under way
};

} // namespace taa
