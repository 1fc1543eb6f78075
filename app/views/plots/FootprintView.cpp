#include "app/views/plots/FootprintView.h"

#include "app/models/verdict/LineageMath.h"
#include "app/style/Theme.h"
#include "app/views/plots/LineageBars.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::app {

namespace {
constexpr double kFootprintMargin = 10.0;
constexpr double kMinDotRadius = 1.0;
constexpr double kWholeRadius = 0.25;  ///< of a pixel's side: one sample that is all of the pixel
constexpr double kMinPixelSide = 40.0; ///< px that a pixel's side counts as at least for that
constexpr double kGrabRadius = 8.0;
} // namespace

FootprintView::FootprintView(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setMinimumSize(140, 140);
  setAccessibleName(tr("Places of the samples around the pixel's center"));
  setToolTip(tr("Where the samples lie around the pixel's center now, in its pixels, with areas as their "
                "weights. Gray ones are old, rings count against the others. A click goes to the sample's "
                "frame."));
}

void FootprintView::setLineage(std::shared_ptr<const Lineage> lineage) {
  lineage_ = std::move(lineage);
  reach_ = lineage_ ? footprintReach(lineage_->samples) : footprintReach({});
  update();
}

void FootprintView::setHighlighted(std::optional<int> frame) {
  if (frame == highlighted_) return;
  highlighted_ = frame;
  update();
}

QRectF FootprintView::square() const {
  const double side = std::min(width(), height()) - 2.0 * kFootprintMargin;
  return {0.5 * (width() - side), 0.5 * (height() - side), side, side};
}

QPointF FootprintView::pointOf(const glm::dvec2& offset) const {
  const QRectF area = square();
  return area.center() + QPointF(offset.x, offset.y) * (0.5 * area.width() / reach_);
}

double FootprintView::radiusOf(const FootprintSample& sample) const {
  const double pixel = std::max(kMinPixelSide, 0.5 * square().width() / reach_);
  return std::max(kMinDotRadius, kWholeRadius * pixel * std::sqrt(std::fabs(sample.weight)));
}

std::optional<int> FootprintView::frameAt(const QPointF& point) const {
  std::optional<int> found;
  double nearest = kGrabRadius;
  if (!lineage_) return {};
  for (const FootprintSample& sample : lineage_->samples) {
    const QPointF way = point - pointOf(sample.offset);
    const double distance = std::hypot(way.x(), way.y());
    if (distance >= nearest) continue;
    nearest = distance;
    found = sample.frame;
  }
  return found;
}

// Pixels of the picture; the middle one is the pixel.
void FootprintView::paintGrid(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  const QRectF area = square();
  painter.fillRect(area, colors.field);
  painter.setPen(QPen(colors.line, 1.0));
  for (double edge = 0.5; edge < reach_; edge += 1.0)
    for (const double line : {-edge, edge}) {
      painter.drawLine(pointOf({line, -reach_}), pointOf({line, reach_}));
      painter.drawLine(pointOf({-reach_, line}), pointOf({reach_, line}));
    }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.text, 1.0));
  painter.drawRect(QRectF(pointOf({-0.5, -0.5}), pointOf({0.5, 0.5})));
}

// The youngest last, over the others. Those that count against the rest are rings.
void FootprintView::paintSamples(QPainter& painter) const {
  const ThemeColors& colors = themeColors(this);
  painter.setClipRect(square());
  for (auto sample = lineage_->samples.rbegin(); sample != lineage_->samples.rend(); ++sample) {
    const QPointF center = pointOf(sample->offset);
    const double radius = radiusOf(*sample);
    if (!square().adjusted(-radius, -radius, radius, radius).contains(center))
      continue; // a drawing has no clip
    const QColor color = ageColor(this, ageShare(*lineage_, sample->frame));
    const bool isFilled = sample->weight >= 0.0;
    painter.setPen(isFilled ? QPen(Qt::NoPen) : QPen(color, 1.0));
    painter.setBrush(isFilled ? QBrush(color) : QBrush(Qt::NoBrush));
    painter.drawEllipse(center, radius, radius);
    if (highlighted_ != sample->frame) continue;
    painter.setPen(QPen(colors.text, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(center, radius + 2.0, radius + 2.0);
  }
  painter.setClipping(false);
}

void FootprintView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintGrid(painter);
  if (lineage_) paintSamples(painter);
}

void FootprintView::mouseMoveEvent(QMouseEvent* event) {
  const std::optional<int> frame = frameAt(event->position());
  if (frame != highlighted_) Q_EMIT hovered(frame);
}

void FootprintView::mousePressEvent(QMouseEvent* event) {
  if (const auto frame = frameAt(event->position()); frame && event->button() == Qt::LeftButton)
    Q_EMIT chosen(*frame);
}

void FootprintView::leaveEvent(QEvent*) {
  Q_EMIT hovered({});
}

} // namespace taa::app
