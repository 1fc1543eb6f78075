// Draws the reference of the frame on show while nothing else is to be done.
#pragma once

#include "core/jobs/desk/Wanted.h"
#include "core/jobs/idle/Refinement.h"

namespace taa {

class ReferenceDrawing final : public Refinement {
 public:
  ReferenceDrawing(Desk& desk, const Transport& transport, Wanted& wanted)
      : Refinement(desk, transport), wanted_(wanted) {}

  using Refinement::take;
  void take(const request::SetReferenceSamples& wanted);
  void take(const request::SetProbes& probes);

 private:
  bool isWanted(int lane) const override;
  void refine(int lane) override;

  Wanted& wanted_;
  bool isProbed_ = false; // probes are to come with it
};

} // namespace taa
