#include "core/inspect/MetricsOfShot.h"

#include "core/gl/PassTimer.h"
#include "core/inspect/MetricCursor.h"
#include "core/inspect/OverTimeOfShot.h"
#include "core/inspect/ReferenceOfShot.h"
#include "core/inspect/Views.h"
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

/// The row of the frame's own resolve that a metric is made of.
std::optional<IntermediateId> rowOf(Metric metric) {
  const std::optional<IntermediateId> row = findIntermediate(metricInfo(metric).row);
  return row && isOfReference(*row) ? std::nullopt : row;
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

void addCompared(FrameMetrics& metrics, const std::vector<Metric>& wanted, PictureComparison& compared,
                 const Progress& progress) {
  for (const Metric metric : wanted)
    if (isOfPictures(metric)) metrics.at(metric) = compared.metric(metric, progress);
}

/// What measures those of them that are over time.
std::vector<OverTime> kindsOf(const std::vector<Metric>& wanted) {
  std::vector<IntermediateId> rows;
  for (const Metric metric : wanted)
    if (metricInfo(metric).isOverTime) rows.push_back(intermediateNamed(metricInfo(metric).row));
  return kindsOverTime(rows);
}

/// Those that history can have of a frame, with its own.
int framesSinceStart(const ShotState& state, int frame) {
  int count = 1;
  for (; !startsHistory(state, frame); --frame) ++count;
  return count;
}

bool hasSupersampling(const std::vector<Metric>& wanted) {
  return std::ranges::find(wanted, Metric::Supersampling) != wanted.end();
}

/// Rows of a frame of one lane, in the order of the table.
RowImages exposed(FrameMaker& maker, const ShotState& state, ShownFrame& made,
                  const std::vector<IntermediateId>& ids) {
  RowImages images;
  if (ids.empty()) return images;
  const ExposedRows exposedRows = maker.expose(state, made, ids, 0);
  for (const IntermediateId id : ids) images.emplace(id, exposedRows.image(id));
  return images;
}

void addOverTime(FrameMetrics& metrics, const std::vector<Metric>& wanted, OverTime kind,
                 const RowImages& rows, int samples) {
  (kind == OverTime::Flicker ? metrics.flickerSamples : metrics.partsSamples) = samples;
  for (const Metric metric : wanted)
    if (overTimeOf(metric) == kind && (samples > 0 || !metricInfo(metric).needsReference))
      metrics.at(metric) = metricOverTime(metric, rows);
}

} // namespace

MetricsOfShot::MetricsOfShot(ShotPlayer& player, Views& views, ReferenceOfShot& reference,
                             OverTimeOfShot& overTime, const References& references)
    : player_(player), views_(views), reference_(reference), overTime_(overTime), references_(references) {}

FrameMetrics MetricsOfShot::measure(const std::vector<Metric>& wanted, int lane) {
  FrameMetrics metrics{
      .frame = player_.shown().frame, .lane = lane, .exact = player_.lane(lane).exact, .values = {}};
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  addRowMetrics(metrics, wanted, ids, views_.images(ids, lane));
  for (const OverTime kind : kindsOf(wanted))
    if (const std::optional<int> made = overTime_.samples(kind, lane))
      addOverTime(metrics, wanted, kind, overTime_.maps(kind, lane), *made);
  ReferenceRows* const rows =
      std::ranges::any_of(wanted, isAgainstReference) ? reference_.rows(lane) : nullptr;
  if (!rows) return metrics;
  metrics.referenceSamples = rows->samples();
  addCompared(metrics, wanted, rows->compared(), {});
  if (hasSupersampling(wanted))
    metrics.at(Metric::Supersampling) =
        reference_.errorOfFirst(framesSinceStart(player_.state(), metrics.frame), lane).rmse;
  return metrics;
}

FrameMetrics MetricsOfShot::measureFrame(int frame, const std::vector<Metric>& wanted, int samples,
                                         MetricCursor& cursor, const Progress& progress) {
  const ShotState state = player_.onlyLane(0);
  FrameMaker& maker = player_.maker();
  FrameMetrics metrics{.frame = frame, .values = {}};
  const bool isCompared = std::ranges::any_of(wanted, isAgainstReference);
  const auto needsThem = [](Metric metric) {
    return metricInfo(metric).isOverTime && metricInfo(metric).needsReference;
  };
  const OverTimeNeed need{kindsOf(wanted), 0, frame, std::ranges::any_of(wanted, needsThem) ? samples : 0};
  cursor.references.setBudget(0); // the one that is being drawn
  // First: it is what takes long, and what is there of it stays.
  if (!need.kinds.empty()) overTime_.fill(cursor.window, cursor.references, need, progress);
  const ReferenceKey compared{referenceRequest(state.request(0)), frame};
  const ReferencePicture* reference =
      isCompared ? &cursor.references.foundOrDrawn(*state.frames, compared, samples, references_, progress)
                 : nullptr;
  const gl::PassGroup group(pass_group::kExposure);
  ShownFrame made = player_.makeInBackground(frame, cursor.trace, progress);
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  std::vector<Image> rows;
  for (auto& [id, row] : exposed(maker, state, made, ids)) rows.push_back(std::move(row));
  addRowMetrics(metrics, wanted, ids, rows);
  std::vector<IntermediateId> last = overTime_.rowsOfLast(need);
  if (reference) last.push_back(IntermediateId::output);
  const RowImages resolve = exposed(maker, state, made, inTableOrder(std::move(last)));
  maker.recycle(std::move(made));
  if (reference) {
    metrics.referenceSamples = samples;
    PictureComparison comparison(resolve.at(IntermediateId::output), reference->mean());
    addCompared(metrics, wanted, comparison, progress);
    const int taken = framesSinceStart(state, frame);
    if (hasSupersampling(wanted))
      metrics.at(Metric::Supersampling) =
          taken >= samples
              ? 0.0
              : pictureError(cursor.references.meanOfFirst(*state.frames, compared, taken, progress),
                             comparison.reference())
                    .rmse;
  }
  if (need.kinds.empty()) return metrics;
  for (const auto& [kind, maps] : overTime_.finish(cursor.window, need, resolve, progress))
    addOverTime(metrics, wanted, kind, maps, need.samples);
  return metrics;
}

} // namespace taa
