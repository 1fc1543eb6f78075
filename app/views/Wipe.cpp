#include "app/views/Wipe.h"

#include "app/style/Theme.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace taa::app {

int wipePosition(double share, int width) {
  return static_cast<int>(std::lround(share * width));
}

double wipeShare(double x, int width) {
  return width > 0 ? std::clamp(x / width, 0.0, 1.0) : 0.5;
}

void paintWipe(QPainter& painter, const QRect& area, int position) {
  // Light between dark, so that it shows on any picture.
  painter.fillRect(QRect(position - 2, area.top(), 3, area.height()), QColor(0, 0, 0, 150));
  painter.fillRect(QRect(position - 1, area.top(), 1, area.height()), QColor(255, 255, 255));
  const QPointF middle(position - 0.5, area.center().y());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(0, 0, 0, 200), 1));
  painter.setBrush(QColor(255, 255, 255));
  constexpr double kNear = 4, kFar = 10, kHalf = 5;
  for (const double side : {-1.0, 1.0})
    painter.drawPolygon(QPolygonF({middle + QPointF(side * kFar, 0), middle + QPointF(side * kNear, -kHalf),
                                   middle + QPointF(side * kNear, kHalf)}));
  painter.setRenderHint(QPainter::Antialiasing, false);
}

SideTexts fittingTexts(const SideTexts& whole, const QFontMetrics& metrics, int room) {
  const auto widthOf = [&](const QString& text) { return metrics.horizontalAdvance(text); };
  if (std::max(widthOf(whole.first), widthOf(whole.other)) <= room) return whole;
  const QString between = QStringLiteral(" · ");
  const QStringList first = whole.first.split(between), other = whole.other.split(between);
  QStringList ownOfFirst, ownOfOther;
  for (const QString& part : first)
    if (!other.contains(part)) ownOfFirst << part;
  for (const QString& part : other)
    if (!first.contains(part)) ownOfOther << part;
  if (ownOfFirst.isEmpty() || ownOfOther.isEmpty()) return whole;
  return {ownOfFirst.join(between), ownOfOther.join(between)};
}

void paintSideLabel(QPainter& painter, const QRect& area, const QString& text, bool atRight,
                    const ThemeColors& colors) {
  constexpr int kHeight = 20, kMinWidth = 40;
  const QFont font = secondaryFont();
  const QFontMetrics metrics(font);
  const int room = area.width() - 4 * kUnit;
  if (room < scaled(kMinWidth)) return;
  const QString shown = metrics.elidedText(text, Qt::ElideMiddle, room);
  const int width = metrics.horizontalAdvance(shown) + 3 * kUnit;
  const QRect box(atRight ? area.right() - width - kUnit + 1 : area.left() + kUnit, area.top() + kUnit, width,
                  scaled(kHeight));
  QColor ground = colors.panel;
  ground.setAlpha(232);
  painter.fillRect(box, ground);
  painter.setFont(font);
  painter.setPen(colors.text);
  painter.drawText(box, Qt::AlignCenter, shown);
}

} // namespace taa::app
