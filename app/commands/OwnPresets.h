// A user's own presets: saved, opened, compared, and listed in the pipeline.
#pragma once

#include "core/settings/Settings.h"

#include <QObject>
#include <QString>

#include <functional>

class QSettings;
class QWidget;

namespace taa::app {

class PipelinePanel;
class Session;

class OwnPresets : public QObject {
  Q_OBJECT
 public:
  /// They lie beside `settings`, see userPresetFolder(). Dialogs open over `window`.
  OwnPresets(Session& session, PipelinePanel& pipeline, const QSettings* settings, QWidget* window);

  const QString& folder() const { return folder_; }
  /// Saves the present settings under a name.
  void askForName();
  /// The same of others, which are not taken up.
  void askForNameOf(const Settings& settings);
  void askForFile();
  void compare();

 private:
  void ask(const QString& question, const std::function<void(const QString& label)>& save);
  void list();

  Session& session_;
  PipelinePanel& pipeline_;
  QString folder_;
  QWidget* window_;
};

} // namespace taa::app
