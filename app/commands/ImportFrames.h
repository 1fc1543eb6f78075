// Frames of another engine: a folder without capture.json goes through the import page.
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace taa::app {

class SessionKeeper;

class ImportFrames : public QObject {
  Q_OBJECT
 public:
  /// What is imported opens in `keeper`; the page opens over `window`.
  ImportFrames(SessionKeeper& keeper, QWidget* window);

  /// Whether it is a folder that says nothing about its frames: it has no capture.json.
  static bool isWanted(const QString& path);
  void askForFolder();
  /// The page; of an empty `folder` one on which a folder is still to be chosen.
  void open(const QString& folder);

 private:
  SessionKeeper& keeper_;
  QWidget* window_;
};

} // namespace taa::app
