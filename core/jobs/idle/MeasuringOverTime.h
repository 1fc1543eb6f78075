// Measures what rows over time are made of, up to the frame on show, while nothing else is to be done.
#pragma once

#include "core/jobs/context/Subscriptions.h"
#include "core/jobs/idle/Refinement.h"

#include <vector>

namespace taa {

class MeasuringOverTime final : public Refinement {
 public:
  MeasuringOverTime(JobContext& jobContext, const Transport& transport, const Subscriptions& subscriptions)
      : Refinement(jobContext, transport), subscriptions_(subscriptions) {}

 private:
  bool isWanted(int lane) const override;
  void refine(int lane) override;
  /// Kinds of which more is wanted than there is.
  std::vector<OverTime> kindsOf(int lane) const;

  const Subscriptions& subscriptions_;
};

} // namespace taa
