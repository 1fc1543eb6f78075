// What plots, jitter, weights and the timeline's strip are drawn from: it follows the probes over frames for
// as long as somebody looks.
#pragma once

#include "app/models/ChartMath.h"
#include "app/models/TimelineStrip.h"

#include "core/measure/Metrics.h"
#include "core/probe/Probe.h"

#include <QObject>

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace taa {
struct TraceDelivery;
}

namespace taa::app {

class JitterPanel;
class PlotsPanel;
class Session;
class TimelinePanel;
class WeightsPanel;

/// A metric of each frame of the shot, as far as it was measured, as long as it is true.
class MetricSeries {
 public:
  /// Drops all that is known when frames are a function of something else now (Status::shotVersion); true: so
  /// it was.
  bool setShotVersion(std::uint64_t shotVersion);
  /// Takes what is exact, of the first lane; false: nothing of it.
  bool add(const FrameMetrics& metrics);
  TimelineStrip strip(Metric metric, int frameCount) const;

 private:
  std::uint64_t shotVersion_ = 0;
  std::map<int, FrameMetrics> known_;
};

class PlotPresenter : public QObject {
  Q_OBJECT
 public:
  struct Panels {
    PlotsPanel& plots;
    JitterPanel& jitter;
    WeightsPanel& weights;
    TimelinePanel& timeline;
  };
  PlotPresenter(Session& session, const Panels& to);

  /// To be called when status or settings have changed, after the timeline knows of it.
  void showAlphas();

 private:
  void connectTraces();
  void connectMetrics();
  void connectRuler();
  void showTraces();
  void showMetric();
  void placeAboveRuler();
  void fillInIdleTime();

  Session& session_;
  Panels to_;
  MetricSeries metrics_;
  /// What was asked for in idle time, so that it does not come again after somebody has stopped it.
  struct Asked {
    std::uint64_t shotVersion = 0;
    std::vector<Probe> probes;
    Span frames;
    bool operator==(const Asked&) const = default;
  };
  std::optional<Asked> asked_;
};

} // namespace taa::app
