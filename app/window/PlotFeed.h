// What plots, jitter, weights and the timeline's strip are drawn from: it follows the probes over frames for
// as long as somebody looks.
#pragma once

#include "app/models/MetricSeries.h"

#include <QObject>

namespace taa {
struct TraceDelivery;
}

namespace taa::app {

class JitterPanel;
class PlotsPanel;
class Session;
class TimelinePanel;
class WeightsPanel;

class PlotFeed : public QObject {
  Q_OBJECT
 public:
  struct Panels {
    PlotsPanel& plots;
    JitterPanel& jitter;
    WeightsPanel& weights;
    TimelinePanel& timeline;
  };
  PlotFeed(Session& session, const Panels& to);

  /// To be called when status or settings have changed, after the timeline knows of it.
  void showAlphas();

 private:
  void connectTraces();
  void connectMetrics();
  void showTraces();
  void showMetric();

  Session& session_;
  Panels to_;
  MetricSeries metrics_;
};

} // namespace taa::app
