#include "app/SettingsHistory.h"

#include <cassert>

namespace taa::app {

void SettingsHistory::record(const Settings& before, const std::string& what) {
  redo_.clear();
  if (what == last_ && !undo_.empty()) return;
  last_ = what;
  undo_.push_back(before);
}

Settings SettingsHistory::undo(const Settings& now) {
  assert(canUndo());
  redo_.push_back(now);
  const Settings before = undo_.back();
  undo_.pop_back();
  last_.clear();
  return before;
}

Settings SettingsHistory::redo(const Settings& now) {
  assert(canRedo());
  undo_.push_back(now);
  const Settings after = redo_.back();
  redo_.pop_back();
  last_.clear();
  return after;
}

} // namespace taa::app
