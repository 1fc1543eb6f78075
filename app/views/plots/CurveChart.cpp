#include "app/views/plots/CurveChart.h"

#include "app/style/CurveColor.h"
#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::app {

namespace {
constexpr int kDragStart = 5; ///< px that the mouse moves before it is a drag
constexpr double kMinSpan = 4.0, kZoomStep = 1.25;
constexpr double kColumnSpace = 56.0, kValueSpace = 28.0; ///< px between ticks at least
constexpr double kDotRadius = 2.5;                        ///< px
constexpr int kLeastWidth = 180;                          ///< px
constexpr int kLeastPlot = 16, kLeastBeside = 52; ///< px high; beside: with half a label at either end
constexpr double kTickRoom = 48.0;                ///< px left of the plot, where values of y stand
} // namespace

CurveChart::CurveChart(const QString& title, const QString& xTitle, QWidget* parent)
    : QWidget(parent), title_(title), xTitle_(xTitle) {
  setFocusPolicy(Qt::NoFocus);
  setMouseTracking(true);
  setAccessibleName(title);
  setToolTip(tr("Click to go there; drag or turn the wheel to zoom, double-click to see all."));
  layOutLegend();
  fitAxes();
}

void CurveChart::setCurves(std::vector<Curve> curves) {
  curves_ = std::move(curves);
  layOutLegend();
  fitAxes();
}

void CurveChart::setMarks(std::vector<ChartMark> marks) {
  marks_ = std::move(marks);
  update();
}

void CurveChart::setPlayhead(std::optional<double> x) {
  playhead_ = x;
  update();
}

void CurveChart::setEdges(const Span& edges) {
  if (edges_ == edges) return;
  edges_ = edges;
  updateGeometry();
  layOutLegend();
  fitAxes();
}

void CurveChart::setHovered(std::optional<double> x) {
  if (x == hovered_) return;
  hovered_ = x;
  update();
}

void CurveChart::setBounds(const Span& all) {
  if (all == all_) return;
  const bool showsAll = shown_ == all_;
  all_ = all;
  setShown(showsAll ? all_ : moved(shown_, all_, 0.0));
}

void CurveChart::setShown(const Span& shown) {
  if (shown == shown_) return;
  shown_ = shown;
  fitAxes();
  Q_EMIT shownChanged(shown_);
}

void CurveChart::fitAxes() {
  std::optional<Span> span;
  for (const Curve& curve : curves_)
    if (const auto values = valueSpan(curve.points, shown_))
      span = span ? Span{std::min(span->low, values->low), std::max(span->high, values->high)} : *values;
  const int besidePlot = edges_ ? 0 : minimumSizeHint().height() - scaled(kLeastPlot);
  const int fewest = height() - besidePlot < 2 * scaled(kValueSpace) ? 1 : 2;
  const int rows =
      std::max(fewest, static_cast<int>((height() - 2 * legend_.height()) / scaled(kValueSpace)));
  const Span scale = roundedSpan(span.value_or(Span{}), rows);
  const int columns = std::max(2, static_cast<int>(width() / scaled(kColumnSpace)));
  const Span frames{shown_.low, std::max(shown_.high, shown_.low + 1e-9)};
  axes_.layOut({frames, std::max(1.0, roundStep(shown_.length(), columns))}, {scale, tickStep(scale, rows)},
               QRectF(rect()).adjusted(kUnit, legend_.height(), -2.0 * kUnit, -1.0), edges_);
  update();
}

double CurveChart::xAt(double viewX) const {
  const QRectF& plot = axes_.plot();
  return shown_.low + (viewX - plot.left()) / std::max(plot.width(), 1.0) * shown_.length();
}

double CurveChart::viewXOf(double x) const {
  const QRectF& plot = axes_.plot();
  return plot.left() + (x - shown_.low) / std::max(shown_.length(), 1e-9) * plot.width();
}

QString CurveChart::markText(double x) const {
  QStringList texts;
  for (const ChartMark& mark : marks_)
    if (mark.x == x) texts << mark.text;
  return texts.join(QStringLiteral(", "));
}

QString CurveChart::readout() const {
  QStringList parts{title_};
  const auto x = readX();
  for (const Curve& curve : curves_) {
    const auto value = x ? valueAt(curve.points, *x) : std::nullopt;
    parts << (value ? QStringLiteral("%1 %2").arg(curve.name, shortText(*value, 4)) : curve.name);
  }
  if (x) parts << QStringLiteral("%1 %2").arg(xTitle_).arg(*x) << markText(*x);
  parts.removeAll(QString());
  return parts.join(QStringLiteral("  "));
}

// Curves keep some height below the lines of their names and above the labels of x.
QSize CurveChart::minimumSizeHint() const {
  if (edges_) return {kLeastWidth, scaled(kLeastBeside)};
  const double labels = 1.5 * QFontMetricsF(secondaryFont()).height() + 2.0 * kUnit;
  return {kLeastWidth, static_cast<int>(std::ceil(legend_.height() + labels)) + scaled(kLeastPlot)};
}

// Room for the legend above the curves: as many lines as their names take.
void CurveChart::layOutLegend() {
  const QSize least = minimumSizeHint();
  layOutNames();
  if (minimumSizeHint() != least) updateGeometry();
}

