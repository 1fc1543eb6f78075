// The strip inside the lower edge of a view: what is shown, in which range and colors.
#pragma once

#include "core/inspect/Visualizer.h"

#include <QRect>
#include <QString>

class QPainter;

namespace taa::app {

struct ThemeColors;

inline constexpr int kLegendHeight = 22;

/// Paints the strip into `strip` (logical pixels), `note` at its end.
void paintLegend(QPainter& painter, const QRect& strip, const Intermediate& row, const ViewStyle& style,
                 bool isDifference, const ThemeColors& colors, const QString& note = {});

/// Lines that what lies over the picture needs to be told.
int overlayLegendLines(const Intermediate& row, const ViewStyle& style);
/// Paints them upwards from `strip`, the lowest.
void paintOverlayLegend(QPainter& painter, QRect strip, const Intermediate& row, const ViewStyle& style,
                        const ThemeColors& colors);

} // namespace taa::app
