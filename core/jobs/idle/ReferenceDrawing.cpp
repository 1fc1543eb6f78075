#include "core/jobs/idle/ReferenceDrawing.h"

#include "core/base/Say.h"

#include <algorithm>
#include <string_view>

namespace taa {

namespace {

// The picture is shown as often as its error halves: with 4, 16, 64 … samples.
int nextShown(int samples, int seekTarget) {
  int next = kMinReferenceSamples;
  while (next <= samples) next *= 4;
  return std::min(next, seekTarget);
}

} // namespace

void ReferenceDrawing::take(const request::SetReferenceSamples& subscriptions) {
  subscriptions_.referenceSamples =
      std::clamp(subscriptions.samples, kMinReferenceSamples, kMaxReferenceSamples);
  jobContext().isStatusOld = true;
  goOn();
}

// Somebody asked for it, who may have stopped it before.
void ReferenceDrawing::take(const request::SetProbes& probes) {
  if (probes.reference && !isProbed_) goOn();
  isProbed_ = probes.reference;
}

bool ReferenceDrawing::isWanted(int lane) const {
  return subscriptions_.needsReferenceOf(lane) &&
         jobContext().inspector.reference().samples(lane) != subscriptions_.referenceSamples;
}

void ReferenceDrawing::refine(int lane) {
  ReferenceOfShot& reference = jobContext().inspector.reference();
  const auto told = [this](std::string_view, int done, int) {
    jobContext().tellWork(WorkKind::Reference, say<"Drawing the reference">(), done,
                          subscriptions_.referenceSamples);
    return !jobContext().waiting().any();
  };
  reference.refine(nextShown(reference.samples(lane), subscriptions_.referenceSamples), told, lane);
}

} // namespace taa
