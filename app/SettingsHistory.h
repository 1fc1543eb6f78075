// Undo and redo of settings, flown cameras and restarts: states in the order they were made, one for each
// drag.
#pragma once

#include "core/scene/CameraTrack.h"
#include "core/settings/Settings.h"

#include <optional>
#include <string>
#include <vector>

namespace taa::app {

/// A flown camera that was renamed, or removed: then there is none after it.
struct CameraChange {
  std::optional<CameraTrack> before, after;
};

/// Frames at which history is restarted, before somebody changed them and after.
struct RestartChange {
  std::vector<int> before, after;
};

/// What a step goes back or on to.
struct UndoStep {
  Settings settings;
  std::optional<CameraChange> camera{};    ///< what it takes back or does again; nothing: it was of settings
  std::optional<RestartChange> restarts{}; ///< likewise
};

class SettingsHistory {
 public:
  /// Notes that `before` is about to change; changes of the same `what` in a row are one step, unless it is
  /// empty.
  void record(const UndoStep& before, const std::string& what);
  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }
  /// The state before `now`; expects canUndo().
  UndoStep undo(const Settings& now) { return step(undo_, redo_, now); }
  /// The state after `now`; expects canRedo().
  UndoStep redo(const Settings& now) { return step(redo_, undo_, now); }
  /// Steps of flown cameras and of restarts are of a scene that is not open any more.
  void forgetShot();

 private:
  UndoStep step(std::vector<UndoStep>& from, std::vector<UndoStep>& to, const Settings& now);

  std::vector<UndoStep> undo_, redo_;
  std::string last_;
};

} // namespace taa::app
