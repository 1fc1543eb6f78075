// Draws the reference of the frame on show while nothing else is to be done.
#pragma once

#include "core/jobs/context/Subscriptions.h"
#include "core/jobs/idle/Refinement.h"

namespace taa {

class ReferenceDrawing final : public Refinement {
 public:
  ReferenceDrawing(JobContext& jobContext, const Transport& transport, Subscriptions& subscriptions)
      : Refinement(jobContext, transport), subscriptions_(subscriptions) {}

  using Refinement::take;
  void take(const request::SetReferenceSamples& subscriptions);
  void take(const request::SetProbes& probes);

 private:
  bool isWanted(int lane) const override;
  void refine(int lane) override;

  Subscriptions& subscriptions_;
  bool isProbed_ = false; // probes are to come with it
};

} // namespace taa
