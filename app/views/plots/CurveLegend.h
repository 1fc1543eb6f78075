// The lines above the curves of a chart, or beside them: their names, dashes and values.
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
  /// of the first line, or of another where a long name takes that whole.
  void layOut(const QString& title, const std::vector<Curve>& curves, double width, double placeWidth);
  /// Places them in lines right of the plot, from `left` to `right`; the title stands left of it and ends at
  /// `titleEnd`.
  void layOutBeside(const std::vector<Curve>& curves, double titleEnd, double left, double right);
  /// Of the lines above the plot; 0 where they stand beside it.
  double height() const;
  int lines() const { return lines_; }
  bool isShortened() const { return isShortened_; }

  /// `place`: where the values at `x` are from.
  void paint(QPainter& painter, const ThemeColors& colors, const QString& title,
             const std::vector<Curve>& curves, std::optional<double> x, const QString& place) const;

 private:
  int lineWithRoom(const std::vector<double>& widths, double start, double wanted) const;
  std::vector<double> widthsOf(const std::vector<Curve>& curves) const;
  void paintEntry(QPainter& painter, const ThemeColors& colors, const Curve& curve, const LegendPlace& place,
                  std::optional<double> x) const;
  const QString& nameOf(const Curve& curve) const;

  std::vector<LegendPlace> places_;
  double left_ = 0.0, width_ = 0.0;
  std::optional<double> titleEnd_; ///< only beside the plot
  int lines_ = 1, placeLine_ = 0;  ///< of where the values are from
  bool isShortened_ = false;
};

} // namespace taa::app
