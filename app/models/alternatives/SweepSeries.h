// What was measured of settings that are compared: means, curves over frames, the trade-off of two metrics.
#pragma once

#include "app/models/Curve.h"
#include "core/sweep/MetricsOfFrames.h"

#include <QColor>
#include <QPointF>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::app {

/// One of some settings by two numbers.
struct ScatterPoint {
  std::size_t index = 0; ///< of the settings
  QString name;
  QColor color;
  QPointF value;
  bool isOnFront = false;
};

class SweepSeries {
 public:
  /// Forgets what was known.
  void begin(std::vector<QString> names, std::vector<Metric> metrics);
  void add(std::size_t index, LaneMetrics frames);

  const std::vector<Metric>& metrics() const { return metrics_; }
  std::size_t count() const { return entries_.size(); }
  std::size_t measuredCount() const;
  const QString& name(std::size_t index) const { return entries_[index].name; }
  bool isMeasured(std::size_t index) const { return !entries_[index].frames.empty(); }
  /// Over the frames that have it.
  std::optional<double> mean(std::size_t index, Metric metric) const;

  /// Over frames, of those that are measured; what is not known of a frame is a gap.
  std::vector<Curve> curves(Metric metric) const;
  /// Means of those that have both, with the Pareto front: less of both is better, or more where the metric
  /// says so.
  std::vector<ScatterPoint> tradeOff(Metric x, Metric y) const;
  /// A line for each of those that are measured; exact means, fields as RFC 4180 has them.
  QString csv() const;

 private:
  struct Entry {
    QString name;
    LaneMetrics frames;
  };
  std::vector<Metric> metrics_;
  std::vector<Entry> entries_;
};

} // namespace taa::app
