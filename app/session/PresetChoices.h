// The settings that are chosen, the preset they come from, and the presets they are compared with.
#pragma once

#include "app/session/Pending.h"
#include "core/settings/Settings.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <string>
#include <vector>

namespace taa::app {

class Outbox;
class UndoStack;

/// The settings in force and the preset they come from, which is gone back to.
struct PresetChoice {
  Settings settings, presetSettings;
  std::string presetId;
  bool operator==(const PresetChoice&) const = default;
};

/// Begins with the first built-in preset.
class PresetChoices : public QObject {
  Q_OBJECT
 public:
  PresetChoices(Outbox& outbox, UndoStack& undo);

  /// What was chosen, which the picture may not show yet.
  const Settings& settings() const { return chosen_.settings; }
  const std::string& presetId() const { return chosen_.presetId; }
  const Settings& presetSettings() const { return chosen_.presetSettings; }
  bool isPresetChanged() const;
  void setParameter(const QString& path, double value);
  /// Several at once, "path=value" each.
  void assign(const std::vector<std::string>& assignments);
  void setPreset(const QString& idOrPath);
  /// Somebody looks at this choice and may take it: when they stay, what it needs is compiled ahead.
  void prepareParameter(const QString& path, double value);
  void preparePreset(const QString& idOrPath);
  void backToPreset();
  /// What is in force, with the preset it is held to have come from.
  const PresetChoice& choice() const { return chosen_; }
  /// Takes all of it up as one step of undo, which `what` names; steps with the same `key`, unless it is
  /// empty, are one.
  void change(const PresetChoice& choice, const QString& what, const std::string& key = {});
  /// Saves the present settings in `folder` and goes on from them.
  void savePreset(const QString& folder, const QString& label);
  /// The same of others, which are not taken up.
  void savePreset(const QString& folder, const QString& label, const Settings& settings);
  /// Presets that views are compared with: lanes 1, 2 … next to that of the settings.
  void setOtherPresets(const QStringList& idsOrPaths);
  const std::vector<Settings>& otherLanes() const { return otherLanes_; } ///< their settings

  // For the session
  /// Another source is opened: as it is shown best, where nothing else was chosen. Is no step of undo.
  void showScene(const std::string& source);
  /// Is no step of undo.
  void use(const PresetChoice& choice);
  /// The settings of the frame on show, and the latest request of settings that was taken up before. Settings
  /// that were refused give way to them.
  void arrived(const Settings& inForce, RequestId takenUp);
  void refused(RequestId request) { settings_.refused(request); }

 Q_SIGNALS:
  void settingsChanged();
  void said(const QString& sentence); ///< of a preset that was read

 private:
  void consider(const Settings& settings);
  void sayNotes(const std::vector<std::string>& notes);

  Outbox& outbox_;
  UndoStack& undo_;
  PresetChoice chosen_, chosenInForce_; ///< what was chosen; what has arrived of it
  std::string scene_;                   ///< the source that they are for
  Pending<Settings> settings_;
  Settings considered_;
  QTimer stays_; ///< runs out when somebody has looked at `considered_` for long enough
  QStringList otherPresets_;
  std::vector<Settings> otherLanes_;
};

} // namespace taa::app
