// What is made of the frame on show little by little while nothing else is to be done, lane by lane.
#pragma once

#include "core/jobs/context/Job.h"
#include "core/jobs/context/Transport.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>

namespace taa {

class Refinement : public Job {
 public:
  Refinement(JobContext& jobContext, const Transport& transport)
      : jobContext_(jobContext), transport_(transport) {}

  void take(const request::SetReferenceSamples&) { goOn(); }
  void take(const request::FindWorst&) { goOn(); }
  void take(const request::Cancel&) { stop(); }
  void settle() override { endIfDone(); }

  bool isDue() override { return lane().has_value(); }
  /// Until the next picture that is to be shown, or a request: what is there is kept.
  void step() override;

 protected:
  JobContext& jobContext() { return jobContext_; }
  const JobContext& jobContext() const { return jobContext_; }
  void goOn() { stoppedAt_ = 0; }

 private:
  /// Whether somebody wants more of this lane than there is.
  virtual bool isWanted(int lane) const = 0;
  /// Throws Cancelled where a request waits.
  virtual void refine(int lane) = 0;

  std::optional<int> lane() const;
  void stop() { stoppedAt_ = jobContext_.version(); }
  void endIfDone();

  JobContext& jobContext_;
  const Transport& transport_;
  std::uint64_t stoppedAt_ = 0; // version that it was cancelled or failed for
  bool isTold_ = false;         // somebody was told that it is under way
};

} // namespace taa
