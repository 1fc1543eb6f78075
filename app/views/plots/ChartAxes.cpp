#include "app/views/plots/ChartAxes.h"

#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace taa::app {

namespace {

constexpr double kAxisGap = kUnit;      ///< px between plot and labels
constexpr double kLabelGap = 2 * kUnit; ///< px between labels beside each other, at least
constexpr double kTightLines = 0.2;     ///< of a line, that those above each other may share

/// In the middle of a pixel, where a thin line is sharp.
double sharp(double place) {
  return std::floor(place) + 0.5;
}

QString tickText(double tick) {
  constexpr int kDigits = 6;
  return shortText(tick, kDigits);
}

/// Leaves out of labels in a line so many that the others stand apart by `gap`; the last one stays.
std::vector<ChartLabel> thinnedOut(const std::vector<ChartLabel>& labels, const QSizeF& gap) {
  const auto isApart = [&](std::size_t every) {
    for (std::size_t index = every; index < labels.size(); ++index) {
      const QRectF around =
          labels[index].place.adjusted(-gap.width(), -gap.height(), gap.width(), gap.height());
      if (around.intersects(labels[index - every].place)) return false;
    }
    return true;
  };
  std::size_t every = 1;
  while (every < labels.size() && !isApart(every)) ++every;
  std::vector<ChartLabel> kept;
  for (std::size_t index = 0; index < labels.size(); ++index)
    if ((labels.size() - 1 - index) % every == 0) kept.push_back(labels[index]);
  return kept;
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
    labelRows();
    return;
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
  std::vector<ChartLabel> labels;
  for (const double tick : ticksOf(y_.range, y_.step)) {
    const double width = metrics.horizontalAdvance(tickText(tick));
    const double middle = pointOf({x_.range.low, tick}).y();
    labels.push_back({tickText(tick), {plot_.left() - kAxisGap - width, middle - 0.5 * line, width, line}});
  }
  // Digits are lower than a line.
  for (ChartLabel& label : thinnedOut(labels, {0.0, -kTightLines * line}))
    labels_.push_back(std::move(label));
}

void ChartAxes::labelColumns() {
  const QFontMetricsF metrics(secondaryFont());
  std::vector<ChartLabel> labels;
  for (const double tick : ticksOf(x_.range, x_.step)) {
    const double width = metrics.horizontalAdvance(tickText(tick));
    // Neither beside the lowest label of the other axis nor over the edge.
    const double left =
        std::max(plot_.left() - kAxisGap,
                 std::min(pointOf({tick, y_.range.low}).x() - 0.5 * width, area_.right() - width));
    labels.push_back({tickText(tick), {left, plot_.bottom() + kAxisGap, width, metrics.height()}});
  }
  for (ChartLabel& label : thinnedOut(labels, {kLabelGap, 0.0})) labels_.push_back(std::move(label));
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
