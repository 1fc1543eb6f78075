#include "app/views/plots/ScatterChart.h"

#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::app {

namespace {

constexpr double kPointRadius = 4.0, kChosenRadius = 7.0, kReach = 9.0; ///< px
constexpr double kScatterTickSpace = 56.0, kTickRows = 28.0;            ///< px between ticks at least

/// Of all points along one axis; one alone gets some room.
Span spanOf(const std::vector<ScatterPoint>& points, double (QPointF::*along)() const) {
  Span span{0.0, 0.0};
  bool isFirst = true;
  for (const ScatterPoint& point : points) {
    const double value = (point.value.*along)();
    span = isFirst ? Span{value, value} : Span{std::min(span.low, value), std::max(span.high, value)};
    isFirst = false;
  }
  return isFirst ? Span{} : span;
}

} // namespace

ScatterChart::ScatterChart(QWidget* parent) : QWidget(parent) {
  setMinimumSize(240, 160);
  setMouseTracking(true);
  setFocusPolicy(Qt::NoFocus);
  setAccessibleName(tr("Trade-off of two metrics"));
  fitAxes();
}

void ScatterChart::setPoints(std::vector<ScatterPoint> points) {
  points_ = std::move(points);
  fitAxes();
}

void ScatterChart::setTitles(const QString& x, const QString& y) {
  xTitle_ = x;
  yTitle_ = y;
  fitAxes();
}

void ScatterChart::setChosen(std::optional<std::size_t> index) {
  chosen_ = index;
  update();
}

void ScatterChart::fitAxes() {
  const auto axisOf = [](const Span& values, int steps, const QString& title) {
    const Span span = roundedSpan(values, steps);
    return ChartAxis{span, roundStep(span.length(), steps), title};
  };
  axes_.layOut(
      axisOf(spanOf(points_, &QPointF::x), std::max(2, static_cast<int>(width() / kScatterTickSpace)),
             xTitle_),
      axisOf(spanOf(points_, &QPointF::y), std::max(2, static_cast<int>(height() / kTickRows)), yTitle_),
      QRectF(rect()).adjusted(kUnit, 2.0 * kUnit, -3.0 * kUnit, -kUnit));
  update();
}

const ScatterPoint* ScatterChart::pointAt(QPointF place) const {
  const ScatterPoint* nearest = nullptr;
  double least = kReach;
  for (const ScatterPoint& point : points_) {
    const QPointF way = placeOf(point) - place;
    if (const double distance = std::hypot(way.x(), way.y()); distance <= least) {
      least = distance;
      nearest = &point;
    }
  }
  return nearest;
}

QString ScatterChart::textOf(const ScatterPoint& point) const {
  return tr("%1: %2 %3, %4 %5")
      .arg(point.name, xTitle_, shortText(point.value.x(), 4), yTitle_, shortText(point.value.y(), 4));
}

// In the order of the first number.
void ScatterChart::paintFront(QPainter& painter) const {
  std::vector<QPointF> places;
  for (const ScatterPoint& point : points_)
    if (point.isOnFront) places.push_back(placeOf(point));
  std::ranges::sort(places, {}, [](const QPointF& place) { return std::pair(place.x(), place.y()); });
  painter.setPen(QPen(themeColors(this).secondary, 1.0, Qt::DashLine));
  for (std::size_t next = 1; next < places.size(); ++next) painter.drawLine(places[next - 1], places[next]);
}

void ScatterChart::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  painter.setRenderHint(QPainter::Antialiasing);
  axes_.paint(painter, colors);
  paintFront(painter);
  for (const ScatterPoint& point : points_) {
    painter.setPen(QPen(point.color, 1.5));
    painter.setBrush(point.isOnFront ? QBrush(point.color) : QBrush(Qt::NoBrush));
    painter.drawEllipse(placeOf(point), kPointRadius, kPointRadius);
    if (point.index != chosen_) continue;
    painter.setPen(QPen(colors.accent, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(placeOf(point), kChosenRadius, kChosenRadius);
  }
}

void ScatterChart::mousePressEvent(QMouseEvent* event) {
  if (const ScatterPoint* point = pointAt(event->position())) Q_EMIT pointClicked(point->index);
}

void ScatterChart::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitAxes();
}

bool ScatterChart::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const ScatterPoint* point = pointAt(help->pos());
  QToolTip::showText(help->globalPos(), point ? textOf(*point) : QString(), this);
  return true;
}

} // namespace taa::app