void CurveChart::layOutNames() {
  if (edges_) {
    legend_.layOutBeside(curves_, edges_->low - scaled(kTickRoom), edges_->high + 3.0 * kUnit,
                         width() - 2.0 * kUnit);
    return;
  }
  const double place = QFontMetricsF(secondaryFont()).horizontalAdvance(xTitle_ + QStringLiteral(" 00000"));
  legend_.layOut(title_, curves_, width(), place);
}

// A run of one point between gaps is a dot.
void CurveChart::drawCurves(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  painter.save();
  painter.setClipRect(axes_.plot().adjusted(-1.0, -1.0, 1.0, 1.0));
  for (const Curve& curve : curves_) {
    const QColor color = onPanel(curve.color, colors);
    for (const std::vector<QPointF>& run : runsOf(curve.points)) {
      QPolygonF line;
      for (const QPointF& point : run) line << axes_.pointOf(point);
      painter.setPen(QPen(color, 1.5, curve.dash, Qt::FlatCap));
      painter.setBrush(Qt::NoBrush);
      if (run.size() > 1) {
        painter.drawPolyline(line);
        continue;
      }
      painter.setPen(Qt::NoPen);
      painter.setBrush(color);
      painter.drawEllipse(line.first(), kDotRadius, kDotRadius);
    }
  }
  painter.restore();
}

void CurveChart::drawMarks(QPainter& painter, const QRectF& plot) const {
  const ThemeColors& colors = themeColors(this);
  for (const ChartMark& mark : marks_) {
    const double x = viewXOf(mark.x);
    if (x < plot.left() - 0.5 || x > plot.right() + 0.5) continue;
    if (mark.kind == MarkKind::Cut) {
      painter.setPen(QPen(colors.secondary, 1.0, Qt::DashLine));
      painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
      continue;
    }
    painter.setPen(QPen(colors.wrong, 1.5));
    const double y = plot.bottom() - 4.0, r = 2.5;
    painter.drawLine(QPointF(x - r, y - r), QPointF(x + r, y + r));
    painter.drawLine(QPointF(x - r, y + r), QPointF(x + r, y - r));
  }
}

void CurveChart::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  const QRectF& plot = axes_.plot();
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  painter.setRenderHint(QPainter::Antialiasing);
  axes_.paint(painter, colors);
  drawCurves(painter);
  drawMarks(painter, plot);
  const auto line = [&](std::optional<double> x, const QPen& pen) {
    if (!x || *x < shown_.low || *x > shown_.high) return;
    painter.setPen(pen);
    painter.drawLine(QPointF(viewXOf(*x), plot.top()), QPointF(viewXOf(*x), plot.bottom()));
  };
  line(playhead_, QPen(colors.accent, 2.0));
  line(hovered_, QPen(colors.text, 1.0));
  if (pressedX_ && std::abs(draggedX_ - *pressedX_) >= kDragStart) {
    QColor band = colors.accent;
    band.setAlpha(50);
    painter.fillRect(QRectF(QPointF(*pressedX_, plot.top()), QPointF(draggedX_, plot.bottom())).normalized(),
                     band);
  }
  const auto x = readX();
  QString place = x ? QStringLiteral("%1 %2").arg(xTitle_).arg(*x) : QString();
  if (const QString mark = x ? markText(*x) : QString(); !mark.isEmpty())
    place += QStringLiteral(" · ") + mark;
  legend_.paint(painter, colors, title_, curves_, x, place);
}

void CurveChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) pressedX_ = draggedX_ = event->position().x();
}

void CurveChart::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (pressedX_) draggedX_ = x;
  const double at = std::round(xAt(x));
  const std::optional<double> over =
      at < all_.low || at > all_.high ? std::nullopt : std::optional<double>(at);
  setHovered(over);
  Q_EMIT hovered(over);
  update();
}

void CurveChart::cancelDrag() {
  pressedX_.reset();
  update();
}

void CurveChart::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressedX_) return;
  const double from = *std::exchange(pressedX_, {}), to = event->position().x();
  update();
  if (std::abs(to - from) < kDragStart) {
    Q_EMIT xClicked(std::clamp(std::round(xAt(to)), all_.low, all_.high));
    return;
  }
  const Span wished{std::max(all_.low, xAt(std::min(from, to))),
                    std::min(all_.high, xAt(std::max(from, to)))};
  const double factor = shown_.length() / std::max(wished.length(), 1e-9);
  const Span sized = zoomed(shown_, all_, factor, 0.5 * (shown_.low + shown_.high), kMinSpan);
  setShown(moved(sized, all_, 0.5 * (wished.low + wished.high - sized.low - sized.high)));
}

void CurveChart::mouseDoubleClickEvent(QMouseEvent*) {
  pressedX_.reset();
  resetZoom();
}

void CurveChart::wheelEvent(QWheelEvent* event) {
  const QPoint delta = event->angleDelta();
  if (delta.y() != 0)
    setShown(
        zoomed(shown_, all_, std::pow(kZoomStep, delta.y() / 120.0), xAt(event->position().x()), kMinSpan));
  else
    setShown(moved(shown_, all_, -delta.x() / 1200.0 * shown_.length()));
  event->accept();
}

void CurveChart::leaveEvent(QEvent*) {
  setHovered({});
  Q_EMIT hovered({});
}

void CurveChart::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layOutLegend();
  fitAxes();
}

} // namespace taa::app
