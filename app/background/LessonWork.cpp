#include "app/background/LessonWork.h"

#include "core/gl/Turn.h"
#include "core/inspect/Inspector.h"

#include <utility>

namespace taa::app {

namespace {

/// With an Inspector of its own.
std::vector<CheckedCondition> checkedAlone(const LessonState& state, const std::vector<Condition>& conditions,
                                           const Progress& progress) {
  gl::Turn turn;
  Inspector inspector;
  return checkConditions(inspector, state, conditions, turn.passing(progress));
}

} // namespace

LessonWork::LessonWork(Check check, QObject* parent)
    : BackgroundWork(parent), check_(check ? std::move(check) : checkedAlone) {}

void LessonWork::begin(const LessonState& state, const std::vector<Condition>& conditions) {
  start([this, state, conditions, check = check_](const Deliver& deliver, const Progress& progress) {
    deliver([this, found = check(state, conditions, progress)] { Q_EMIT checked(found); });
  });
}

} // namespace taa::app
