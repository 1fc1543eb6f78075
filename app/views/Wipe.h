// The line between the two sides of a view, and the labels that say which is which.
#pragma once

#include <QPointF>
#include <QRect>
#include <QString>

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
/// Writes what a side shows at the upper left, or at the upper right of `area`; cut where it is narrow.
void paintSideLabel(QPainter& painter, const QRect& area, const QString& text, bool atRight,
                    const ThemeColors& colors);

} // namespace taa::app
