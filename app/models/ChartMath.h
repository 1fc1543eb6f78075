// The arithmetic of charts: round scales, zooming, values between clicks. No widgets.
#pragma once

#include <QPointF>

#include <optional>
#include <vector>

namespace taa::app {

struct Span {
  double low = 0.0, high = 1.0;
  double length() const { return high - low; }
  bool operator==(const Span&) const = default;
};

/// 1, 2 or 5 times a power of ten, so that `length` has at most `most` such steps.
double roundStep(double length, int most);
/// A range around values with round ends: from 0 on where they come near it; a point gets some height.
Span roundedSpan(const Span& values, int maxSteps);
/// roundStep() of a range, less where fewer than two multiples of it would lie within.
double tickStep(const Span& range, int most);
/// The multiples of `step` within `range`; none where the step is no number above 0.
std::vector<double> ticksOf(const Span& range, double step);
/// `shown` made smaller by `factor` (> 1: zooms in) around `center`, inside `all`, no shorter than `least`.
Span zoomed(const Span& shown, const Span& all, double factor, double center, double least);
/// `shown` moved by `distance`, inside `all`.
Span moved(const Span& shown, const Span& all, double distance);

/// Runs of points between gaps (y is NaN).
std::vector<std::vector<QPointF>> runsOf(const std::vector<QPointF>& points);
/// y at exactly x; points rise in x. Nothing in a gap.
std::optional<double> valueAt(const std::vector<QPointF>& points, double x);
/// Least and greatest finite y of the points with x inside `shown`.
std::optional<Span> valueSpan(const std::vector<QPointF>& points, const Span& shown);

struct LegendPlace {
  int line = 0;
  double left = 0.0;
  bool operator==(const LegendPlace&) const = default;
};
/// Places entries of these widths one after another: in the first line from `start` to `firstEnd`, in those
/// below it from 0 to `end`. Each line has one entry at least.
std::vector<LegendPlace> placeLegend(const std::vector<double>& widths, double start, double firstEnd,
                                     double end);

} // namespace taa::app
