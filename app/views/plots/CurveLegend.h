// The lines above the curves of a chart: their names, dashes and values.
#pragma once

#include "app/models/ChartMath.h"
#include "app/models/Curve.h"

#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace taa::app {

struct ThemeColors;

/// Names are shortened before they take a second line; each value has room for any, so that nothing moves
/// while they change.
class CurveLegend {
 public:
  /// Places the curves in lines of `width`; `placeWidth` is kept for where the values are from, on the right
  /// of the first line.
  void layOut(const QString& title, const std::vector<Curve>& curves, double width, double placeWidth);
  double height() const;
  int lines() const { return lines_; }
  bool isShortened() const { return isShortened_; }

  /// `place`: where the values at `x` are from.
  void paint(QPainter& painter, const ThemeColors& colors, const QString& title,
             const std::vector<Curve>& curves, std::optional<double> x, const QString& place) const;

 private:
  std::vector<double> widthsOf(const std::vector<Curve>& curves) const;
  const QString& nameOf(const Curve& curve) const;

  std::vector<LegendPlace> places_;
  double width_ = 0.0;
  int lines_ = 1;
  bool isShortened_ = false;
};

} // namespace taa::app
