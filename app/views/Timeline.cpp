#include "app/views/Timeline.h"

#include "app/Theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>

namespace taa::app {

namespace {
constexpr double kMargin = 14;     ///< room for half a label at either end
constexpr int kBaseline = 22;      ///< y of the line the ticks stand on
constexpr double kTickSpace = 5;   ///< least distance of ticks
constexpr double kLabelSpace = 56; ///< and of labels
} // namespace

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMinimumWidth(120);
  setFixedHeight(sizeHint().height());
  setCursor(Qt::PointingHandCursor);
  setToolTip(tr("Click or drag to go to a frame; the wheel steps."));
}

void Timeline::setFrameCount(int count) {
  frameCount_ = std::max(1, count);
  update();
}

void Timeline::setFrame(int frame) {
  if (frame == frame_) return;
  frame_ = frame;
  update();
}

TimelineScale Timeline::scale() const {
  return {frameCount_, kMargin, width() - 2 * kMargin};
}

void Timeline::paintTicks(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const TimelineScale ruler = scale();
  painter.fillRect(QRectF(ruler.left, kBaseline, ruler.width, 1), colors.secondary);
  for (const int frame : ruler.ticks(ruler.tickStep(kTickSpace)))
    painter.fillRect(QRectF(ruler.position(frame), kBaseline - 3, 1, 3), colors.line);
  painter.setFont(secondaryFont());
  for (const int frame : ruler.ticks(ruler.tickStep(kLabelSpace))) {
    const double x = ruler.position(frame);
    painter.fillRect(QRectF(x, kBaseline - 6, 1, 6), colors.secondary);
    painter.setPen(colors.secondary);
    painter.drawText(QRectF(x - 28, 0, 56, kBaseline - 7), Qt::AlignHCenter | Qt::AlignBottom,
                     QString::number(frame));
  }
}

void Timeline::paintHead(QPainter& painter, int frame) const {
  const ThemeColors& colors = themeColors(this);
  const double x = scale().position(frame) + 0.5;
  const QPointF head[] = {{x - 5, kBaseline + 11.0},
                          {x + 5, kBaseline + 11.0},
                          {x + 5, kBaseline + 5.0},
                          {x, kBaseline + 1.0},
                          {x - 5, kBaseline + 5.0}};
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.accent);
  painter.drawPolygon(head, 5);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(QRectF(x - 1, kBaseline - 8, 2, 12), colors.accent);
}

void Timeline::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  paintTicks(painter);
  if (hovered_ >= 0 && dragged_ < 0)
    painter.fillRect(QRectF(scale().position(hovered_), kBaseline - 8, 1, 14), colors.text);
  paintHead(painter, dragged_ >= 0 ? dragged_ : frame_);
}

void Timeline::seekTo(double x) {
  const int frame = scale().frameAt(x);
  if (frame == dragged_) return;
  dragged_ = frame;
  update();
  Q_EMIT seekRequested(frame);
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) seekTo(event->position().x());
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) seekTo(event->position().x());
  hovered_ = scale().frameAt(event->position().x());
  update();
}

void Timeline::mouseReleaseEvent(QMouseEvent*) {
  if (dragged_ >= 0) frame_ = dragged_; // until the picture's own frame number arrives
  dragged_ = -1;
  update();
}

void Timeline::leaveEvent(QEvent*) {
  hovered_ = -1;
  update();
}

void Timeline::wheelEvent(QWheelEvent* event) {
  const int steps = event->angleDelta().y() / 120;
  if (steps != 0) Q_EMIT stepRequested(-steps);
}

} // namespace taa::app
