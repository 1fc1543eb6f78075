// A picture of the whole window, taken when everything in it has arrived.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <string>

namespace taa::app {

class MainWindow;

/// Waits for frame, views and probe, writes the picture, and calls `done` with an exit code and what to say.
class Screenshot : public QObject {
  Q_OBJECT
 public:
  using Done = std::function<void(int code, const QString& text)>;
  /// `frame` is clamped to the shot.
  Screenshot(MainWindow& window, const QString& file, int frame, Done done);
  /// Opens this one of dialogNames() first; empty: none.
  void setDialog(const std::string& name) { dialog_ = name; }

 private:
  /// Asks for the frame once the source is open, and takes the picture once all is there.
  void look();
  bool isComplete() const;
  bool areProfilesComplete();
  bool areTracesComplete();
  void take();
  void finish(int code, const QString& text);

  MainWindow& window_;
  QString file_;
  int frame_;
  Done done_;
  bool asked_ = false, measures_ = false;
  bool asksForTraces_ = false, sawTracing_ = false;
  int quiet_ = 0;      ///< polls since all was there
  std::string dialog_; ///< that is still to be opened
  QTimer poll_, limit_;
  QString lastError_;
};

} // namespace taa::app
