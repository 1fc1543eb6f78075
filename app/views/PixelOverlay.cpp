#include "app/views/PixelOverlay.h"

#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QList>
#include <QPainter>
#include <QPainterPath>
#include <QPen>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace taa::app {

namespace {

/// Readable on any color: dark outline, light inside.
void drawOutlined(QPainter& painter, QPointF baseline, const QFont& font, const QString& text) {
  QPainterPath path;
  path.addText(baseline, font, text);
  painter.strokePath(path, QPen(QColor(0, 0, 0, 220), 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(path, QColor(255, 255, 255));
}

} // namespace

ScreenRect PixelOverlay::pixelRect(glm::ivec2 pixel) const {
  const glm::dvec2 corner = screenFromPicture(transform_, glm::dvec2(pixel)) / pixelRatio_;
  return {corner.x, corner.y, texel_, texel_};
}

void PixelOverlay::paintGrid(QPainter& painter) const {
  const gl::Rect seen = geometry_.visiblePixels(transform_);
  const ScreenRect first = pixelRect({seen.x, seen.y});
  const double right = first.x + seen.width * texel_, bottom = first.y + seen.height * texel_;
  const double line = 1.0 / pixelRatio_;
  const QColor color(128, 128, 128, 110);
  for (int x = 0; x <= seen.width; ++x)
    painter.fillRect(QRectF(first.x + x * texel_, first.y, line, bottom - first.y), color);
  for (int y = 0; y <= seen.height; ++y)
    painter.fillRect(QRectF(first.x, first.y + y * texel_, right - first.x, line), color);
}

void PixelOverlay::paintValues(QPainter& painter, const Intermediate& row, const PartialImage& numbers,
                               const gl::Rect& region) const {
  const Image& values = numbers.values;
  if (values.empty()) return;
  const int channels = std::min(row.channels, values.channels);
  QFont font = numberFont();
  // Larger texels hold more digits, not larger ones.
  const double advance = QFontMetricsF(font).horizontalAdvance(QLatin1Char('0'));
  const int fits = static_cast<int>((texel_ - 4) / advance);
  const int digits = std::clamp(fits - 4, 2, 7); // room for a sign, a point, leading zeros
  const double lineHeight = std::min(QFontMetricsF(font).height(), (texel_ - 4) / channels);
  painter.setRenderHint(QPainter::Antialiasing);
  for (int y = 0; y < values.height; ++y)
    for (int x = 0; x < values.width; ++x) {
      if (!numbers.absence.empty() && *numbers.absence.at(x, y) != 0.0f) continue;
      const ScreenRect cell = pixelRect({region.x + x, region.y + y});
      double top = cell.y + (texel_ - lineHeight * channels) / 2;
      for (int channel = 0; channel < channels; ++channel, top += lineHeight) {
        const QString text = shortText(values.at(x, y)[channel], digits);
        const double width = advance * static_cast<double>(text.size());
        QFont fitting = font;
        if (width > texel_ - 4)
          fitting.setPointSizeF(std::max(6.0, font.pointSizeF() * (texel_ - 4) / width));
        const double used = std::min(width, texel_ - 4);
        drawOutlined(painter, {cell.x + (texel_ - used) / 2, top + lineHeight * 0.8}, fitting, text);
      }
    }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void PixelOverlay::paintProbe(QPainter& painter, const ProbeMark& mark) const {
  constexpr double kMinBox = 9, kArm = 8, kGap = 2;
  const ScreenRect cell = pixelRect(mark.pixel);
  const double x = cell.x + texel_ / 2, y = cell.y + texel_ / 2;
  const double half = std::max(texel_, kMinBox) / 2;
  const QRectF box(x - half, y - half, 2 * half, 2 * half);
  const QLineF arms[] = {{x - half - kArm, y, x - half, y},
                         {x + half, y, x + half + kArm, y},
                         {x, y - half - kArm, x, y - half},
                         {x, y + half, x, y + half + kArm}};
  painter.setRenderHint(QPainter::Antialiasing);
  // On pictures the brighter accent with its outline shows on any color, whatever the theme.
  const QColor color = mark.isActive ? darkColors().accent : QColor(255, 255, 255);
  const Qt::PenStyle line = mark.state == ProbeState::Hidden ? Qt::DotLine : Qt::SolidLine;
  for (const auto& [ink, width] : {std::pair(QColor(0, 0, 0), 3.5), std::pair(color, 1.5)}) {
    painter.setPen(QPen(ink, width, line, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(Qt::NoBrush);
    if (mark.followsSurface && texel_ < kMinBox)
      painter.drawEllipse(box);
    else
      painter.drawRect(box);
    painter.drawLines(arms, 4);
  }
  QFont font = secondaryFont();
  font.setBold(mark.isActive);
  drawOutlined(painter, {x + half + kGap, y - half - kGap}, font, QString::number(mark.number));
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void PixelOverlay::paintPath(QPainter& painter, const std::vector<PathPlace>& path) const {
  constexpr double kThinnest = 1.5, kThickest = 5.0; // radii of dots
  if (path.size() < 2) return;
  double heaviest = 0.0;
  QPolygonF line;
  for (const PathPlace& place : path) {
    const glm::dvec2 at = screenFromPicture(transform_, place.at) / pixelRatio_;
    line << QPointF(at.x, at.y);
    heaviest = std::max(heaviest, std::fabs(place.weight));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [ink, extra] : {std::pair(QColor(0, 0, 0), 1.0), std::pair(darkColors().accent, 0.0)}) {
    painter.setPen(QPen(ink, 1.0 + 2.0 * extra, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    for (qsizetype index = 1; index < line.size(); ++index) { // the first is the probe's
      const double share = std::fabs(path[static_cast<std::size_t>(index)].weight) / heaviest;
      const double radius = extra + std::max(kThinnest, kThickest * std::sqrt(share));
      painter.drawEllipse(line[index], radius, radius);
    }
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void PixelOverlay::paintFrame(QPainter& painter, const gl::Rect& box) const {
  constexpr double kLongestArm = 14, kGap = 2;
  const ScreenRect first = pixelRect({box.x, box.y});
  const QRectF rect(first.x - kGap, first.y - kGap, box.width * texel_ + 2 * kGap,
                    box.height * texel_ + 2 * kGap);
  const double across = std::min(kLongestArm, rect.width() / 3),
               down = std::min(kLongestArm, rect.height() / 3);
  QPainterPath corners;
  for (const auto& [x, inward] : {std::pair(rect.left(), across), std::pair(rect.right(), -across)})
    for (const auto& [y, below] : {std::pair(rect.top(), down), std::pair(rect.bottom(), -down)}) {
      corners.moveTo(x + inward, y);
      corners.lineTo(x, y);
      corners.lineTo(x, y + below);
    }
  for (const auto& [color, width] : {std::pair(QColor(0, 0, 0), 3.5), std::pair(darkColors().accent, 1.5)}) {
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(corners);
  }
}

void PixelOverlay::paintRegion(QPainter& painter, const gl::Rect& box, const QColor& color) const {
  const ScreenRect first = pixelRect({box.x, box.y});
  const QRectF rect(first.x, first.y, box.width * texel_, box.height * texel_);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 3.0, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
  painter.drawRect(rect);
  painter.setPen(QPen(color, 1.5, Qt::DashLine, Qt::FlatCap, Qt::MiterJoin));
  painter.drawRect(rect);
}

void PixelOverlay::paintOutline(QPainter& painter, const std::vector<doctor::OutlineEdge>& edges) const {
  QList<QLineF> lines;
  lines.reserve(static_cast<qsizetype>(edges.size()));
  for (const doctor::OutlineEdge& edge : edges) {
    const ScreenRect from = pixelRect(edge.from), to = pixelRect(edge.to);
    lines.push_back({from.x, from.y, to.x, to.y});
  }
  for (const QPen& pen : {QPen(Qt::black, 3.0, Qt::SolidLine, Qt::SquareCap),
                          QPen(darkColors().caution, 1.5, Qt::SolidLine, Qt::SquareCap)}) {
    painter.setPen(pen);
    painter.drawLines(lines);
  }
}

} // namespace taa::app
