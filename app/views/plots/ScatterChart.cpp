#include "app/views/plots/ScatterChart.h"

#include "app/style/CurveColor.h"
#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QFontMetricsF>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <set>
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

/// A sign of each scene: disk, square, diamond, triangle, and again.
void drawSign(QPainter& painter, const QPointF& at, std::size_t scene) {
  constexpr double r = kPointRadius;
  switch (scene % 4) {
  case 0:
    painter.drawEllipse(at, r, r);
    return;
  case 1:
    painter.drawRect(QRectF(at - QPointF(r, r), QSizeF(2.0 * r, 2.0 * r)));
    return;
  case 2:
    painter.drawPolygon(QPolygonF{at + QPointF(0, -1.3 * r), at + QPointF(1.3 * r, 0),
                                  at + QPointF(0, 1.3 * r), at + QPointF(-1.3 * r, 0)});
    return;
  default:
    painter.drawPolygon(
        QPolygonF{at + QPointF(0, -1.2 * r), at + QPointF(1.2 * r, r), at + QPointF(-1.2 * r, r)});
  }
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
  axes_.layOut(axisOf(spanOf(points_, &QPointF::x),
                      std::max(2, static_cast<int>(width() / scaled(kScatterTickSpace))), xTitle_),
               axisOf(spanOf(points_, &QPointF::y),
                      std::max(2, static_cast<int>(height() / scaled(kTickRows))), yTitle_),
               QRectF(rect()).adjusted(kUnit, 2.0 * kUnit + legendHeight(), -3.0 * kUnit, -kUnit));
  update();
}

std::vector<ScatterPoint> ScatterChart::scenes() const {
  std::vector<ScatterPoint> firsts;
  for (const ScatterPoint& point : points_)
    if (!point.sceneName.isEmpty() && std::ranges::count(firsts, point.scene, &ScatterPoint::scene) == 0)
      firsts.push_back(point);
  return firsts.size() < 2 ? std::vector<ScatterPoint>() : firsts;
}

double ScatterChart::legendHeight() const {
  return scenes().empty() ? 0.0 : QFontMetricsF(secondaryFont()).height() + kUnit;
}

// Signs with their names in a row; what has no room is in the tool tips.
void ScatterChart::paintLegend(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const QFontMetricsF metrics(secondaryFont());
  painter.setFont(secondaryFont());
  painter.setPen(QPen(colors.text, 1.0));
  painter.setBrush(Qt::NoBrush);
  double x = 2.0 * kUnit;
  for (const ScatterPoint& each : scenes()) {
    const double end = x + 4.0 * kUnit + metrics.horizontalAdvance(each.sceneName);
    if (end > width()) return;
    drawSign(painter, {x + kPointRadius, kUnit + 0.5 * metrics.height()}, each.scene);
    painter.drawText(QPointF(x + 3.0 * kUnit, kUnit + metrics.ascent()), each.sceneName);
    x = end + 2.0 * kUnit;
  }
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
void ScatterChart::paintFront(QPainter& painter, std::size_t scene) const {
  std::vector<QPointF> places;
  for (const ScatterPoint& point : points_)
    if (point.isOnFront && point.scene == scene) places.push_back(placeOf(point));
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
  paintLegend(painter);
  std::set<std::size_t> ofScenes;
  for (const ScatterPoint& point : points_) ofScenes.insert(point.scene);
  for (const std::size_t scene : ofScenes) paintFront(painter, scene);
  for (const ScatterPoint& point : points_) {
    const QColor color = onPanel(point.color, colors);
    painter.setPen(QPen(color, 1.5));
    painter.setBrush(point.isOnFront ? QBrush(color) : QBrush(Qt::NoBrush));
    drawSign(painter, placeOf(point), point.scene);
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
