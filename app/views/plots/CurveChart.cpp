#include "app/views/plots/CurveChart.h"

#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QChart>
#include <QEvent>
#include <QGraphicsLayout>
#include <QLineSeries>
#include <QMouseEvent>
#include <QPainter>
#include <QValueAxis>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::app {

namespace {
constexpr int kDragStart = 5; ///< px that the mouse moves before it is a drag
constexpr double kLeastSpan = 4.0, kZoomStep = 1.25;
constexpr double kTickSpace = 56.0, kValueSpace = 28.0; ///< px between ticks at least
} // namespace

CurveChart::CurveChart(const QString& title, const QString& xTitle, QWidget* parent)
    : QChartView(parent), title_(title), xTitle_(xTitle), frames_(new QValueAxis), values_(new QValueAxis) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setMinimumSize(180, 72);
  setMouseTracking(true);
  setAccessibleName(title);
  setToolTip(tr("Click to go there; drag or turn the wheel to zoom, double-click to see all."));
  QChart* chart = this->chart();
  chart->legend()->hide(); // drawn by hand, with dashes and values
  chart->layout()->setContentsMargins(0, 0, 0, 0);
  chart->setBackgroundRoundness(0);
  chart->addAxis(frames_, Qt::AlignBottom);
  chart->addAxis(values_, Qt::AlignLeft);
  for (QValueAxis* axis : {frames_, values_}) {
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(0.0);
    axis->setLabelFormat(QStringLiteral("%g"));
  }
  applyColors();
  layOutLegend();
  fitAxes();
}

void CurveChart::setCurves(std::vector<Curve> curves) {
  curves_ = std::move(curves);
  layOutLegend();
  fillSeries();
  fitAxes();
}

void CurveChart::setMarks(std::vector<ChartMark> marks) {
  marks_ = std::move(marks);
  viewport()->update();
}

void CurveChart::setPlayhead(std::optional<double> x) {
  playhead_ = x;
  viewport()->update();
}

