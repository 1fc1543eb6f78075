// The ruler of the shot: playhead, cuts, restarts, marks, kept frames, the repeated part, and one metric of
// each frame.
#pragma once

#include "app/models/TimelineStrip.h"
#include "app/views/timeline/TimelineMath.h"
#include "app/widgets/Drags.h"

#include <QString>
#include <QWidget>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace taa::app {

class Timeline : public QWidget, public Draggable {
  Q_OBJECT
 public:
  explicit Timeline(QWidget* parent = nullptr);

  void setFrameCount(int count);
  void setFrame(int frame);
  /// Which frames the ruler shows; the whole shot where they are all of it.
  void setShown(const Span& frames);
  int frame() const { return frame_; }
  void setCuts(const std::vector<int>& cuts);
  void setRestarts(const std::vector<int>& frames);
  void setKept(const std::vector<int>& frames);
  const std::vector<int>& kept() const { return kept_; }
  void setMarks(const std::map<int, QString>& marks);
  /// What is repeated; nothing: the shot.
  void setRange(std::optional<std::pair<int, int>> range);
  std::pair<int, int> range() const;
  void setStrip(const TimelineStrip& strip);
  const TimelineStrip& strip() const { return strip_; }

  TimelineScale scale() const;
  /// Where a handle of the range is dragged.
  QRectF handle(bool isLast) const;
  /// What there is to say about a frame: "frame 41 · kept · cut · α 0.12".
  QString textAt(int frame) const;
  void cancelDrag() override;
  QSize sizeHint() const override;

 Q_SIGNALS:
  void seekRequested(int frame);
  void stepRequested(int frames);
  void rangeEdited(int first, int last);
  void shownChanged(const Span& frames);
  /// The ruler lies somewhere else or is as long as it was not before.
  void moved();

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void moveEvent(QMoveEvent*) override;
  bool event(QEvent*) override;

 private:
  void seekTo(double x);
  void dragRange(double x);
  void zoom(double notches, double x);
  void paintTicks(QPainter& painter) const;
  void paintKept(QPainter& painter) const;
  void paintRange(QPainter& painter) const;
  void paintMarks(QPainter& painter) const;
  void paintStrip(QPainter& painter) const;
  void paintHead(QPainter& painter, int frame) const;

  int frameCount_ = 1, frame_ = 0;
  std::vector<int> cuts_, restarts_, kept_;
  std::map<int, QString> marks_;
  std::optional<std::pair<int, int>> range_;
  std::optional<Span> shown_; ///< none: the whole shot
  TimelineStrip strip_;
  int dragged_ = -1;   ///< frame under a drag: shown before the picture has followed
  int pressFrame_ = 0; ///< on show when the drag began
  int hovered_ = -1;
  std::optional<bool> handle_; ///< the handle under a drag: whether it is the last
};

} // namespace taa::app
