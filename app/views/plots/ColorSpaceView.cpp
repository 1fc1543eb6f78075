#include "app/views/plots/ColorSpaceView.h"

#include "app/style/Numbers.h"
#include "app/style/PaintedAsFigure.h"
#include "app/style/Theme.h"
#include "app/views/plots/ColorItems.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QRectF>
#include <QToolTip>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace taa::app {

namespace {

QPen penOf(PlotShape shape, const QColor& color) {
  QPen pen(color, shape == PlotShape::Solid ? 1.6 : 1.1);
  if (shape == PlotShape::Dotted) pen.setStyle(Qt::DotLine);
  if (shape == PlotShape::Dashed) pen.setStyle(Qt::DashLine);
  return pen;
}

/// A disk in its own color, with a outline that any ground lets see.
void drawSample(QPainter& painter, QPointF place, const QColor& outline, const QColor& fill) {
  painter.setPen(QPen(outline, 1.2));
  painter.setBrush(fill);
  painter.drawEllipse(place, 4.0, 4.0);
}

void drawMark(QPainter& painter, QPointF place, PlotShape shape, const QColor& color) {
  constexpr double r = 4.5;
  const bool isFilled =
      shape == PlotShape::Dot || shape == PlotShape::FilledDiamond || shape == PlotShape::Square;
  painter.setPen(QPen(color, 1.4));
  painter.setBrush(isFilled ? QBrush(color) : QBrush(Qt::NoBrush));
  switch (shape) {
  case PlotShape::Dot:
    painter.drawEllipse(place, r, r);
    return;
  case PlotShape::Ring:
    painter.drawEllipse(place, r - 1.5, r - 1.5);
    return;
  case PlotShape::Diamond:
  case PlotShape::FilledDiamond: {
    const std::array<QPointF, 4> corners{place + QPointF(0, -r - 1), place + QPointF(r + 1, 0),
                                         place + QPointF(0, r + 1), place + QPointF(-r - 1, 0)};
    painter.drawPolygon(corners.data(), 4);
    return;
  }
  case PlotShape::Square:
    painter.drawRect(QRectF(place.x() - r + 0.5, place.y() - r + 0.5, 2 * r - 1, 2 * r - 1));
    return;
  default:
    painter.drawLine(place + QPointF(-3, -3), place + QPointF(3, 3));
    painter.drawLine(place + QPointF(-3, 3), place + QPointF(3, -3));
  }
}

using Place = std::function<QPointF(const glm::vec3&)>;

void paintItem(QPainter& painter, const PlotItem& item, const Place& placeOf) {
  bool isFirst = true;
  for (const auto& [a, b] : item.lines) {
    QPen pen = penOf(item.shape, item.color);
    // The part of the way that history went is drawn through, the rest of it dotted.
    if (item.shape == PlotShape::Arrow && !isFirst) pen.setStyle(Qt::DotLine);
    painter.setPen(pen);
    painter.drawLine(placeOf(a), placeOf(b));
    isFirst = false;
  }
  for (std::size_t index = 0; index < item.points.size(); ++index) {
    const QPointF place = placeOf(item.points[index]);
    if (index < item.fills.size())
      drawSample(painter, place, item.color, item.fills[index]);
    else
      drawMark(painter, place, item.shape, item.color);
  }
}

constexpr double kTickShare = 0.45;         ///< of half an edge: room around the frame for its ticks
constexpr int kLowestWithProjections = 320; ///< px where text has its own size
constexpr int kMaxTicks = 4;                ///< on an axis
constexpr int kLowestWithTicks = 9;         ///< lines of text, of the plot

/// Of length 1, or 0.
QPointF directionOf(QPointF way) {
  return way / std::max(1e-6, std::hypot(way.x(), way.y()));
}

} // namespace

struct ColorSpaceView::Content {
  const ThemeColors& colors;
  std::vector<PlotItem> items;
};

ColorSpaceView::ColorSpaceView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setFont(secondaryFont());
  setMinimumSize(240, 100);
  setCursor(Qt::OpenHandCursor);
  setAccessibleName(tr("Color space plot"));
}

void ColorSpaceView::setScene(const std::optional<ColorScene>& scene) {
  scene_ = scene;
  if (scene_) {
    range_ = rangeOf(*scene_);
    const std::array values{scene_->resolved.x, scene_->resolved.y, scene_->resolved.z};
    setAccessibleDescription(tr("resolved %1").arg(tupleText(values)));
  }
  update();
}

