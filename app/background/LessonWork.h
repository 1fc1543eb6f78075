// Checks what a lesson asks for beside the window.
#pragma once

#include "app/background/BackgroundWork.h"
#include "core/lessons/LessonCheck.h"

#include <functional>
#include <vector>

namespace taa::app {

class LessonWork : public BackgroundWork {
  Q_OBJECT
 public:
  /// Tests put another one in its place.
  using Check = std::function<std::vector<CheckedCondition>(const LessonState&, const std::vector<Condition>&,
                                                            const Progress&)>;
  explicit LessonWork(Check check = {}, QObject* parent = nullptr);

  void begin(const LessonState& state, const std::vector<Condition>& conditions);

 Q_SIGNALS:
  void checked(const std::vector<CheckedCondition>& conditions);

 private:
  Check check_;
};

} // namespace taa::app
