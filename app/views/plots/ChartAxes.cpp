#include "app/views/plots/ChartAxes.h"

#include "app/style/Theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {

constexpr double kAxisGap = kUnit; ///< px between plot and labels

/// In the middle of a pixel, where a thin line is sharp.
double sharp(double place) {
  return std::floor(place) + 0.5;
}

QString tickText(double tick) {
  return QString::asprintf("%g", tick);
}

} // namespace

void ChartAxes::layOut(const ChartAxis& x, const ChartAxis& y, const QRectF& area,
                       std::optional<Span> edges) {
  x_ = x;
  y_ = y;
  area_ = area;
  labels_.clear();
  const QFontMetricsF metrics(secondaryFont());
  const double line = metrics.height();
  if (edges) {
    plot_ = QRectF(edges->low, area.top() + 0.5 * line, edges->length(), std::max(area.height() - line, 1.0));
    return labelRows();
  }
  // Charts above each other have one left edge unless a label is wider than most.
  double widest = metrics.horizontalAdvance(QStringLiteral("0.0000"));
  for (const double tick : ticksOf(y.range, y.step))
    widest = std::max(widest, metrics.horizontalAdvance(tickText(tick)));
  plot_ = area.adjusted(widest + kAxisGap + (y.title.isEmpty() ? 0.0 : line), 0.5 * line, 0.0,
                        -line - kAxisGap - (x.title.isEmpty() ? 0.0 : line));
  labelRows();
  labelColumns();
}

void ChartAxes::labelRows() {
  const QFontMetricsF metrics(secondaryFont());
  const double line = metrics.height();
  for (const double tick : ticksOf(y_.range, y_.step)) {
    const double width = metrics.horizontalAdvance(tickText(tick));
    const double middle = pointOf({x_.range.low, tick}).y();
    labels_.push_back({tickText(tick), {plot_.left() - kAxisGap - width, middle - 0.5 * line, width, line}});
  }
}

void ChartAxes::labelColumns() {
  const QFontMetricsF metrics(secondaryFont());
  for (const double tick : ticksOf(x_.range, x_.step)) {
    const double width = metrics.horizontalAdvance(tickText(tick));
    // Neither beside the lowest label of the other axis nor over the edge.
    const double left =
        std::max(plot_.left() - kAxisGap,
                 std::min(pointOf({tick, y_.range.low}).x() - 0.5 * width, area_.right() - width));
    labels_.push_back({tickText(tick), {left, plot_.bottom() + kAxisGap, width, metrics.height()}});
  }
}

QPointF ChartAxes::pointOf(const QPointF& value) const {
  const auto share = [](double at, const Span& range) {
    return (at - range.low) / std::max(range.length(), 1e-30);
  };
  return {plot_.left() + share(value.x(), x_.range) * plot_.width(),
          plot_.bottom() - share(value.y(), y_.range) * plot_.height()};
}

void ChartAxes::paint(QPainter& painter, const ThemeColors& colors) const {
  painter.setPen(QPen(colors.line, 1.0));
  for (const double tick : ticksOf(x_.range, x_.step)) {
    const double x = sharp(pointOf({tick, 0.0}).x());
    painter.drawLine(QPointF(x, plot_.top()), QPointF(x, plot_.bottom()));
  }
  for (const double tick : ticksOf(y_.range, y_.step)) {
    const double y = sharp(pointOf({0.0, tick}).y());
    painter.drawLine(QPointF(plot_.left(), y), QPointF(plot_.right(), y));
  }
  painter.drawLine(QPointF(sharp(plot_.left()), plot_.top()), QPointF(sharp(plot_.left()), plot_.bottom()));
  painter.setPen(colors.secondary);
  painter.setFont(secondaryFont());
  for (const ChartLabel& label : labels_)
    painter.drawText(label.place, Qt::AlignCenter | Qt::TextDontClip, label.text);
  const double line = QFontMetricsF(secondaryFont()).height();
  painter.drawText(QRectF(plot_.left(), area_.bottom() - line, plot_.width(), line), Qt::AlignCenter,
                   x_.title);
  painter.save();
  painter.translate(area_.left(), plot_.bottom());
  painter.rotate(-90.0);
  painter.drawText(QRectF(0.0, 0.0, plot_.height(), line), Qt::AlignCenter, y_.title);
  painter.restore();
}

} // namespace taa::app
