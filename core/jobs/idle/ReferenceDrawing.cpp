#include "core/jobs/idle/ReferenceDrawing.h"

#include "core/base/Say.h"

#include <algorithm>
#include <string_view>

namespace taa {

namespace {

// The picture is shown as often as its error halves: with 4, 16, 64 … samples.
int nextShown(int samples, int goal) {
  int next = kMinReferenceSamples;
  while (next <= samples) next *= 4;
  return std::min(next, goal);
}

} // namespace

void ReferenceDrawing::take(const request::SetReferenceSamples& wanted) {
  wanted_.referenceSamples = std::clamp(wanted.samples, kMinReferenceSamples, kMaxReferenceSamples);
  desk().isStatusOld = true;
  goOn();
}

// Somebody asked for it, who may have stopped it before.
void ReferenceDrawing::take(const request::SetProbes& probes) {
  if (probes.reference && !isProbed_) goOn();
  isProbed_ = probes.reference;
}

bool ReferenceDrawing::isWanted(int lane) const {
  return wanted_.needsReferenceOf(lane) &&
         desk().inspector.reference().samples(lane) != wanted_.referenceSamples;
}

void ReferenceDrawing::refine(int lane) {
  ReferenceOfShot& reference = desk().inspector.reference();
  const auto told = [this](std::string_view, int done, int) {
    desk().tellWork(WorkKind::Reference, say<"Drawing the reference">(), done, wanted_.referenceSamples);
    return !desk().waiting().any();
  };
  reference.refine(nextShown(reference.samples(lane), wanted_.referenceSamples), told, lane);
}

} // namespace taa
