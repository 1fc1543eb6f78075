// The ruler of the shot: the playhead is clicked or dragged to a frame.
#pragma once

#include "app/views/TimelineMath.h"

#include <QWidget>

namespace taa::app {

class Timeline : public QWidget {
  Q_OBJECT
 public:
  explicit Timeline(QWidget* parent = nullptr);

  void setFrameCount(int count);
  void setFrame(int frame);
  int frame() const { return frame_; }
  TimelineScale scale() const;
  QSize sizeHint() const override { return {300, 36}; }

 Q_SIGNALS:
  void seekRequested(int frame);
  void stepRequested(int frames);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void wheelEvent(QWheelEvent*) override;

 private:
  void seekTo(double x);
  void paintTicks(QPainter& painter) const;
  void paintHead(QPainter& painter, int frame) const;

  int frameCount_ = 1, frame_ = 0;
  int dragged_ = -1; ///< frame under a drag: shown before the picture has followed
  int hovered_ = -1;
};

} // namespace taa::app
