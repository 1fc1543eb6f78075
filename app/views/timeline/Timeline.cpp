#include "app/views/timeline/Timeline.h"

#include "app/models/ChartMath.h"
#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {
constexpr double kRulerMargin = 14;      ///< room for half a label at either end
constexpr int kRulerLine = 21;           ///< y of the line the ticks stand on
constexpr int kKeptTop = kRulerLine + 3; ///< bars of the frames that are kept
constexpr int kKeptHeight = 3;
constexpr int kHeadTop = kKeptTop + kKeptHeight + 1;
constexpr int kHeadHeight = 10;
constexpr int kTimelineHeight = kHeadTop + kHeadHeight + 2;
constexpr int kStripTop = kTimelineHeight + 1, kStripHeight = 22;
constexpr double kHandleWidth = 7;
constexpr double kRulerTickSpace = 5;                    ///< least distance of ticks
constexpr double kLabelSpace = 56;                       ///< and of labels
constexpr double kMinShown = 4.0, kRulerZoomStep = 1.25; ///< frames; for each notch of the wheel
} // namespace

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMinimumWidth(120);
  setFixedHeight(sizeHint().height());
  setCursor(Qt::PointingHandCursor);
  setAccessibleName(tr("Timeline"));
}

QSize Timeline::sizeHint() const {
  return {300, strip_.name.isEmpty() ? scaled(kTimelineHeight) : scaled(kStripTop) + scaled(kStripHeight)};
}

void Timeline::setFrameCount(int count) {
  if (count == frameCount_) return;
  frameCount_ = std::max(1, count);
  shown_.reset();
  update();
}

void Timeline::setShown(const Span& frames) {
  const Span all{0.0, frameCount_ - 1.0};
  const std::optional<Span> shown = frames == all ? std::nullopt : std::optional<Span>(frames);
  if (shown == shown_) return;
  shown_ = shown;
  update();
  Q_EMIT shownChanged(scale().frames());
}

void Timeline::zoom(double notches, double x) {
  const Span all{0.0, frameCount_ - 1.0}, now = scale().frames();
  const double center = now.low + (x - scale().left) / scale().spacing();
  setShown(zoomed(now, all, std::pow(kRulerZoomStep, notches), center, kMinShown));
}

void Timeline::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  Q_EMIT moved();
}

void Timeline::moveEvent(QMoveEvent* event) {
  QWidget::moveEvent(event);
  Q_EMIT moved();
}

void Timeline::setFrame(int frame) {
  if (frame == frame_) return;
  frame_ = frame;
  update();
}

void Timeline::setCuts(const std::vector<int>& cuts) {
  cuts_ = cuts;
  update();
}

void Timeline::setRestarts(const std::vector<int>& frames) {
  if (frames == restarts_) return;
  restarts_ = frames;
  update();
}

void Timeline::setKept(const std::vector<int>& frames) {
  if (frames == kept_) return;
  kept_ = frames;
  update();
}

void Timeline::setMarks(const std::map<int, QString>& marks) {
  marks_ = marks;
  update();
}

void Timeline::setRange(std::optional<std::pair<int, int>> range) {
  range_ = range;
  update();
}

std::pair<int, int> Timeline::range() const {
  if (!range_) return {0, frameCount_ - 1};
  const int first = std::clamp(range_->first, 0, frameCount_ - 1);
  return {first, std::clamp(range_->second, first, frameCount_ - 1)};
}

void Timeline::setStrip(const TimelineStrip& strip) {
  if (strip == strip_) return;
  strip_ = strip;
  setFixedHeight(sizeHint().height());
  update();
}

TimelineScale Timeline::scale() const {
  return {frameCount_, scaled(kRulerMargin), width() - 2 * scaled(kRulerMargin), shown_};
}

QRectF Timeline::handle(bool isLast) const {
  const auto [first, last] = range();
  const double x = scale().position(isLast ? last : first);
  return {isLast ? x + 1 : x - scaled(kHandleWidth), scaled(kRulerLine) - 5.0, scaled(kHandleWidth), 14};
}

QString Timeline::textAt(int frame) const {
  QStringList parts{tr("frame %1").arg(frame)};
  if (const auto mark = marks_.find(frame); mark != marks_.end())
    parts << (mark->second.isEmpty() ? tr("mark") : tr("mark “%1”").arg(mark->second));
  if (std::ranges::find(cuts_, frame) != cuts_.end()) parts << tr("cut: history starts anew");
  if (std::ranges::find(restarts_, frame) != restarts_.end()) parts << tr("history is restarted");
  if (std::ranges::binary_search(kept_, frame)) parts << tr("kept");
  if (!strip_.name.isEmpty()) {
    const auto index = static_cast<std::size_t>(frame);
    const bool isKnown = index < strip_.values.size() && strip_.values[index];
    parts << (isKnown ? strip_.name + QLatin1Char(' ') + shortText(*strip_.values[index], 4) + strip_.unit
                      : tr("%1 not known yet").arg(strip_.name));
  }
  return parts.join(QStringLiteral(" · "));
}

