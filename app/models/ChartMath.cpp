#include "app/models/ChartMath.h"

#include <algorithm>
#include <cmath>

namespace taa::app {

double roundStep(double length, int most) {
  const double least = std::max(length, 1e-30) / std::max(1, most);
  const double power = std::pow(10.0, std::floor(std::log10(least) + 1e-9));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= least * (1.0 - 1e-9)) return digit * power;
  return 10.0 * power;
}

Span roundedSpan(const Span& values, int maxSteps) {
  Span span = values;
  if (span.low > 0.0 && span.low < 0.6 * span.high) span.low = 0.0;
  if (span.high < 0.0 && span.high > 0.6 * span.low) span.high = 0.0;
  if (span.length() <= 1e-6 * std::max(std::abs(span.low), std::abs(span.high))) { // one value
    const double half = 0.5 * std::abs(span.high);
    span = half == 0.0 ? Span{0.0, 1.0} : Span{span.low - half, span.high + half};
  }
  const double step = roundStep(span.length(), maxSteps);
  return {std::floor(span.low / step + 1e-9) * step, std::ceil(span.high / step - 1e-9) * step};
}

std::vector<double> ticksOf(const Span& range, double step) {
  std::vector<double> ticks;
  if (!(step > 0.0)) return ticks;
  const double last = std::floor(range.high / step + 1e-9);
  for (double index = std::ceil(range.low / step - 1e-9); index <= last; ++index)
    ticks.push_back(index * step + 0.0); // without the sign of a zero
  return ticks;
}

double tickStep(const Span& range, int most) {
  constexpr int kTries = 8; // with as many more steps a range that is not empty has two of them
  double step = roundStep(range.length(), most);
  for (int more = 1; more < kTries && ticksOf(range, step).size() < 2; ++more)
    step = roundStep(range.length(), most + more);
  return step;
}

Span zoomed(const Span& shown, const Span& all, double factor, double center, double least) {
  const double length = std::clamp(shown.length() / factor, std::min(least, all.length()), all.length());
  const double share = shown.length() > 0.0 ? (center - shown.low) / shown.length() : 0.5;
  const double low = std::clamp(center - share * length, all.low, all.high - length);
  return {low, low + length};
}

Span moved(const Span& shown, const Span& all, double distance) {
  const double low = std::clamp(shown.low + distance, all.low, std::max(all.low, all.high - shown.length()));
  return {low, low + shown.length()};
}

std::vector<std::vector<QPointF>> runsOf(const std::vector<QPointF>& points) {
  std::vector<std::vector<QPointF>> runs;
  bool isOpen = false;
  for (const QPointF& point : points) {
    const bool isValue = std::isfinite(point.y());
    if (isValue && !isOpen) runs.emplace_back();
    if (isValue) runs.back().push_back(point);
    isOpen = isValue;
  }
  return runs;
}

std::optional<double> valueAt(const std::vector<QPointF>& points, double x) {
  const auto found = std::ranges::lower_bound(points, x, {}, [](const QPointF& point) { return point.x(); });
  if (found == points.end() || found->x() != x || !std::isfinite(found->y())) return {};
  return found->y();
}

std::optional<Span> valueSpan(const std::vector<QPointF>& points, const Span& shown) {
  std::optional<Span> span;
  for (const QPointF& point : points) {
    if (point.x() < shown.low || point.x() > shown.high || !std::isfinite(point.y())) continue;
    if (!span) span = Span{point.y(), point.y()};
    span->low = std::min(span->low, point.y());
    span->high = std::max(span->high, point.y());
  }
  return span;
}

std::vector<LegendPlace> placeLegend(const std::vector<double>& widths, double start, double firstEnd,
                                     double end) {
  std::vector<LegendPlace> places;
  LegendPlace next{0, start};
  for (const double width : widths) {
    const bool isFirstOfLine = places.empty() || places.back().line != next.line;
    if (!isFirstOfLine && next.left + width > (next.line == 0 ? firstEnd : end)) next = {next.line + 1, 0.0};
    places.push_back(next);
    next.left += width;
  }
  return places;
}

} // namespace taa::app
