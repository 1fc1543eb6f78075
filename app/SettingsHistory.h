// Undo and redo of settings: states in the order they were made, one for each drag.
#pragma once

#include "core/settings/Settings.h"

#include <string>
#include <vector>

namespace taa::app {

class SettingsHistory {
 public:
  /// Notes that `before` is about to change; changes of the same `what` in a row are one step.
  void record(const Settings& before, const std::string& what);
  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }
  /// The state before `now`; expects canUndo().
  Settings undo(const Settings& now);
  /// The state after `now`; expects canRedo().
  Settings redo(const Settings& now);

 private:
  std::vector<Settings> undo_, redo_;
  std::string last_;
};

} // namespace taa::app