void ColorSpaceView::setTurn(const SpaceTurn& turn) {
  turn_ = turn;
  update();
}

void ColorSpaceView::turnBy(double stepsRight, double stepsUp) {
  constexpr double kStepPx = 5.0 * std::numbers::pi / 180.0 / 0.01; // of a drag that turns as far
  setTurn(turned(turn_, {kStepPx * stepsRight, kStepPx * stepsUp}));
}

int ColorSpaceView::legendHeight() const {
  return 4 * (fontMetrics().height() + 2) + kUnit;
}

// In a low window the plot alone has what room there is.
int ColorSpaceView::projections() const {
  return height() - legendHeight() < scaled(kLowestWithProjections) ? 0
                                                                    : static_cast<int>(kProjections.size());
}

QRectF ColorSpaceView::plotRect() const {
  const double bottom = projections() > 0 ? projectionRect(0).top() : height() - legendHeight();
  return {0, 0, static_cast<double>(width()), std::max(60.0, bottom - 2 * kUnit)};
}

QRectF ColorSpaceView::projectionRect(int index) const {
  double labels = 0.0, before = 0.0; // left of all three, and of those up to this one
  for (int each = 0; each < 3; ++each) {
    labels += upLabelsWidth(each);
    if (each == index) before = labels;
  }
  const double side = std::min((width() - labels - 4.0 * kUnit) / 3, 0.34 * (height() - legendHeight()));
  const double top = height() - legendHeight() - side - 2 * fontMetrics().height() - kUnit;
  const double gap = (width() - labels - 3 * side) / 4;
  return {before + gap + index * (side + gap), top, side, side};
}

// Of what stands left of a projection.
double ColorSpaceView::upLabelsWidth(int projection) const {
  const int up = kProjections[static_cast<std::size_t>(projection)].second;
  const auto ticks = ticksOf(range_, kMaxTicks);
  int widest = 0;
  for (const double tick : ticks[static_cast<std::size_t>(up)])
    widest = std::max(widest, fontMetrics().horizontalAdvance(shortText(tick)));
  return widest + kUnit;
}

QPointF ColorSpaceView::placeOf(const glm::vec3& color) const {
  const QRectF rect = plotRect();
  const glm::dvec2 place = projected(range_.unit(color), turn_).place;
  const double scale = 0.5 * std::min(rect.width(), rect.height()) / (std::sqrt(3.0) + kTickShare);
  return rect.center() + scale * QPointF(place.x, -place.y);
}

QPointF ColorSpaceView::flatPlace(const glm::vec3& color, int projection) const {
  const QRectF rect = projectionRect(projection);
  const auto& [right, up] = kProjections[static_cast<std::size_t>(projection)];
  const glm::dvec3 unit = range_.unit(color);
  return rect.center() + 0.5 * rect.width() * QPointF(unit[right], -unit[up]);
}

void ColorSpaceView::paintPlot(QPainter& painter, const Content& content) const {
  const Place place = [this](const glm::vec3& color) { return placeOf(color); };
  painter.setPen(QPen(content.colors.line, 1));
  for (const auto& [a, b] : edgesOf(cornersOf(range_))) painter.drawLine(placeOf(a), placeOf(b));
  for (const PlotItem& item : content.items) paintItem(painter, item, place);
  paintNames(painter, content);
  paintAxes(painter, content);
}

// Names stand beyond the ends of their axes, ticks away from the middle.
std::vector<ChartLabel> ColorSpaceView::axisLabels() const {
  std::vector<ChartLabel> labels;
  if (!scene_) return labels;
  const glm::vec3 size = range_.high - range_.low;
  const auto sizeOf = [&](const QString& text) {
    return QSizeF(fontMetrics().horizontalAdvance(text), fontMetrics().height());
  };
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 end = outerEdge(range_, turn_, axis);
    end[axis] = range_.high[axis] + 0.12f * size[axis];
    QRectF place({}, sizeOf(axisName(axis)));
    place.moveCenter(placeOf(end));
    labels.push_back({axisName(axis), place});
  }
  if (plotRect().height() < kLowestWithTicks * fontMetrics().height()) return labels; // they would hide it
  for (const auto& [at, tick] : axisTicks()) {
    const QPointF away = at - placeOf(range_.low + 0.5f * size);
    const QString text = shortText(tick);
    const QSizeF room = sizeOf(text);
    QRectF place({}, room);
    place.moveCenter(at + directionOf(away) * (0.5 * std::hypot(room.width(), room.height()) + 2.0));
    const auto hides = [&](const ChartLabel& other) { return other.place.intersects(place); };
    if (std::ranges::none_of(labels, hides)) labels.push_back({text, place});
  }
  return labels;
}

