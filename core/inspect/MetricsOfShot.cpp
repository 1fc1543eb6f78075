#include "core/inspect/MetricsOfShot.h"

#include "core/gl/PassTimer.h"
#include "core/inspect/FlickerOfShot.h"
#include "core/inspect/ReferenceOfShot.h"
#include "core/inspect/Views.h"
#include "core/measure/MetricCursor.h"
#include "core/measure/Profiler.h"
#include "core/replay/ShotPlayer.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

namespace {

bool isAgainstReference(Metric metric) {
  return metricInfo(metric).needsReference;
}

/// The row of the frame alone that a metric is made of.
std::optional<IntermediateId> rowOf(Metric metric) {
  const MetricInfo& info = metricInfo(metric);
  return info.isOverTime ? std::nullopt : findIntermediate(info.row);
}

/// The rows that metrics are made of.
std::vector<IntermediateId> rowsOf(const std::vector<Metric>& wanted) {
  std::vector<IntermediateId> ids;
  for (const Metric metric : wanted)
    if (const auto id = rowOf(metric)) ids.push_back(*id);
  return inTableOrder(std::move(ids));
}

void addRowMetrics(FrameMetrics& metrics, const std::vector<Metric>& wanted,
                   const std::vector<IntermediateId>& ids, const std::vector<Image>& rows) {
  for (const Metric metric : wanted)
    if (const auto id = rowOf(metric))
      metrics.at(metric) =
          metricOf(metric, rows[static_cast<std::size_t>(std::ranges::find(ids, *id) - ids.begin())]);
}

void addError(FrameMetrics& metrics, const std::vector<Metric>& wanted, const PictureError& error) {
  for (const Metric metric : wanted) {
    if (metric == Metric::Rmse) metrics.at(metric) = error.rmse;
    if (metric == Metric::Psnr) metrics.at(metric) = error.psnr;
    if (metric == Metric::RmseLinear) metrics.at(metric) = error.rmseLinear;
  }
}

void addFlicker(FrameMetrics& metrics, const std::vector<Metric>& wanted, const FlickerMaps& maps,
                int samples) {
  metrics.flickerSamples = samples;
  for (const Metric metric : wanted) {
    if (metric == Metric::Deviation) metrics.at(metric) = meanOverTime(maps.deviation, maps.frames);
    if (metric == Metric::Flicker && samples > 0)
      metrics.at(metric) = meanOverTime(maps.flicker, maps.frames);
  }
}

} // namespace

MetricsOfShot::MetricsOfShot(ShotPlayer& player, Views& views, ReferenceOfShot& reference,
                             FlickerOfShot& flicker, const References& references)
    : player_(player), views_(views), reference_(reference), flicker_(flicker), references_(references) {}

FrameMetrics MetricsOfShot::measure(const std::vector<Metric>& wanted, int lane) {
  FrameMetrics metrics{
      .frame = player_.shown().frame, .lane = lane, .exact = player_.lane(lane).exact, .values = {}};
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  addRowMetrics(metrics, wanted, ids, views_.images(ids, lane));
  if (const std::optional<int> samples = flicker_.samples(lane))
    addFlicker(metrics, wanted, flicker_.maps(lane), *samples);
  ReferenceRows* const rows =
      std::ranges::any_of(wanted, isAgainstReference) ? reference_.rows(lane) : nullptr;
  if (!rows) return metrics;
  metrics.referenceSamples = rows->samples();
  addError(metrics, wanted, rows->error());
  return metrics;
}

FrameMetrics MetricsOfShot::measureFrame(int frame, const std::vector<Metric>& wanted, int samples,
                                         MetricCursor& cursor, const Progress& progress) {
  const ShotState state = player_.onlyLane(0);
  FrameMaker& maker = player_.maker();
  FrameMetrics metrics{.frame = frame, .values = {}};
  const bool isCompared = std::ranges::any_of(wanted, isAgainstReference);
  const bool isOverTime =
      std::ranges::any_of(wanted, [](Metric metric) { return metricInfo(metric).isOverTime; });
  cursor.references.setBudget(0); // the one that is being drawn
  const FlickerNeed need{0, frame, std::ranges::count(wanted, Metric::Flicker) > 0 ? samples : 0};
  // First: it is what takes long, and what is there of it stays.
  if (isOverTime) flicker_.fill(cursor.flicker, cursor.references, need, progress);
  const ReferenceKey compared{referenceRequest(state.request(0)), frame};
  const ReferencePicture* reference =
      isCompared ? &cursor.references.foundOrDrawn(*state.frames, compared, samples, references_, progress)
                 : nullptr;
  const gl::PassGroup group(pass_group::kExposure);
  ShownFrame made = player_.makeInBackground(frame, cursor.trace, progress);
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  std::vector<Image> rows;
  if (!ids.empty()) {
    const Exposure exposure = maker.expose(state, made, ids, 0);
    for (const IntermediateId id : ids) rows.push_back(exposure.image(id));
  }
  addRowMetrics(metrics, wanted, ids, rows);
  Image output;
  if (reference || isOverTime)
    output = maker.expose(state, made, {IntermediateId::output}, 0).image(IntermediateId::output);
  maker.recycle(std::move(made));
  if (reference) {
    metrics.referenceSamples = samples;
    addError(metrics, wanted, pictureError(output, reference->mean()));
  }
  if (isOverTime) {
    cursor.flicker.frames.at(frame).shown = shownColors(output);
    addFlicker(metrics, wanted, flicker_.mapsOf(cursor.flicker, frame, progress), need.samples);
  }
  return metrics;
}

} // namespace taa
