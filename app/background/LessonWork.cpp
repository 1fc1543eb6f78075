#include "app/background/LessonWork.h"

#include "core/gl/ContextLock.h"
#include "core/inspect/Inspector.h"
#include "core/lessons/RecordedFrames.h"

#include <utility>

namespace taa::app {

namespace {

/// With an Inspector of its own.
std::vector<CheckedCondition> checkedAlone(const LessonState& state, const std::vector<Condition>& conditions,
                                           const Progress& progress) {
  gl::ContextLock lock;
  Inspector inspector;
  return checkConditions(inspector, state, conditions, lock.passing(progress));
}

std::vector<LessonNumber> measuredAlone(const LessonState& state, const std::vector<Condition>& conditions,
                                        const Progress& progress) {
  gl::ContextLock lock;
  Inspector inspector;
  return measureNumbers(inspector, state, conditions, lock.passing(progress));
}

LessonState recordedAlone(const LessonState& state, const Progress& progress) {
  gl::ContextLock lock;
  Inspector inspector;
  return onItsFrames(inspector, state, lock.passing(progress));
}

} // namespace

LessonWork::LessonWork(Check check, Record record, QObject* parent)
    : BackgroundWork(parent), check_(check ? std::move(check) : checkedAlone),
      record_(record ? std::move(record) : recordedAlone) {}

void LessonWork::begin(const LessonState& state, const std::vector<Condition>& conditions) {
  start([this, state, conditions, check = check_](const Deliver& deliver, const Progress& progress) {
    deliver([this, found = check(state, conditions, progress)] { Q_EMIT checked(found); });
  });
}

void LessonWork::measure(const LessonState& state, const std::vector<Condition>& conditions) {
  start([this, state, conditions](const Deliver& deliver, const Progress& progress) {
    deliver([this, found = measuredAlone(state, conditions, progress)] { Q_EMIT measured(found); });
  });
}

void LessonWork::record(const LessonState& state) {
  start([this, state, record = record_](const Deliver& deliver, const Progress& progress) {
    deliver([this, opened = record(state, progress)] { Q_EMIT recorded(opened); });
  });
}

} // namespace taa::app
