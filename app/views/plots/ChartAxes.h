// The axes of a chart: where its plot is, its grid and its labels.
#pragma once

#include "app/models/ChartMath.h"

#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace taa::app {

struct ThemeColors;

struct ChartAxis {
  Span range;
  double step = 1.0; ///< between ticks, which are multiples of it
  QString title{};   ///< empty: none
};

struct ChartLabel {
  QString text;
  QRectF place;
};

/// Laid out once for a size and ranges, then asked and painted.
class ChartAxes {
 public:
  /// `area`: what plot and labels share. `edges`: where the plot begins and ends from left to right, of a
  /// chart below or above which another one has the labels of x; none: it makes room for its own labels.
  void layOut(const ChartAxis& x, const ChartAxis& y, const QRectF& area, std::optional<Span> edges = {});
  const ChartAxis& x() const { return x_; }
  const ChartAxis& y() const { return y_; }
  /// Inside the labels.
  const QRectF& plot() const { return plot_; }
  const std::vector<ChartLabel>& labels() const { return labels_; }
  QPointF pointOf(const QPointF& value) const;
  void paint(QPainter& painter, const ThemeColors& colors) const;

 private:
  void labelRows();
  void labelColumns();

  ChartAxis x_, y_;
  QRectF area_, plot_;
  std::vector<ChartLabel> labels_;
};

} // namespace taa::app
