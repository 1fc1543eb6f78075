// The line between the two sides of a view, and the labels that say which is which.
#pragma once

#include <QPointF>
#include <QRect>
#include <QString>

class QFontMetrics;
class QPainter;

namespace taa::app {

struct ThemeColors;

/// Logical pixels from the line within which the mouse takes it.
inline constexpr int kWipeReach = 5;

/// Where the line lies: `share` of the width, in whole pixels.
int wipePosition(double share, int width);
/// The share that puts the line at `x`; it stays inside.
double wipeShare(double x, int width);

/// Draws the line with its handle.
void paintWipe(QPainter& painter, const QRect& area, int position);
/// What is said of two sides in `room` px each: where that is too little, only what they do not have in
/// common.
struct SideTexts {
  QString first, other;
};
SideTexts fittingTexts(const SideTexts& whole, const QFontMetrics& metrics, int room);
/// Writes what a side shows at the upper left, or at the upper right of `area`; cut where it is narrow.
void paintSideLabel(QPainter& painter, const QRect& area, const QString& text, bool atRight,
                    const ThemeColors& colors);

} // namespace taa::app
