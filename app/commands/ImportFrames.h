// Frames of another engine: a folder without capture.json goes through the import page.
#pragma once

#include <QObject>
#include <QString>

class QFileDialog;
class QWidget;

namespace taa::app {

class SessionKeeper;

class ImportFrames : public QObject {
  Q_OBJECT
 public:
  /// What is imported opens in `keeper`; the page opens over `window`.
  ImportFrames(SessionKeeper& keeper, QWidget* window);

  void askForFolder();
  /// For the folder of a captured sequence, which opens as openSource() says.
  void askForCapture();
  /// The page for a folder that says nothing about its frames, as it has no capture.json; all else at once.
  void openSource(const QString& path);
  /// The page; of an empty `folder` one on which a folder is still to be chosen.
  void open(const QString& folder);

 private:
  QFileDialog* ask(const QString& title);

  SessionKeeper& keeper_;
  QWidget* window_;
};

} // namespace taa::app
