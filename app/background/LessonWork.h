// Checks what a lesson asks for, measures what it speaks of, and records the frames that it opens, beside the
// window.
#pragma once

#include "app/background/BackgroundWork.h"
#include "core/lessons/LessonCheck.h"
#include "core/lessons/LessonNumbers.h"

#include <functional>
#include <vector>

namespace taa::app {

class LessonWork : public BackgroundWork {
  Q_OBJECT
 public:
  /// Tests put another one in its place.
  using Check = std::function<std::vector<CheckedCondition>(const LessonState&, const std::vector<Condition>&,
                                                            const Progress&)>;
  /// The state on the frames that it records.
  using Record = std::function<LessonState(const LessonState&, const Progress&)>;
  explicit LessonWork(Check check = {}, Record record = {}, QObject* parent = nullptr);

  void begin(const LessonState& state, const std::vector<Condition>& conditions);
  void measure(const LessonState& state, const std::vector<Condition>& conditions);
  void record(const LessonState& state);

 Q_SIGNALS:
  void checked(const std::vector<CheckedCondition>& conditions);
  void measured(const std::vector<LessonNumber>& numbers);
  void recorded(const LessonState& state);

 private:
  Check check_;
  Record record_;
};

} // namespace taa::app
