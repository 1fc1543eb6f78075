// What the render thread does for the reference in idle time.
#include "core/base/Say.h"
#include "core/jobs/RenderWorker.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace taa {

namespace {

bool needsReferenceFor(Figure figure) {
  return figureInfo(figure).needsReference;
}

// The picture is shown as often as its error halves: with 4, 16, 64 … samples.
int nextShown(int samples, int goal) {
  int next = kLeastReferenceSamples;
  while (next <= samples) next *= 4;
  return std::min(next, goal);
}

} // namespace

void RenderWorker::applyReference(const Wishes& wishes) {
  if (wishes.cancel) reference_.stoppedAt = version_;
  if (wishes.referenceSamples) {
    reference_.goal = std::clamp(*wishes.referenceSamples, kLeastReferenceSamples, kMostReferenceSamples);
    reference_.stoppedAt = 0;
    statusChanged_ = true;
  }
}

// The lane of the next reference to draw samples of; nothing where each that somebody wants is whole.
std::optional<int> RenderWorker::laneOfReference() const {
  if (!isOpen() || playing_ || reference_.stoppedAt == version_) return {};
  const bool isCompared = std::ranges::any_of(figures_.wanted, needsReferenceFor);
  for (int lane = 0; lane < inspector_.shot().laneCount(); ++lane) {
    const bool isShown = std::ranges::any_of(views_, [lane](const ViewRequest& view) {
      const auto isIt = [lane](const auto& side) {
        return side.lane == lane && needsReference(side.id) && !isOverTime(side.id);
      };
      return view.width > 0 && view.height > 0 && (isIt(view) || (view.other && isIt(*view.other)));
    });
    if ((isShown || isCompared) && inspector_.reference().samples(lane) != reference_.goal) return lane;
  }
  return {};
}

// Until the next picture that is shown, or a wish.
void RenderWorker::refineReference(int lane) {
  const auto told = [this](std::string_view, int done, int) {
    if (listener_.onWork) listener_.onWork({say<"Drawing the reference">(), done, reference_.goal});
    return !ends_ && !pending_(isAny);
  };
  const int goal = nextShown(inspector_.reference().samples(lane), reference_.goal);
  reference_.isTold = true;
  bool goesOn = false;
  const bool isDone = attempt(RequestKind::Reference, [&] {
    try {
      inspector_.reference().refine(goal, told, lane);
    } catch (const Cancelled&) {
      goesOn = true;
    }
  });
  if (!isDone) reference_.stoppedAt = version_;
  if (isDone && !goesOn) {
    ++reference_.version;
    pinsDelivered_ = 0;
    deliver(); // the last one, too: there may be nothing to do after it
  }
  endReference();
}

// Once nobody waits for it any more.
void RenderWorker::endReference() {
  if (!reference_.isTold || laneOfReference()) return;
  reference_.isTold = false;
  if (listener_.onWork) listener_.onWork({});
}

// Samples of the references that the flicker of a lane is wanted against, 0: without any; −1: nobody wants
// it.
int RenderWorker::flickerSamplesFor(int lane) const {
  int samples = -1;
  const auto want = [&](bool isCompared) { samples = std::max(samples, isCompared ? reference_.goal : 0); };
  for (const Figure figure : figures_.wanted)
    if (figureInfo(figure).isOverTime) want(figureInfo(figure).needsReference);
  for (const ViewRequest& view : views_) {
    if (view.width <= 0 || view.height <= 0) continue;
    if (view.lane == lane && isOverTime(view.id)) want(needsReference(view.id));
    if (view.other && view.other->lane == lane && isOverTime(view.other->id))
      want(needsReference(view.other->id));
  }
  return samples;
}

// The next lane whose flicker is to be measured; nothing where it is known where somebody wants it.
std::optional<int> RenderWorker::laneOfFlicker() const {
  if (!isOpen() || playing_ || reference_.stoppedAt == version_) return {};
  for (int lane = 0; lane < inspector_.shot().laneCount(); ++lane)
    if (const int wanted = flickerSamplesFor(lane); wanted >= 0) {
      const std::optional<int> known = inspector_.flicker().samples(lane);
      if (!known || (wanted > 0 && *known != wanted)) return lane;
    }
  return {};
}

// Any wish is answered first, and what is there of the frames is kept.
void RenderWorker::refineFlicker(int lane) {
  const auto told = [this](std::string_view, int done, int total) {
    if (listener_.onWork && total > 0) listener_.onWork({say<"Measuring the flicker">(), done, total});
    return !ends_ && !pending_(isAny);
  };
  reference_.isFlickerTold = true;
  bool goesOn = false;
  const bool isDone = attempt(RequestKind::Reference, [&] {
    try {
      inspector_.flicker().refine(flickerSamplesFor(lane), told, lane);
    } catch (const Cancelled&) {
      goesOn = true;
    }
  });
  if (!isDone) reference_.stoppedAt = version_;
  if (isDone && !goesOn) {
    ++reference_.version;
    pinsDelivered_ = 0;
    deliver();
  }
  endFlicker();
}

void RenderWorker::endFlicker() {
  if (!reference_.isFlickerTold || laneOfFlicker()) return;
  reference_.isFlickerTold = false;
  if (listener_.onWork) listener_.onWork({});
}

void RenderWorker::addReference(ViewResult& result) {
  if (isOverTime(result.request.id)) {
    const Figure figure = needsReference(result.request.id) ? Figure::Flicker : Figure::Deviation;
    const FrameFigures figures = inspector_.metrics().figures({figure}, result.request.lane);
    result.flickerSamples = figures.flickerSamples;
    result.flicker = figures.at(figure);
    return;
  }
  result.referenceSamples = inspector_.reference().samples(result.request.lane);
  if (result.referenceSamples > 0) result.error = inspector_.reference().error(result.request.lane);
}

} // namespace taa
