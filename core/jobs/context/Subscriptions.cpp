#include "core/jobs/context/Subscriptions.h"

#include "core/inspect/RowsBefore.h"
#include "core/inspect/WorstOfShot.h"

#include <algorithm>
#include <iterator>

namespace taa {

namespace {

void addViewRows(std::vector<IntermediateId>& ids, IntermediateId id, const ViewStyle& style) {
  ids.push_back(id);
  if (style.markRejected) ids.push_back(IntermediateId::rejectReason);
  if (style.outlineObjects) ids.push_back(IntermediateId::objectId);
}

} // namespace

std::vector<IntermediateId> Subscriptions::rows() const {
  std::vector<IntermediateId> ids;
  for (const ViewRequest& view : views) {
    if (!isShown(view)) continue;
    addViewRows(ids, view.id, view.style);
    if (!view.other) continue;
    addViewRows(ids, view.other->id, view.other->style);
    if (view.other->alongMotion) ids.insert(ids.end(), std::begin(kPlacesBefore), std::end(kPlacesBefore));
  }
  return ids;
}

bool Subscriptions::needsReferenceOf(int lane) const {
  const auto needsIt = [lane](const auto& side) {
    return side.lane == lane && needsReference(side.id) && !isOverTime(side.id);
  };
  const auto isOfIt = [&](const ViewRequest& view) {
    return isShown(view) && (needsIt(view) || (view.other && needsIt(*view.other)));
  };
  const auto isFoundByIt = [&](const request::FindWorst& asked) {
    const IntermediateId row = WorstOfShot::rowOf(asked.row, asked.step);
    return asked.lane == lane && needsReference(row) && !isOverTime(row);
  };
  const bool isProbed = lane == 0 && probes.reference && probes.active >= 0;
  return isProbed || std::ranges::any_of(views, isOfIt) || (worst && isFoundByIt(*worst)) ||
         std::ranges::any_of(metrics, [](Metric metric) { return metricInfo(metric).needsReference; });
}

int Subscriptions::samplesOverTimeOf(OverTime kind, int lane) const {
  int samples = -1;
  const auto want = [&](bool isCompared) { samples = std::max(samples, isCompared ? referenceSamples : 0); };
  for (const Metric metric : metrics)
    if (overTimeOf(metric) == kind) want(metricInfo(metric).needsReference);
  const auto wantSide = [&](const auto& side) {
    if (side.lane == lane && overTime(side.id) == kind) want(needsReference(side.id));
  };
  for (const ViewRequest& view : views) {
    if (!isShown(view)) continue;
    wantSide(view);
    if (view.other) wantSide(*view.other);
  }
  return samples;
}

} // namespace taa
