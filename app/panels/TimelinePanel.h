// Transport buttons, the ruler of the shot with the user's marks, how time goes on, and where in time and in
// the jitter pattern the frame lies.
#pragma once

#include "app/models/FrameMarks.h"
#include "core/requests/Results.h"

#include <QElapsedTimer>
#include <QJsonObject>
#include <QWidget>

#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

class QBoxLayout;
class QLabel;

namespace taa::app {

class ChoiceButton;
class IconButton;
class NumberField;
class Timeline;
struct TimelineStrip;

/// How many frames a second come on show while a shot plays.
class PlaybackRate {
 public:
  /// A status says that this frame is on show. `seconds`: by any clock that only goes forward.
  void note(int frame, double seconds);
  void stop() { shown_.clear(); }
  /// Frames a second over the last second, or between the last two where they came slower; nothing before the
  /// second one.
  std::optional<double> value() const;

 private:
  std::deque<std::pair<int, double>> shown_; // frame and time
};

class TimelinePanel : public QWidget {
  Q_OBJECT
 public:
  explicit TimelinePanel(QWidget* parent = nullptr);

  void setStatus(const Status& status);
  void setLooping(bool looping);
  void setStrip(const TimelineStrip& strip);
  /// The metric of each frame that stands under the ruler; nothing: none.
  void setStripMetric(std::optional<Metric> metric);
  std::optional<Metric> stripMetric() const { return stripMetric_; }
  Timeline* timeline() const { return timeline_; }
  QString readout() const; ///< what the labels say, for tests and screen readers

  // How time goes on
  const Playback& playback() const { return playback_; }
  void setSpeed(double speed);
  void changeSpeed(int steps);          ///< to the next of the list
  void setFramesPerSecond(double rate); ///< 0: the shot's own
  void setRangeEnd(bool isLast);        ///< at the frame on show
  void clearRange();
  /// Speeds and rates to choose from; rate 0 is the shot's own.
  static const std::vector<double>& speeds();
  static const std::vector<double>& rates();

  // The user's marks
  const FrameMarks& marks() const;
  void toggleMark();
  void nameMark(const QString& name); ///< of the frame on show
  void goToMark(bool after);          ///< cut or restart
  int frame() const;

  /// Speed, rate, whether it loops, the metric, marks and range of each shot.
  QJsonObject state() const;
  void setState(const QJsonObject& state);

 Q_SIGNALS:
  void seekRequested(int frame);
  void stepRequested(int frames);
  void playToggled();
  void loopToggled(bool looping);
  void playbackEdited(const Playback& playback);
  void marksChanged();
  void metricChosen(std::optional<Metric> metric);

 private:
  void makeButtons();
  void offerMetrics(const QPoint& place);
  void makeChoices(QBoxLayout* line);
  void makeFrameField(QBoxLayout* line);
  QLabel* makeReadout(const QString& widest, QBoxLayout* line);
  ShotNotes& notes();
  void setPlayback(const Playback& playback);
  void setRange(std::optional<FrameSpan> range);
  void showNotes();
  void showRates();
  QString timeText(const Status& status);

  IconButton* play_ = nullptr;
  IconButton* loop_ = nullptr;
  Timeline* timeline_ = nullptr;
  ChoiceButton *speed_ = nullptr, *rate_ = nullptr;
  NumberField* frame_ = nullptr;
  QLabel *count_ = nullptr, *jitter_ = nullptr, *time_ = nullptr;
  int frameCount_ = 0;
  double shotRate_ = 0.0; ///< frames per second
  PlaybackRate shownRate_;
  QElapsedTimer clock_;
  std::vector<int> cuts_, restarts_;
  Playback playback_;
  std::optional<Metric> stripMetric_;
  QString source_;
  std::map<QString, ShotNotes> notes_; ///< by source: they come back with it
};

} // namespace taa::app