// Right of the points, each below what it would cover.
void ColorSpaceView::paintNames(QPainter& painter, const Content& content) const {
  std::vector<QRectF> taken;
  for (const PlotItem& item : content.items)
    for (std::size_t index = 0; index < item.names.size(); ++index) {
      const QSizeF size(fontMetrics().horizontalAdvance(item.names[index]), fontMetrics().height());
      QRectF rect(placeOf(item.points[index]) + QPointF(kUnit + 2, -size.height() / 2), size);
      rect.moveRight(std::min(rect.right(), static_cast<double>(width())));
      for (bool moved = true; std::exchange(moved, false);)
        for (const QRectF& other : taken)
          if (other.intersects(rect)) rect.moveTop(other.bottom()), moved = true;
      taken.push_back(rect);
      painter.setPen(item.color);
      painter.drawText(rect, Qt::AlignCenter | Qt::TextDontClip, item.names[index]);
    }
}

// Places, and what is there.
std::vector<std::pair<QPointF, double>> ColorSpaceView::axisTicks() const {
  std::vector<std::pair<QPointF, double>> places;
  const auto ticks = ticksOf(range_, kMaxTicks);
  for (int axis = 0; axis < 3; ++axis)
    for (const double tick : ticks[static_cast<std::size_t>(axis)]) {
      glm::vec3 at = outerEdge(range_, turn_, axis);
      at[axis] = static_cast<float>(tick);
      places.emplace_back(placeOf(at), tick);
    }
  return places;
}

void ColorSpaceView::paintAxes(QPainter& painter, const Content& content) const {
  const std::vector<ChartLabel> labels = axisLabels();
  painter.setPen(content.colors.secondary);
  const QPointF middle = placeOf(0.5f * (range_.low + range_.high));
  if (labels.size() > 3)
    for (const auto& [at, tick] : axisTicks()) painter.drawLine(at, at + directionOf(at - middle) * kUnit);
  for (std::size_t index = 0; index < labels.size(); ++index) {
    painter.setPen(index < 3 ? content.colors.text : content.colors.secondary);
    painter.drawText(labels[index].place, Qt::AlignCenter | Qt::TextDontClip, labels[index].text);
  }
}

QString ColorSpaceView::axisName(int axis) const {
  return QString::fromStdString(scene_->axes[static_cast<std::size_t>(axis)]);
}

