#include "app/views/plots/JitterView.h"

#include "app/style/Theme.h"

#include <QFontMetricsF>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {
constexpr double kJitterMargin = 10.0;
constexpr double kMinRadius = 2.0;
constexpr double kFullRadius = 0.16;     ///< of the pixel's side: one sample that is all of the picture
constexpr double kNumberGap = 4.0;       ///< px between a disk and its number
constexpr std::size_t kLongestPath = 64; ///< more could not be told apart
constexpr int kMaxNumbers = 256;         ///< samples that may have one
} // namespace

JitterView::JitterView(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setMinimumSize(140, 140);
  setAccessibleName(tr("Samples of the jitter pattern in a pixel"));
}

void JitterView::setPattern(const JitterPattern& pattern, int current) {
  pattern_ = pattern;
  current_ = current;
  update();
}

void JitterView::setHighlighted(std::optional<int> index) {
  highlighted_ = index;
  update();
}

// Small enough for the disks that reach out of the pixel.
QRectF JitterView::square() const {
  double out = 0.0; // in sides of the square
  for (const JitterSample& sample : pattern_.samples) {
    const glm::dvec2& at = sample.position;
    const double inside = std::min({at.x, at.y, 1.0 - at.x, 1.0 - at.y});
    out = std::max(out, kFullRadius * std::sqrt(std::max(0.0, sample.weight)) - inside);
  }
  const double side = (std::min(width(), height()) - 2.0 * kJitterMargin) / (1.0 + 2.0 * out);
  return {0.5 * (width() - side), 0.5 * (height() - side), side, side};
}

QPointF JitterView::pointOf(const glm::dvec2& position) const {
  const QRectF area = square();
  return {area.left() + position.x * area.width(), area.top() + position.y * area.height()};
}

double JitterView::radiusOf(const JitterSample& sample) const {
  return std::max(kMinRadius, kFullRadius * square().width() * std::sqrt(std::max(0.0, sample.weight)));
}

std::optional<int> JitterView::sampleAt(const QPointF& point) const {
  std::optional<int> found;
  double nearest = 12.0;
  for (int index = 0; index < static_cast<int>(pattern_.samples.size()); ++index) {
    const QPointF way = point - pointOf(pattern_.samples[static_cast<std::size_t>(index)].position);
    const double distance = std::hypot(way.x(), way.y());
    if (distance > nearest) continue;
    nearest = distance;
    found = index;
  }
  return found;
}

QRectF JitterView::numberPlace(int index, const QRectF& disk) const {
  const QFontMetricsF metrics(secondaryFont());
  const QSizeF size(metrics.horizontalAdvance(QString::number(index)), metrics.ascent());
  const double right = disk.right() + kNumberGap, edge = square().right();
  const bool isOnEdge = right <= edge && right + size.width() >= edge; // of the pixel, a line
  const bool fits = right + size.width() <= width() && !isOnEdge;
  const double left = fits ? right : disk.left() - kNumberGap - size.width();
  const double lowest = std::max(0.0, height() - size.height());
  return {{left, std::clamp(disk.center().y() - 0.5 * size.height(), 0.0, lowest)}, size};
}

std::vector<JitterView::Number> JitterView::numbers() const {
  std::vector<QRectF> disks;
  for (const JitterSample& sample : pattern_.samples) {
    const double radius = radiusOf(sample);
    disks.emplace_back(pointOf(sample.position) - QPointF(radius, radius), 2.0 * QSizeF(radius, radius));
  }
  const int count = static_cast<int>(disks.size());
  std::vector<Number> placed;
  const auto add = [&](int index, bool always) {
    const QRectF place = numberPlace(index, disks[static_cast<std::size_t>(index)]);
    const auto covers = [&](const QRectF& other) { return place.intersects(other); };
    if (always ||
        (std::ranges::none_of(placed, covers, &Number::place) && std::ranges::none_of(disks, covers)))
      placed.push_back({index, place});
  };
  if (current_ < count) add(current_, true);
  if (highlighted_ && *highlighted_ < count && *highlighted_ != current_) add(*highlighted_, true);
  for (int index = 0; index < std::min(count, kMaxNumbers); ++index)
    if (index != current_ && index != highlighted_) add(index, false);
  return placed;
}

void JitterView::paintGrid(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const QRectF area = square();
  painter.fillRect(area, colors.field);
  painter.setPen(QPen(colors.line, 1.0));
  for (int cell = 1; cell < pattern_.cells; ++cell) {
    const double part = static_cast<double>(cell) / pattern_.cells;
    painter.drawLine(pointOf({part, 0.0}), pointOf({part, 1.0}));
    painter.drawLine(pointOf({0.0, part}), pointOf({1.0, part}));
  }
  painter.setPen(QPen(colors.secondary, 1.0));
  painter.drawRect(area);
}

void JitterView::paintSamples(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const std::size_t count = pattern_.samples.size();
  if (count > 1 && count <= kLongestPath) {
    QPolygonF path;
    for (const JitterSample& sample : pattern_.samples) path << pointOf(sample.position);
    path << path.first();
    QColor thread = colors.secondary;
    thread.setAlpha(120);
    painter.setPen(QPen(thread, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(path);
  }
  for (std::size_t index = 0; index < count; ++index) {
    const JitterSample& sample = pattern_.samples[index];
    const QPointF center = pointOf(sample.position);
    const bool isCurrent = static_cast<int>(index) == current_;
    const double radius = radiusOf(sample);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isCurrent ? colors.accent : colors.secondary);
    painter.drawEllipse(center, radius, radius);
    if (isCurrent || highlighted_ == static_cast<int>(index)) {
      painter.setPen(QPen(isCurrent ? colors.accent : colors.text, 1.5));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(center, radius + 3.5, radius + 3.5);
    }
  }
  painter.setFont(secondaryFont());
  painter.setPen(colors.text);
  for (const Number& number : numbers())
    painter.drawText(number.place, Qt::AlignCenter | Qt::TextDontClip, QString::number(number.index));
}

// + the middle of all samples, × with their weights: where the content of the picture lies now.
void JitterView::paintMeans(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const auto cross = [&](const glm::dvec2& mean, const QColor& color, double straight, double slanted) {
    const QPointF center = pointOf(mean + 0.5);
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(center + QPointF(-straight, -slanted), center + QPointF(straight, slanted));
    painter.drawLine(center + QPointF(-slanted, straight), center + QPointF(slanted, -straight));
  };
  cross(pattern_.mean, colors.text, 7.0, 0.0);
  cross(pattern_.weightedMean, colors.caution, 5.0, 5.0);
}

void JitterView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintGrid(painter);
  paintSamples(painter);
  paintMeans(painter);
}

void JitterView::mouseMoveEvent(QMouseEvent* event) {
  const std::optional<int> index = sampleAt(event->position());
  if (index != highlighted_) Q_EMIT hovered(index);
}

void JitterView::mousePressEvent(QMouseEvent* event) {
  if (const auto index = sampleAt(event->position()); index && event->button() == Qt::LeftButton)
    Q_EMIT chosen(*index);
}

void JitterView::leaveEvent(QEvent*) {
  Q_EMIT hovered({});
}

} // namespace taa::app
