// What was measured of settings that are compared, on one scene or several: means, curves over frames, the
// trade-off of two metrics.
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
  std::size_t index = 0; ///< of the entry
  QString name;
  QColor color;
  QPointF value;
  bool isOnFront = false; ///< of its scene
  std::size_t scene = 0;  ///< the same sign and front for those of one
  QString sceneName{};    ///< empty: there is only one
};

/// An entry is settings on a scene: scenes slowest.
class SweepSeries {
 public:
  /// Forgets what was known. Expects a scene at least where there are settings.
  void begin(std::vector<QString> settings, std::vector<QString> scenes, std::vector<Metric> metrics);
  void add(std::size_t index, LaneMetrics frames);

  const std::vector<Metric>& metrics() const { return metrics_; }
  std::size_t count() const { return frames_.size(); }
  std::size_t measuredCount() const;
  std::size_t sceneCount() const { return scenes_.size(); }
  const QString& sceneName(std::size_t scene) const { return scenes_[scene]; }
  std::size_t sceneOf(std::size_t index) const { return index / settings_.size(); }
  std::size_t settingsOf(std::size_t index) const { return index % settings_.size(); }
  /// Of its settings alone.
  const QString& name(std::size_t index) const { return settings_[settingsOf(index)]; }
  bool isMeasured(std::size_t index) const { return !frames_[index].empty(); }
  /// Over the frames that have it.
  std::optional<double> mean(std::size_t index, Metric metric) const;

  /// Over frames, of those that are measured, of one scene or, without, of all; what is not known of a frame
  /// is a gap. The same settings have the same color. Of RMSE the line of supersampling comes with each scene
  /// of which it is known.
  std::vector<Curve> curves(Metric metric, std::optional<std::size_t> scene = {}) const;
  /// Means of those that have both, with the Pareto front of each scene: less of both is better, or more
  /// where the metric says so. Numbers of different scenes compare no settings.
  std::vector<ScatterPoint> tradeOff(Metric x, Metric y, std::optional<std::size_t> scene = {}) const;
  /// A line for each of those that are measured; exact means, fields as RFC 4180 has them. Of several scenes
  /// each line names its own.
  QString csv() const;

 private:
  QString fullName(std::size_t index) const;
  QColor colorOf(std::size_t index) const;
  Curve curveOf(std::size_t index, Metric metric) const;

  std::vector<Metric> metrics_;
  std::vector<QString> settings_, scenes_;
  std::vector<LaneMetrics> frames_; ///< of each entry
};

} // namespace taa::app
