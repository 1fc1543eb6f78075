#include "core/jobs/idle/PixelJudging.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"

#include <exception>
#include <utility>

namespace taa {

void PixelJudging::take(const request::SetVerdicts& subscriptions) {
  isWanted_ = subscriptions.on;
  known_ = {};
}

// It is not asked for again: whoever waits is told.
void PixelJudging::take(const request::Cancel&) {
  if (isDue()) giveUp(say<"it was stopped">());
}

void PixelJudging::noteShown(const ProbeResult& result) {
  shown_.reset();
  if (!result.exact || result.around.empty()) return;
  shown_ = {result.frame, {result.x, result.y}, jobContext_.version(), jobContext_.shotVersion()};
}

bool PixelJudging::isKnown() const {
  const VerdictDelivery& of = known_.delivery;
  const bool isAny = of.answer || !of.whyNot.empty() || known_.search.before;
  return isAny && of.frame == shown_->frame && of.pixel == shown_->pixel &&
         of.shotVersion == shown_->shotVersion;
}

void PixelJudging::beginAnew() {
  known_ = {};
  known_.delivery.frame = shown_->frame;
  known_.delivery.pixel = shown_->pixel;
  known_.delivery.shotVersion = shown_->shotVersion;
}

bool PixelJudging::isDue() {
  return isWanted_ && jobContext_.isOpen() && !transport_.isPlaying() && shown_ &&
         shown_->version == jobContext_.version() && !(isKnown() && known_.isWhole);
}

void PixelJudging::step() {
  if (!isKnown()) beginAnew();
  isTold_ = true;
  try {
    tryOn();
  } catch (const Cancelled&) { // goes on later
  } catch (const std::exception& error) {
    giveUp(shownReason(error)); // where it is missed, not as an error: nobody pressed a button for it
  }
  endIfDone();
}

void PixelJudging::tryOn() {
  VerdictOfShot& verdicts = jobContext_.inspector.verdicts();
  VerdictDelivery& delivery = known_.delivery;
  const VerdictQuestion question{.frame = delivery.frame, .pixel = delivery.pixel};
  if (!delivery.answer) {
    delivery.answer = verdicts.of(
        question, jobContext_.progressUntilAny(WorkKind::Verdict, say<"Looking for the reason">()));
    known_.isWhole = delivery.answer->verdict.kind == VerdictKind::None;
  } else if (!delivery.remedies) {
    delivery.remedies =
        verdicts.triedRemedies(question, *delivery.answer, known_.search,
                               jobContext_.progressUntilAny(WorkKind::Verdict, say<"Trying remedies">()));
    known_.isWhole = delivery.remedies->best.empty();
  } else {
    verdicts.measurePictures(
        question, *delivery.answer, *delivery.remedies, known_.search,
        jobContext_.progressUntilAny(WorkKind::Verdict, say<"Measuring what remedies cost">()));
    known_.isWhole = true;
  }
  jobContext_.tell(RequestKind::Verdicts, delivery);
}

void PixelJudging::giveUp(const std::string& whyNot) {
  if (!isKnown()) beginAnew();
  known_.delivery.whyNot = whyNot;
  known_.isWhole = true;
  jobContext_.tell(RequestKind::Verdicts, known_.delivery);
}

void PixelJudging::endIfDone() {
  if (!isTold_ || isDue()) return;
  isTold_ = false;
  jobContext_.endWork();
}

} // namespace taa
