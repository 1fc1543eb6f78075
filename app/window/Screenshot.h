// A picture of the whole window, taken when everything in it has arrived.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>

namespace taa::app {

class DoctorPanel;
class JitterPanel;
class LineagePanel;
class PipelinePanel;
class PlotsPanel;
class ProfilerPanel;
class Session;
class ViewArea;
class WeightsPanel;

/// The window and what of it a picture waits for.
struct ScreenshotPanels {
  QWidget& window;
  Session& session;
  ViewArea& views;
  PipelinePanel& pipeline;
  ProfilerPanel& profiler;
  PlotsPanel& plots;
  JitterPanel& jitter;
  WeightsPanel& weights;
  LineagePanel& lineage;
  DoctorPanel& doctor;
  std::function<void()> openDialog; ///< before the picture; null: none
  std::function<void()> writes;     ///< in place of a picture of the window; throws Error; null: that
};

/// Waits for frame, views and probe, writes the picture, and calls `done` with an exit code and what to say:
/// after an error that nothing follows on, as where a shader does not compile, that error.
class Screenshot : public QObject {
  Q_OBJECT
 public:
  using Done = std::function<void(int code, const QString& text)>;
  /// `frame` is clamped to the shot.
  Screenshot(ScreenshotPanels of, const QString& file, int frame, Done done);

 private:
  /// Asks for the frame once the source is open, and takes the picture once all is there.
  void look();
  bool isComplete() const;
  bool areProfilesComplete();
  bool areTracesComplete();
  bool isLineageComplete() const;
  bool isDoctorComplete();
  bool isGivenUp();
  void take();
  void takeFigure();
  void finish(int code, const QString& text);

  ScreenshotPanels of_;
  QString file_;
  int frame_;
  Done done_;
  bool asked_ = false, measures_ = false, examines_ = false;
  bool asksForTraces_ = false, sawTracing_ = false;
  int quiet_ = 0; ///< polls since all was there
  int code_ = 1;  ///< of an end without a picture
  int idle_ = 0;  ///< polls since something came or was done, after an error
  QTimer poll_, limit_;
  QString lastError_;
};

} // namespace taa::app
