// The flown camera that is looked through: its name, and the file it is saved to or read from.
#pragma once

#include "core/scene/camera/CameraTrack.h"

#include <QObject>
#include <QString>

class QWidget;

namespace taa::app {

class Session;

class CameraFiles : public QObject {
  Q_OBJECT
 public:
  /// Dialogs open over `window`.
  CameraFiles(Session& session, QWidget* window);

  /// Null: one of the scene's cameras is looked through.
  CameraTrackHandle flown() const;
  void askWhereToSave();
  void askForFile();
  void askForName();
  void remove();

 Q_SIGNALS:
  void failed(const QString& sentence);

 private:
  Session& session_;
  QWidget* window_;
};

} // namespace taa::app
