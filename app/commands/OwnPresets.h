// A user's own presets: saved, opened, compared, and listed in the pipeline.
#pragma once

#include <QObject>
#include <QString>

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
  void askForFile();
  void compare();

 private:
  void list();

  Session& session_;
  PipelinePanel& pipeline_;
  QString folder_;
  QWidget* window_;
};

} // namespace taa::app