void Timeline::paintTicks(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const TimelineScale ruler = scale();
  painter.fillRect(QRectF(ruler.left, scaled(kRulerLine), ruler.width, 1), colors.secondary);
  for (const int frame : ruler.ticks(ruler.tickStep(kRulerTickSpace)))
    painter.fillRect(QRectF(ruler.position(frame), scaled(kRulerLine) - 3, 1, 3), colors.line);
  painter.setFont(secondaryFont());
  for (const int frame : ruler.ticks(ruler.tickStep(scaled(kLabelSpace)))) {
    const double x = ruler.position(frame);
    painter.fillRect(QRectF(x, scaled(kRulerLine) - 6, 1, 6), colors.secondary);
    painter.setPen(colors.secondary);
    painter.drawText(QRectF(x - 28, 0, 56, scaled(kRulerLine) - 7), Qt::AlignHCenter | Qt::AlignBottom,
                     QString::number(frame));
  }
}

void Timeline::paintKept(QPainter& painter) const {
  const TimelineScale ruler = scale();
  const double half = std::max(0.5, 0.5 * ruler.spacing());
  for (const auto& [first, last] : runsOfFrames(kept_))
    painter.fillRect(QRectF(QPointF(ruler.position(first) - half, scaled(kKeptTop)),
                            QPointF(ruler.position(last) + half, scaled(kKeptTop) + kKeptHeight)),
                     themeColors(this).secondary);
}

void Timeline::paintRange(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const auto [first, last] = range();
  const QColor color = range_ ? colors.accent : colors.secondary;
  if (range_)
    painter.fillRect(QRectF(QPointF(scale().position(first), scaled(kRulerLine) - 1),
                            QPointF(scale().position(last) + 1, scaled(kRulerLine) + 2)),
                     color);
  // Brackets that open towards what is repeated.
  for (const bool isLast : {false, true}) {
    const QRectF box = handle(isLast);
    const double stem = isLast ? box.left() : box.right() - 2;
    painter.fillRect(QRectF(stem, box.top(), 2, box.height()), color);
    const double foot = isLast ? box.left() - 3 : box.right() - 2;
    for (const double y : {box.top(), box.bottom() - 2}) painter.fillRect(QRectF(foot, y, 5, 2), color);
  }
}

void Timeline::paintMarks(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  painter.setPen(QPen(colors.text, 1, Qt::DashLine));
  for (const int cut : cuts_) {
    const double x = scale().position(cut) + 0.5;
    painter.drawLine(QPointF(x, 2), QPointF(x, height() - 2));
  }
  painter.setPen(QPen(colors.caution, 1, Qt::DashLine));
  for (const int frame : restarts_) {
    const double x = scale().position(frame) + 0.5;
    painter.drawLine(QPointF(x, 2), QPointF(x, height() - 2));
  }
  painter.setFont(secondaryFont());
  const QFontMetrics metrics(painter.font());
  for (const auto& [frame, name] : marks_) {
    const double x = scale().position(frame) + 0.5;
    const QPointF diamond[] = {{x, scaled(kRulerLine) - 12.0},
                               {x + 5, scaled(kRulerLine) - 7.0},
                               {x, scaled(kRulerLine) - 2.0},
                               {x - 5, scaled(kRulerLine) - 7.0}};
    if (!name.isEmpty()) {
      const int wide = metrics.horizontalAdvance(name);
      const double left = std::min(x + 8, width() - wide - 2.0);
      painter.fillRect(QRectF(left - 2, 0, wide + 4, scaled(kRulerLine) - 3), colors.window);
      painter.setPen(colors.text);
      painter.drawText(QPointF(left, scaled(kRulerLine) - 8), name);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(colors.text);
    painter.setBrush(colors.caution);
    painter.drawPolygon(diamond, 4);
    painter.setRenderHint(QPainter::Antialiasing, false);
  }
}

// Columns, as wide as a frame; nothing where the metric is not known.
void Timeline::paintStrip(QPainter& painter) const {
  if (strip_.name.isEmpty()) return;
  const ThemeColors& colors = themeColors(this);
  const TimelineScale ruler = scale();
  const double bottom = scaled(kStripTop) + scaled(kStripHeight) - 1;
  double most = 0.0;
  for (const std::optional<double>& value : strip_.values)
    if (value) most = std::max(most, *value);
  most = roundedSpan({0.0, most}, 4).high;
  painter.fillRect(QRectF(ruler.left, bottom, ruler.width, 1), colors.line);
  const double wide = std::max(1.0, ruler.spacing());
  for (std::size_t frame = 0; frame < strip_.values.size(); ++frame) {
    if (!strip_.values[frame]) continue;
    const double tall = std::clamp(*strip_.values[frame] / most, 0.0, 1.0) * (scaled(kStripHeight) - 2);
    const double x = ruler.position(static_cast<int>(frame)) - 0.5 * wide;
    painter.fillRect(QRectF(x, bottom - std::max(1.0, tall), wide, std::max(1.0, tall)), colors.secondary);
  }
  painter.setFont(secondaryFont());
  painter.setPen(colors.secondary);
  const QString scaleText = tr("%1, 0 to %2").arg(strip_.name, shortText(most, 3) + strip_.unit);
  painter.drawText(QRectF(ruler.left, scaled(kHeadTop) - 1, ruler.width, scaled(kHeadHeight) + 3),
                   Qt::AlignRight | Qt::AlignVCenter, scaleText);
}

void Timeline::paintHead(QPainter& painter, int frame) const {
  const ThemeColors& colors = themeColors(this);
  const double x = scale().position(frame) + 0.5, top = scaled(kHeadTop);
  const QPointF head[] = {{x - 5, top + scaled(kHeadHeight)},
                          {x + 5, top + scaled(kHeadHeight)},
                          {x + 5, top + 4},
                          {x, top},
                          {x - 5, top + 4}};
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.accent);
  painter.drawPolygon(head, 5);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(QRectF(x - 1, scaled(kRulerLine) - 8, 2, top - scaled(kRulerLine) + 9), colors.accent);
  if (!strip_.name.isEmpty())
    painter.fillRect(QRectF(x - 1, scaled(kStripTop), 2, scaled(kStripHeight)), colors.accent);
}

