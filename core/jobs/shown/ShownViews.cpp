#include "core/jobs/shown/ShownViews.h"

#include "core/inspect/ShownPicture.h"
#include "core/render/CaptureFacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

namespace taa {

namespace {

bool showsReference(const ViewRequest& view) {
  return isOfReference(view.id) || (view.other && isOfReference(view.other->id));
}

} // namespace

void ShownViews::take(const request::SetViews& views) {
  subscriptions_.views = views.views;
  delivered_.resize(views.views.size());
  jobContext_.inspector.views().watch(subscriptions_.rows());
}

void ShownViews::deliver() {
  for (int index = 0; index < static_cast<int>(subscriptions_.views.size()); ++index) deliverView(index);
}

void ShownViews::deliverView(int index) {
  const ViewRequest& view = subscriptions_.views[static_cast<std::size_t>(index)];
  Delivered& last = delivered_[static_cast<std::size_t>(index)];
  const Delivered now{view, jobContext_.version(), view.other ? jobContext_.comparisonVersion : 0,
                      showsReference(view) ? jobContext_.referenceVersion : 0, jobContext_.previewVersion};
  if (!isShown(view) || last == now) return;
  const InspectedShot& shot = jobContext_.inspector.shot();
  std::optional<PictureSource> other;
  if (view.other) other = otherSource(*view.other, shot.frame(), shot.frameCount());
  if (other && !jobContext_.inspector.views().isCached(*other)) other.reset(); // on its way
  if (view.lane >= shot.laneCount() || (view.asDifference && !other)) return;
  last = now; // also when it fails: once is enough to tell
  jobContext_.attempt(RequestKind::Views, [&] {
    if (view.asDifference) checkDifference(view.id, other->id);
    jobContext_.tell(RequestKind::Views, draw(index, {view.id, view.lane, {}}, other));
  });
}

// Of the whole picture, once for each that it is of: panning asks again and again.
ReasonCounts ShownViews::reasonsOf(const PictureSource& source, IntermediateId id, const ViewStyle& style) {
  if (!style.markRejected && id != IntermediateId::rejectReason) return {};
  const std::pair now(jobContext_.version(), jobContext_.comparisonVersion);
  if (reasons_.version != now) reasons_ = {now, {}};
  // Over a picture along the motion lies what is of the frame on show, whose pixels it has.
  if (source.alongMotion && !style.markRejected) return {};
  const PictureSource reasons{IntermediateId::rejectReason, source.lane,
                              source.alongMotion ? std::nullopt : source.frame};
  const auto known =
      std::ranges::find(reasons_.counts, reasons, &std::pair<PictureSource, ReasonCounts>::first);
  if (known != reasons_.counts.end()) return known->second;
  const InspectedShot& shot = jobContext_.inspector.shot();
  const gl::Rect whole{0, 0, shot.width(), shot.height()};
  const ReasonCounts counts = countReasons(jobContext_.inspector.views().values(reasons, {}, whole).values);
  reasons_.counts.emplace_back(reasons, counts);
  return counts;
}

// Of a difference: of the signed row that it is.
std::optional<RegionSpread> ShownViews::spreadOf(const PictureSource& source,
                                                 const std::optional<PictureSource>& minus,
                                                 const ViewRequest& view) {
  Views& views = jobContext_.inspector.views();
  const InspectedShot& shot = jobContext_.inspector.shot();
  if (!view.measured || !views.isCached(source)) return {};
  const std::optional<gl::Rect> region = insidePicture(*view.measured, shot.width(), shot.height());
  if (!region) return {};
  const std::tuple now(jobContext_.version(), jobContext_.comparisonVersion, jobContext_.referenceVersion);
  if (spreads_.version != now) spreads_ = {now, {}};
  for (const Spreads::Known& known : spreads_.known)
    if (known.source == source && known.minus == minus && known.spread.region == *region) return known.spread;
  constexpr std::size_t kMaxKnown = 16; // a drag asks for one after the other
  if (spreads_.known.size() == kMaxKnown) spreads_.known.erase(spreads_.known.begin());
  const PartialImage values = views.values(source, minus, *region);
  Intermediate row = intermediate(source.id);
  if (minus) row.visual = Visual::Signed;
  spreads_.known.push_back({source, minus, regionSpread(values.values, values.absence, row, *region)});
  return spreads_.known.back().spread;
}

ViewResult ShownViews::draw(int index, const PictureSource& source,
                            const std::optional<PictureSource>& other) {
  const ViewRequest& view = subscriptions_.views[static_cast<std::size_t>(index)];
  const InspectedShot& shot = jobContext_.inspector.shot();
  Views& views = jobContext_.inspector.views();
  ViewResult result{.view = index, .request = view, .picture = {}, .values = {}, .region = {}};
  if (isOfReference(view.id)) addReference(result);
  const gl::Rect region = visiblePixels(view, {shot.width(), shot.height()});
  if (view.withValues && views.isCached(source) && region.width > 0 && region.height > 0)
    result.region = region;
  const std::optional<PictureSource> minus = view.asDifference ? other : std::nullopt;
  result.frame = shot.frame();
  result.shotVersion = jobContext_.shotVersion();
  result.exact = views.isExact(source) && (!minus || views.isExact(*minus));
  result.picture = views.picture(source, minus, view.style, view.transform, view.width, view.height);
  if (result.region.width > 0) {
    PartialImage values = views.values(source, minus, result.region);
    result.values = std::move(values.values);
    result.absence = std::move(values.absence);
  }
  result.spread = spreadOf(source, minus, view);
  result.reasons = reasonsOf(source, view.id, view.style);
  if (other) drawOther(result, *other);
  return result;
}

void ShownViews::drawOther(ViewResult& result, const PictureSource& other) {
  const ViewRequest& view = result.request;
  Views& views = jobContext_.inspector.views();
  ViewSide& side = result.other.emplace();
  side.frame = other.frame.value_or(result.frame);
  side.exact = views.isExact(other);
  side.allAbsent = views.absenceOf(other);
  side.picture = views.picture(other, {}, view.other->style, view.transform, view.width, view.height);
  if (result.region.width > 0) {
    PartialImage values = views.values(other, {}, result.region);
    side.values = std::move(values.values);
    side.absence = std::move(values.absence);
  }
  side.reasons = reasonsOf(other, view.other->id, view.other->style);
}

void ShownViews::addReference(ViewResult& result) {
  const ViewRequest& view = result.request;
  if (isOverTime(view.id)) {
    result.overTimeSamples = jobContext_.inspector.overTime().samples(overTime(view.id), view.lane);
    addNumber(result);
    return;
  }
  ReferenceOfShot& reference = jobContext_.inspector.reference();
  if (isOfEngine(view.id)) {
    if (ReferenceRows* rows = reference.engineRows(view.lane)) result.error = rows->compared().error();
    return;
  }
  const std::shared_ptr<const CaptureFacts> captured = jobContext_.inspector.shot().capture();
  result.isReferenceGiven = captured && captured->hasReference;
  result.referenceSamples = reference.samples(view.lane);
  if (result.referenceSamples == 0) return;
  result.error = reference.error(view.lane);
  addNumber(result);
}

void ShownViews::addNumber(ViewResult& result) {
  if (const std::optional<Metric> metric = metricOfMap(result.request.id))
    result.number = jobContext_.inspector.metrics().measure({*metric}, result.request.lane).at(*metric);
}

} // namespace taa
