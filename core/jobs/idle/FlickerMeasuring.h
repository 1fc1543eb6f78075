// Measures the flicker of what is shown up to the frame on show while nothing else is to be done.
#pragma once

#include "core/jobs/Wanted.h"
#include "core/jobs/idle/Refinement.h"

namespace taa {

class FlickerMeasuring final : public Refinement {
 public:
  FlickerMeasuring(Desk& desk, const Transport& transport, const Wanted& wanted)
      : Refinement(desk, transport), wanted_(wanted) {}

 private:
  bool isWanted(int lane) const override;
  void refine(int lane) override;

  const Wanted& wanted_;
};

} // namespace taa