void Timeline::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  paintTicks(painter);
  paintKept(painter);
  paintRange(painter);
  paintStrip(painter);
  paintMarks(painter);
  if (hovered_ >= 0 && dragged_ < 0 && !handle_)
    painter.fillRect(
        QRectF(scale().position(hovered_), scaled(kRulerLine) - 8, 1, height() - scaled(kRulerLine) + 8),
        colors.text);
  paintHead(painter, dragged_ >= 0 ? dragged_ : frame_);
}

void Timeline::seekTo(double x) {
  const int frame = scale().frameAt(x);
  if (frame == dragged_) return;
  dragged_ = frame;
  update();
  Q_EMIT seekRequested(frame);
}

void Timeline::dragRange(double x) {
  const auto [first, last] = withEnd(range(), *handle_, scale().frameAt(x));
  if (std::pair(first, last) == range()) return;
  range_ = {first, last};
  update();
  Q_EMIT rangeEdited(first, last);
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  handle_.reset();
  pressFrame_ = frame_;
  for (const bool isLast : {false, true})
    if (handle(isLast).contains(event->position())) handle_ = isLast;
  if (!handle_) seekTo(event->position().x());
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = event->position();
  const bool isDragged = event->buttons().testFlag(Qt::LeftButton);
  if (isDragged) handle_ ? dragRange(position.x()) : seekTo(position.x());
  const bool isOverHandle = handle_ || handle(false).contains(position) || handle(true).contains(position);
  setCursor(isOverHandle ? Qt::SizeHorCursor : Qt::PointingHandCursor);
  hovered_ = scale().frameAt(position.x());
  update();
}

// The repeated part is the undo stack's.
void Timeline::cancelDrag() {
  if (dragged_ >= 0) Q_EMIT seekRequested(pressFrame_);
  dragged_ = -1;
  handle_.reset();
  update();
}

void Timeline::mouseReleaseEvent(QMouseEvent*) {
  if (dragged_ >= 0) frame_ = dragged_; // until the picture's own frame number arrives
  dragged_ = -1;
  handle_.reset();
  update();
}

void Timeline::leaveEvent(QEvent*) {
  hovered_ = -1;
  update();
}

void Timeline::wheelEvent(QWheelEvent* event) {
  if (event->modifiers().testFlag(Qt::ControlModifier)) {
    zoom(event->angleDelta().y() / 120.0, event->position().x());
    return;
  }
  const int steps = event->angleDelta().y() / 120;
  if (steps != 0) Q_EMIT stepRequested(-steps);
}

bool Timeline::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QStringList lines{textAt(scale().frameAt(help->pos().x()))};
  lines << tr("Click or drag to go to a frame; the wheel steps, with Ctrl it zooms. Drag the "
              "brackets to repeat a part.");
  QToolTip::showText(help->globalPos(), lines.join(QLatin1Char('\n')), this);
  return true;
}

} // namespace taa::app
