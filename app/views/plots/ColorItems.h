// What the color space plot shows of a pixel: points and lines, their names, marks and colors.
#pragma once

#include "app/models/ColorSpaceMath.h"
#include "app/style/Theme.h"

#include <QColor>
#include <QString>

#include <vector>

namespace taa::app {

enum class PlotShape { Dot, Ring, Diamond, FilledDiamond, Square, Cross, Dotted, Dashed, Solid, Thin, Arrow };

/// What the plot shows one of: its points, lines, and their styles.
struct PlotItem {
  PlotShape shape;
  QString label;
  QColor color;
  std::vector<glm::vec3> points{};
  std::vector<Segment> lines{};
  std::vector<QColor> fills{};  ///< of the points; empty: they are as the others of their shape
  std::vector<QString> names{}; ///< of the points, beside them; empty: all have the label
};

std::vector<PlotItem> colorItems(const ColorScene& scene, const ThemeColors& colors);

} // namespace taa::app
