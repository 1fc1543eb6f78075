#include "core/jobs/context/JobContext.h"

#include "core/base/ShownText.h"
#include "core/scene/SceneCost.h"
#include "core/scene/ShotChoice.h"

#include <algorithm>
#include <exception>
#include <string_view>
#include <utility>

namespace taa {

JobContext::JobContext(const Listener& listener, const WaitingRequests& waiting, ClockNow now)
    : listener_(listener), waiting_(waiting), now_(std::move(now)) {}

void JobContext::noteFrame() {
  ++version_;
  isStatusOld = true;
}

void JobContext::noteChange(RequestKind kind) {
  noteFrame();
  noteShotChange();
  if (std::ranges::find(inexactSince_, kind) == inexactSince_.end()) inexactSince_.push_back(kind);
}

void JobContext::tell(RequestKind kind, Result result) const {
  if (!listener_) return;
  listener_({kind == RequestKind::None ? latest_.last() : latest_.of(kind), std::move(result)});
}

void JobContext::tellWork(WorkKind kind, std::string what, int done, int total) const {
  tell(RequestKind::None, Work{kind, std::move(what), done, total});
}

Progress JobContext::progressUntilAny(WorkKind kind, std::string what) const {
  return [this, kind, what = std::move(what)](std::string_view, int done, int total) {
    if (total > 0) tellWork(kind, what, done, total);
    return !waiting_.any();
  };
}

Progress JobContext::progressOfReplay(WorkKind kind, std::string what) const {
  return [this, kind, what = std::move(what)](std::string_view, int done, int total) {
    if (waiting_.endReplay()) return false;
    if (total > 1) tellWork(kind, what, done, total);
    return done == 0 || !waiting_.any();
  };
}

bool JobContext::attempt(RequestKind kind, const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (const Cancelled&) {
    return false; // whoever asked for it knows
  } catch (const std::exception& error) {
    Failure failure{shownReason(error), kind, latest_.of(kind)};
    if (const auto* beyond = dynamic_cast<const BudgetError*>(&error))
      failure.neededBudget = beyond->needed();
    failure.isChoice = kind == RequestKind::Camera || kind == RequestKind::Objects ||
                       dynamic_cast<const ChoiceError*>(&error) != nullptr;
    tell(kind, std::move(failure));
    isStatusOld = true;
    return false;
  }
}

bool JobContext::change(RequestKind kind, const std::function<void()>& action) {
  if (!attempt(kind, action)) return false;
  noteChange(kind);
  isReplayStopped = false;
  return true;
}

} // namespace taa
