#include "app/window/PlotPresenter.h"

#include "app/models/AlphaSeries.h"
#include "app/panels/JitterPanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/session/Session.h"
#include "app/style/Text.h"
#include "app/views/timeline/Timeline.h"
#include "core/render/CaptureFacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace taa::app {

bool MetricSeries::setShotVersion(std::uint64_t shotVersion) {
  if (shotVersion == shotVersion_) return false;
  shotVersion_ = shotVersion;
  known_.clear();
  return true;
}

bool MetricSeries::add(const FrameMetrics& metrics) {
  if (metrics.lane != 0 || !metrics.exact || metrics.shotVersion < shotVersion_) return false;
  setShotVersion(metrics.shotVersion);
  // What a delivery leaves out, because nobody asked for it or a reference is missing, stays known.
  FrameMetrics& known = known_[metrics.frame];
  for (std::size_t index = 0; index < metrics.values.size(); ++index)
    if (metrics.values[index]) known.values[index] = metrics.values[index];
  return true;
}

TimelineStrip MetricSeries::strip(Metric metric, int frameCount) const {
  const MetricInfo& info = metricInfo(metric);
  TimelineStrip strip{
      qtext(info.label), info.unit.empty() ? QString() : QLatin1Char(' ') + qtext(info.unit), {}};
  strip.values.resize(static_cast<std::size_t>(frameCount));
  for (const auto& [frame, metrics] : known_) {
    const std::optional<double> value = metrics.at(metric);
    if (frame < frameCount && value && std::isfinite(*value))
      strip.values[static_cast<std::size_t>(frame)] = value;
  }
  return strip;
}

PlotPresenter::PlotPresenter(Session& session, const Panels& to) : session_(session), to_(to) {
  connectTraces();
  connectMetrics();
  connectRuler();
}

void PlotPresenter::connectTraces() {
  connect(&to_.jitter, &JitterPanel::seekRequested, &session_, &Session::seek);
  connect(&to_.weights, &WeightsPanel::seekRequested, &session_, &Session::seek);
  connect(&to_.plots, &PlotsPanel::seekRequested, &session_, &Session::seek);
  connect(&to_.plots, &PlotsPanel::fillRequested, this, [this](int first, int last) {
    session_.post(request::FillTraces{first, last});
  });
  connect(&to_.jitter, &JitterPanel::shownChanged, this, &PlotPresenter::showTraces);
  connect(&to_.weights, &WeightsPanel::shownChanged, this, &PlotPresenter::showTraces);
  connect(&to_.plots, &PlotsPanel::shownChanged, this, &PlotPresenter::showTraces);
  session_.onArrival<TraceDelivery>(&to_.plots, &PlotsPanel::addSample);
  session_.onArrival<TraceDelivery>(this, [this](const TraceDelivery& trace) {
    if (trace.frame <= session_.status().info.frame) showAlphas(); // also one that was filled in
  });
  connect(&session_.probes(), &ProbeChoices::changed, this, &PlotPresenter::showTraces);
  connect(&session_, &Session::workChanged, this,
          [this] { to_.plots.setFilling(session_.work().kind == WorkKind::Traces); });
}

// Plots and timeline have one axis: the same frames at the same places.
void PlotPresenter::connectRuler() {
  Timeline* ruler = to_.timeline.timeline();
  connect(ruler, &Timeline::moved, this, &PlotPresenter::placeAboveRuler);
  connect(ruler, &Timeline::shownChanged, &to_.plots, &PlotsPanel::setShown);
  connect(&to_.plots, &PlotsPanel::framesShown, this, [this, ruler](const Span& frames) {
    ruler->setShown(frames);
    fillInIdleTime();
  });
}

void PlotPresenter::placeAboveRuler() {
  const Timeline& ruler = *to_.timeline.timeline();
  const TimelineScale scale = ruler.scale();
  const double left = ruler.mapToGlobal(QPoint(0, 0)).x() + scale.left;
  to_.plots.setRuler({left, left + scale.width});
}

// What is on show of the active shot, as long as somebody looks at curves over all of it.
void PlotPresenter::fillInIdleTime() {
  const Status& status = session_.status();
  if (!to_.plots.isVisible() || session_.probes().all().empty() || status.frameCount == 0) return;
  const Asked asked{status.shotVersion, session_.probes().all(), to_.plots.shown()};
  if (asked == asked_) return;
  asked_ = asked;
  session_.post(request::TraceInIdleTime{static_cast<int>(std::floor(asked.frames.low)),
                                         static_cast<int>(std::ceil(asked.frames.high))});
}

void PlotPresenter::connectMetrics() {
  connect(&to_.timeline, &TimelinePanel::metricChosen, this, [this](std::optional<Metric> metric) {
    session_.post(request::SetMetrics{metric ? std::vector<Metric>{*metric} : std::vector<Metric>()});
    showMetric();
  });
  session_.onArrival<FrameMetrics>(this, [this](const FrameMetrics& metrics) {
    if (metrics_.add(metrics)) showMetric();
  });
}

// Probes are followed over frames as long as somebody looks.
void PlotPresenter::showTraces() {
  session_.setTracing(to_.plots.isVisible() || to_.jitter.isVisible() || to_.weights.isVisible());
  to_.plots.setProbes(session_.probes().all(), session_.probes().active());
  placeAboveRuler();
  showAlphas();
}

// What jitter and weights are drawn from.
void PlotPresenter::showAlphas() {
  to_.plots.setStatus(session_.status());
  fillInIdleTime();
  if (metrics_.setShotVersion(session_.status().shotVersion)) showMetric();
  if (!to_.jitter.isVisible() && !to_.weights.isVisible()) return;
  const Status& status = session_.status();
  AlphaSeries series;
  series.settings = session_.presets().settings();
  series.frame = status.info.frame;
  if (status.capture) {
    series.settings = settingsOn(*status.capture, series.settings);
    const auto& all = status.capture->jitterPx;
    series.jitterPx.assign(all.begin(), all.begin() + status.capture->jitterPeriod);
  }
  if (status.settings.jitter.sequence == JitterSequence::Perpendicular)
    series.jitterWay = status.info.jitterWay;
  for (const std::vector<int>* starts : {&status.cuts, &status.restarts})
    for (const int start : *starts)
      if (start <= series.frame) series.start = std::max(series.start, start);
  if (const int active = session_.probes().active(); active >= 0) {
    const Probe& probe = session_.probes().all()[static_cast<std::size_t>(active)];
    if (const PixelTrace* trace = to_.plots.traceOf(probe))
      series.measured = alphasUpTo(*trace, series.frame, kMaxFramesBack);
    if (const auto pixel = session_.probes().pixel())
      series.place = QStringLiteral("(%1, %2)").arg(pixel->x).arg(pixel->y);
  }
  to_.jitter.setSeries(series);
  to_.weights.setSeries(series);
}

void PlotPresenter::showMetric() {
  if (const auto metric = to_.timeline.stripMetric())
    to_.timeline.setStrip(metrics_.strip(*metric, session_.status().frameCount));
}

} // namespace taa::app
