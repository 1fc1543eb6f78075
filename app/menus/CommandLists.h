// All commands in a list: to search and choose from, and with their keys to read.
#pragma once

#include <QObject>

class QWidget;

namespace taa::app {

class Commands;
class PresetChoices;

class CommandLists : public QObject {
  Q_OBJECT
 public:
  /// They open over `window`.
  CommandLists(const Commands& commands, PresetChoices& presets, QWidget* window);

  /// Commands, and behind them the choices of the settings.
  void choose();
  void showKeys();

 private:
  const Commands& commands_;
  PresetChoices& presets_;
  QWidget* window_;
};

} // namespace taa::app
