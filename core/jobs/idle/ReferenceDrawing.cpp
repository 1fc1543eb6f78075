#include "core/jobs/idle/ReferenceDrawing.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace taa {

namespace {

// The picture is shown as often as its error halves: with 4, 16, 64 … samples.
int nextShown(int samples, int goal) {
  int next = kLeastReferenceSamples;
  while (next <= samples) next *= 4;
  return std::min(next, goal);
}

} // namespace

void ReferenceDrawing::take(const request::SetReferenceSamples& wanted) {
  wanted_.referenceSamples = std::clamp(wanted.samples, kLeastReferenceSamples, kMostReferenceSamples);
  stoppedAt_ = 0;
  desk_.isStatusOld = true;
}

// Of the next reference to draw samples of; nothing where each that somebody wants is whole.
std::optional<int> ReferenceDrawing::lane() const {
  if (!desk_.isOpen() || transport_.isPlaying() || stoppedAt_ == desk_.version()) return {};
  const int lanes = desk_.inspector.shot().laneCount();
  for (int lane = 0; lane < lanes; ++lane)
    if (wanted_.needsReferenceOf(lane) &&
        desk_.inspector.reference().samples(lane) != wanted_.referenceSamples)
      return lane;
  return {};
}

void ReferenceDrawing::step() {
  const int lane = *this->lane();
  ReferenceOfShot& reference = desk_.inspector.reference();
  const auto told = [this](std::string_view, int done, int) {
    desk_.tellWork(WorkKind::Reference, say<"Drawing the reference">(), done, wanted_.referenceSamples);
    return !desk_.waiting().any();
  };
  isTold_ = true;
  bool goesOn = false;
  const bool isDone = desk_.attempt(RequestKind::Reference, [&] {
    try {
      reference.refine(nextShown(reference.samples(lane), wanted_.referenceSamples), told, lane);
    } catch (const Cancelled&) {
      goesOn = true;
    }
  });
  if (!isDone) stoppedAt_ = desk_.version();
  if (isDone && !goesOn) ++desk_.referenceVersion;
  endIfDone();
}

// Nobody waits for it any more.
void ReferenceDrawing::endIfDone() {
  if (isTold_ && !lane()) {
    isTold_ = false;
    desk_.endWork();
  }
}

} // namespace taa
