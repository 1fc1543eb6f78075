// Transport buttons, the ruler of the shot, and where in time and in the jitter pattern the frame lies.
#pragma once

#include "core/RenderThread.h"

#include <QWidget>

class QLabel;

namespace taa::app {

class IconButton;
class NumberField;
class Timeline;

class TimelinePanel : public QWidget {
  Q_OBJECT
 public:
  explicit TimelinePanel(QWidget* parent = nullptr);

  void setStatus(const Status& status);
  void setLooping(bool looping);
  Timeline* timeline() const { return timeline_; }
  QString readout() const; ///< what the labels say, for tests and screen readers

 Q_SIGNALS:
  void seekRequested(int frame);
  void stepRequested(int frames);
  void playToggled();
  void loopToggled(bool looping);

 private:
  void makeButtons();
  void makeReadouts();
  QLabel* makeReadout(const QString& widest);

  IconButton* play_ = nullptr;
  IconButton* loop_ = nullptr;
  Timeline* timeline_ = nullptr;
  NumberField* frame_ = nullptr;
  QLabel *count_ = nullptr, *jitter_ = nullptr, *time_ = nullptr;
  int frameCount_ = 0;
};

} // namespace taa::app
