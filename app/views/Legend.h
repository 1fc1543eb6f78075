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
                 const ThemeColors& colors, const QString& note = {});

} // namespace taa::app
