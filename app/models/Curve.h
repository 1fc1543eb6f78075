// What a chart draws: curves and marks, as data.
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>

#include <cstdint>
#include <vector>

namespace taa::app {

struct Curve {
  QString name;
  QColor color;
  Qt::PenStyle dash = Qt::SolidLine;
  std::vector<QPointF> points; ///< rising in x; y NaN: a gap
  QString shortName{};         ///< where names of all do not fit in a line; empty: there is none
};

/// A color of the palette that is safe for color-blind eyes.
QColor curveColor(int place);

/// Drawn at the bottom of the chart: × where history was rejected, a line where the shot is cut.
enum class MarkKind : std::uint8_t { Reject, Cut };
struct ChartMark {
  double x = 0.0;
  MarkKind kind = MarkKind::Cut;
  QString text;
  bool operator==(const ChartMark&) const = default;
};

} // namespace taa::app