void ColorSpaceView::paintProjection(QPainter& painter, const Content& content, int index) const {
  const QRectF rect = projectionRect(index);
  painter.setPen(QPen(content.colors.line, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect);
  painter.save();
  painter.setClipRect(rect);
  for (const PlotItem& item : content.items)
    paintItem(painter, item, [&](const glm::vec3& color) { return flatPlace(color, index); });
  painter.restore();
  paintFlatAxes(painter, content, index);
}

// Ticks stand inside of the frame, labels outside.
void ColorSpaceView::paintFlatAxes(QPainter& painter, const Content& content, int index) const {
  const QRectF rect = projectionRect(index);
  const auto& [right, up] = kProjections[static_cast<std::size_t>(index)];
  const auto ticks = ticksOf(range_, kMaxTicks);
  painter.setPen(content.colors.secondary);
  const double line = fontMetrics().height();
  double free = rect.left(); // labels do not run into each other
  for (const double tick : ticks[static_cast<std::size_t>(right)]) {
    glm::vec3 at = range_.low;
    at[right] = static_cast<float>(tick);
    const double x = flatPlace(at, index).x(), wide = fontMetrics().horizontalAdvance(shortText(tick));
    painter.drawLine(QPointF(x, rect.bottom()), QPointF(x, rect.bottom() - kUnit));
    const double left = std::clamp(x - wide / 2, rect.left(), std::max(rect.left(), rect.right() - wide));
    if (left < free) continue;
    painter.drawText(QRectF(left, rect.bottom() + 1, wide, line), Qt::AlignCenter | Qt::TextDontClip,
                     shortText(tick));
    free = left + wide + kUnit;
  }
  for (const double tick : ticks[static_cast<std::size_t>(up)]) {
    glm::vec3 at = range_.low;
    at[up] = static_cast<float>(tick);
    const double y = flatPlace(at, index).y();
    painter.drawLine(QPointF(rect.left(), y), QPointF(rect.left() + kUnit, y));
    const double top = std::clamp(y - line / 2, rect.top(), rect.bottom() - line);
    painter.drawText(QRectF(rect.left() - kUnit, top, 0, line),
                     Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, shortText(tick));
  }
  painter.setPen(content.colors.text);
  const QString name = tr("%1 right, %2 up").arg(axisName(right), axisName(up));
  const double wide = fontMetrics().horizontalAdvance(name); // it may be wider than its plot
  const double left = std::clamp(rect.center().x() - wide / 2, 0.0, std::max(0.0, width() - wide));
  painter.drawText(QRectF(left, rect.bottom() + 1 + line, wide, line), Qt::AlignCenter | Qt::TextDontClip,
                   name);
}

void ColorSpaceView::paintLegend(QPainter& painter, const Content& content) const {
  const double line = fontMetrics().height() + 2;
  double x = 2 * kUnit, y = height() - legendHeight();
  for (const PlotItem& item : content.items) {
    const double wide = 24 + fontMetrics().horizontalAdvance(item.label) + 3 * kUnit;
    if (x + wide > width() && x > 2 * kUnit) x = 2 * kUnit, y += line;
    const QPointF middle(x + 9, y + line / 2);
    if (item.points.empty()) {
      painter.setPen(penOf(item.shape, item.color));
      painter.drawLine(middle - QPointF(9, 0), middle + QPointF(9, 0));
    } else if (!item.fills.empty()) {
      drawSample(painter, middle, item.color, item.fills[item.fills.size() / 2]);
    } else {
      drawMark(painter, middle, item.shape, item.color);
    }
    painter.setPen(content.colors.text);
    painter.drawText(QRectF(x + 22, y, wide, line), Qt::AlignVCenter | Qt::AlignLeft, item.label);
    x += wide;
  }
}

void ColorSpaceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColors& colors = themeColors(this);
  if (!scene_) {
    painter.setPen(colors.secondary);
    painter.drawText(rect(), Qt::AlignCenter, tr("There are no values to plot in this frame"));
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const Content content{colors, colorItems(*scene_, colors)};
  paintPlot(painter, content);
  for (int index = 0; index < projections(); ++index) paintProjection(painter, content, index);
  paintLegend(painter, content);
  if (!hasFocus() || isPaintedAsFigure(*this)) return;
  painter.setPen(QPen(colors.accent, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(0.5, 0.5, width() - 1, height() - 1));
}

QString ColorSpaceView::textAt(QPointF place) const {
  if (!scene_) return {};
  constexpr double kNear = 9.0;
  double least = kNear;
  QString text;
  for (const PlotItem& item : colorItems(*scene_, themeColors(this)))
    for (std::size_t index = 0; index < item.points.size(); ++index)
      for (int plot = -1; plot < projections(); ++plot) {
        const glm::vec3& point = item.points[index];
        const QPointF away = (plot < 0 ? placeOf(point) : flatPlace(point, plot)) - place;
        if (std::hypot(away.x(), away.y()) > least) continue;
        least = std::hypot(away.x(), away.y());
        const std::array values{point.x, point.y, point.z};
        text = QStringLiteral("%1 %2").arg(item.names.empty() ? item.label : item.names[index],
                                           tupleText(values));
      }
  return text;
}

void ColorSpaceView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  held_ = event->position();
  setCursor(Qt::ClosedHandCursor);
}

void ColorSpaceView::mouseMoveEvent(QMouseEvent* event) {
  if (!held_) return;
  const QPointF moved = event->position() - *held_;
  held_ = event->position();
  setTurn(turned(turn_, {moved.x(), moved.y()}));
}

void ColorSpaceView::mouseReleaseEvent(QMouseEvent*) {
  held_.reset();
  setCursor(Qt::OpenHandCursor);
}

void ColorSpaceView::mouseDoubleClickEvent(QMouseEvent*) {
  resetTurn();
}

void ColorSpaceView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
  case Qt::Key_Left:
    turnBy(-1, 0);
    return;
  case Qt::Key_Right:
    turnBy(1, 0);
    return;
  case Qt::Key_Up:
    turnBy(0, -1);
    return;
  case Qt::Key_Down:
    turnBy(0, 1);
    return;
  default:
    QWidget::keyPressEvent(event);
  }
}

bool ColorSpaceView::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), textAt(QPointF(help->pos())), this);
  return true;
}

} // namespace taa::app