void CurveChart::setHovered(std::optional<double> x) {
  if (x == hovered_) return;
  hovered_ = x;
  viewport()->update();
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

Span CurveChart::values() const {
  return {values_->min(), values_->max()};
}

// As many series as there are runs; those at hand are used again.
void CurveChart::fillSeries() {
  std::size_t used = 0;
  for (const Curve& curve : curves_)
    for (const std::vector<QPointF>& run : runsOf(curve.points)) {
      if (used == series_.size()) {
        series_.push_back(new QLineSeries);
        chart()->addSeries(series_.back());
        series_.back()->attachAxis(frames_);
        series_.back()->attachAxis(values_);
      }
      QLineSeries* series = series_[used++];
      QPen pen(curve.color, 1.5, curve.dash, Qt::FlatCap);
      if (series->pen() != pen) series->setPen(pen);
      series->setMarkerSize(5.0);
      series->setPointsVisible(run.size() == 1);
      series->replace(QList<QPointF>(run.begin(), run.end()));
    }
  for (; series_.size() > used; series_.pop_back()) delete series_.back();
}

void CurveChart::fitAxes() {
  std::optional<Span> span;
  for (const Curve& curve : curves_)
    if (const auto values = valueSpan(curve.points, shown_))
      span = span ? Span{std::min(span->low, values->low), std::max(span->high, values->high)} : *values;
  const int rows = std::max(2, static_cast<int>((height() - 2 * legend_.height()) / kValueSpace));
  const Span scale = roundedSpan(span.value_or(Span{}), rows);
  values_->setTickInterval(roundStep(scale.length(), rows));
  values_->setRange(scale.low, scale.high);
  const int columns = std::max(2, static_cast<int>(width() / kTickSpace));
  frames_->setTickInterval(std::max(1.0, roundStep(shown_.length(), columns)));
  frames_->setRange(shown_.low, std::max(shown_.high, shown_.low + 1e-9));
  viewport()->update();
}

double CurveChart::xAt(double viewX) const {
  const QRectF plot = chart()->plotArea();
  return shown_.low + (viewX - plot.left()) / std::max(plot.width(), 1.0) * shown_.length();
}

double CurveChart::viewXOf(double x) const {
  const QRectF plot = chart()->plotArea();
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

// Room for the legend above the curves: as many lines as their names take.
void CurveChart::layOutLegend() {
  const double place = QFontMetricsF(secondaryFont()).horizontalAdvance(xTitle_ + QStringLiteral(" 00000"));
  legend_.layOut(title_, curves_, width(), place);
  const QMargins margins(0, static_cast<int>(legend_.height()), 2 * kUnit, 0);
  if (chart()->margins() != margins) chart()->setMargins(margins);
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

void CurveChart::drawForeground(QPainter* painter, const QRectF&) {
  const ThemeColors& colors = themeColors(this);
  const QRectF plot = chart()->plotArea();
  painter->save();
  painter->resetTransform();
  painter->setRenderHint(QPainter::Antialiasing);
  drawMarks(*painter, plot);
  const auto line = [&](std::optional<double> x, const QPen& pen) {
    if (!x || *x < shown_.low || *x > shown_.high) return;
    painter->setPen(pen);
    painter->drawLine(QPointF(viewXOf(*x), plot.top()), QPointF(viewXOf(*x), plot.bottom()));
  };
  line(playhead_, QPen(colors.accent, 2.0));
  line(hovered_, QPen(colors.text, 1.0));
  if (pressedX_ && std::abs(draggedX_ - *pressedX_) >= kDragStart) {
    QColor band = colors.accent;
    band.setAlpha(50);
    painter->fillRect(QRectF(QPointF(*pressedX_, plot.top()), QPointF(draggedX_, plot.bottom())).normalized(),
                      band);
  }
  const auto x = readX();
  QString place = x ? QStringLiteral("%1 %2").arg(xTitle_).arg(*x) : QString();
  if (const QString mark = x ? markText(*x) : QString(); !mark.isEmpty())
    place += QStringLiteral(" · ") + mark;
  legend_.paint(*painter, colors, title_, curves_, x, place);
  painter->restore();
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
  viewport()->update();
}

void CurveChart::cancelDrag() {
  pressedX_.reset();
  viewport()->update();
}

void CurveChart::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressedX_) return;
  const double from = *std::exchange(pressedX_, {}), to = event->position().x();
  viewport()->update();
  if (std::abs(to - from) < kDragStart) {
    Q_EMIT xClicked(std::clamp(std::round(xAt(to)), all_.low, all_.high));
    return;
  }
  const Span wished{std::max(all_.low, xAt(std::min(from, to))),
                    std::min(all_.high, xAt(std::max(from, to)))};
  const double factor = shown_.length() / std::max(wished.length(), 1e-9);
  const Span sized = zoomed(shown_, all_, factor, 0.5 * (shown_.low + shown_.high), kLeastSpan);
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
        zoomed(shown_, all_, std::pow(kZoomStep, delta.y() / 120.0), xAt(event->position().x()), kLeastSpan));
  else
    setShown(moved(shown_, all_, -delta.x() / 1200.0 * shown_.length()));
  event->accept();
}

void CurveChart::leaveEvent(QEvent*) {
  setHovered({});
  Q_EMIT hovered({});
}

void CurveChart::applyColors() {
  const ThemeColors& colors = themeColors(this);
  setBackgroundBrush(colors.panel);
  chart()->setBackgroundBrush(colors.panel);
  for (QValueAxis* axis : {frames_, values_}) {
    axis->setLabelsFont(secondaryFont());
    axis->setLabelsBrush(colors.secondary);
    axis->setLinePen(QPen(colors.line));
    axis->setGridLinePen(QPen(colors.line));
  }
}

void CurveChart::resizeEvent(QResizeEvent* event) {
  QChartView::resizeEvent(event);
  layOutLegend();
  fitAxes();
}

void CurveChart::changeEvent(QEvent* event) {
  QChartView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) applyColors();
}

} // namespace taa::app
