// Colors of data as lines and marks on a panel: readable on its ground in both themes.
#pragma once

#include <QColor>

namespace taa::app {

struct ThemeColors;

/// Of a color of the palette (curveColor): as light as it takes to stand out from panels of the theme by
/// 3 : 1, as WCAG 2.2 asks of graphics (1.4.11). What is lighter stays lighter, so that colors that differ in
/// lightness alone to an eye still do.
QColor onPanel(const QColor& color, const ThemeColors& colors);

/// Of two opaque colors, 1 to 21 (WCAG 2.2).
double contrastOf(const QColor& a, const QColor& b);

} // namespace taa::app
