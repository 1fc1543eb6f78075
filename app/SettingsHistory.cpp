#include "app/SettingsHistory.h"

#include <cassert>
#include <utility>

namespace taa::app {

void SettingsHistory::record(const UndoStep& before, const std::string& what) {
  redo_.clear();
  if (!what.empty() && what == last_ && !undo_.empty()) return;
  last_ = what;
  undo_.push_back(before);
}

UndoStep SettingsHistory::step(std::vector<UndoStep>& from, std::vector<UndoStep>& to, const Settings& now) {
  assert(!from.empty());
  UndoStep goal = std::move(from.back());
  from.pop_back();
  to.push_back({now, goal.camera, goal.restarts});
  last_.clear();
  return goal;
}

void SettingsHistory::forgetShot() {
  const auto isOfShot = [](const UndoStep& step) { return step.camera || step.restarts; };
  std::erase_if(undo_, isOfShot);
  std::erase_if(redo_, isOfShot);
  last_.clear();
}

} // namespace taa::app
