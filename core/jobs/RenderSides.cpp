// What the render thread draws of views: both of their sides, of lanes and frames beside the one on show.
#include "core/jobs/RenderWorker.h"

#include "core/base/Say.h"
#include "core/inspect/ShownPicture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

namespace {

// The pixels of the picture that a view shows, whole ones.
gl::Rect visiblePixels(const ViewRequest& view, int width, int height) {
  const auto edge = [](float position, int size) {
    return static_cast<int>(std::clamp(position, 0.0f, static_cast<float>(size)));
  };
  const glm::vec2 from = view.transform.origin;
  const glm::vec2 to = from + glm::vec2(view.width, view.height) / view.transform.zoom;
  const int left = edge(std::floor(from.x), width), top = edge(std::floor(from.y), height);
  return {left, top, edge(std::ceil(to.x), width) - left, edge(std::ceil(to.y), height) - top};
}

bool isShown(const ViewRequest& view) {
  return view.width > 0 && view.height > 0;
}

void addRows(std::vector<IntermediateId>& ids, IntermediateId id, const ViewStyle& style) {
  ids.push_back(id);
  if (style.markRejected) ids.push_back(IntermediateId::rejectReason);
  if (style.outlineObjects) ids.push_back(IntermediateId::objectId);
}

} // namespace

ReasonCounts countReasons(const Image& reasons) {
  ReasonCounts counts{};
  for (const float value : reasons.pixels)
    if (const int reason = static_cast<int>(value); reason >= 0 && reason < kReasonCount)
      ++counts[static_cast<std::size_t>(reason)];
  return counts;
}

std::vector<IntermediateId> rowsOf(const std::vector<ViewRequest>& views) {
  std::vector<IntermediateId> ids;
  for (const ViewRequest& view : views) {
    if (!isShown(view)) continue;
    addRows(ids, view.id, view.style);
    if (view.other) addRows(ids, view.other->id, view.other->style);
  }
  return ids;
}

// Lane 0 is the one of the settings.
void RenderWorker::applyLanes(const std::vector<Settings>& others) {
  std::vector<Settings> lanes{inspector_.shot().settings()};
  lanes.insert(lanes.end(), others.begin(), others.end());
  inspector_.shot().changeLanes(lanes);
}

// The frame of a view's other side, when it is not the one on show.
std::optional<int> RenderWorker::otherFrame(const ViewRequest& view) const {
  if (!isOpen() || !view.other) return {};
  return otherLook(*view.other, inspector_.shot().frame(), inspector_.shot().frameCount()).frame;
}

std::vector<int> RenderWorker::asideFrames() const {
  std::vector<int> frames;
  for (const ViewRequest& view : views_)
    if (const auto frame = isShown(view) ? otherFrame(view) : std::nullopt)
      if (std::ranges::find(frames, *frame) == frames.end()) frames.push_back(*frame);
  return frames;
}

bool RenderWorker::needsAside() const {
  if (!isOpen() || playing_) return false;
  const std::vector<int> frames = asideFrames();
  if (asides_.stoppedAt == version_ && asides_.framesStopped == frames) return false;
  return std::ranges::any_of(frames,
                             [&](int frame) { return !inspector_.views().isAtHand({.frame = frame}); });
}

void RenderWorker::stopAside() {
  asides_.stoppedAt = version_;
  asides_.framesStopped = asideFrames();
}

// What wishes interrupt is taken up again by the next work().
void RenderWorker::makeAside() {
  const std::vector<int> frames = asideFrames();
  bool isCancelled = false;
  const bool isDone = attempt(RequestKind::Views, [&] {
    try {
      inspector_.views().keepAside(frames, progress(say<"Drawing the frame to compare with">(), endsReplay));
    } catch (const Cancelled&) {
      isCancelled = true;
    }
  });
  if (listener_.onWork) listener_.onWork({});
  if (!isDone) stopAside();
  if (!isCancelled) ++asides_.version;
}

void RenderWorker::deliverView(int index) {
  const ViewRequest& view = views_[static_cast<std::size_t>(index)];
  DeliveredView& last = delivered_[static_cast<std::size_t>(index)];
  const bool showsReference = isOfReference(view.id) || (view.other && isOfReference(view.other->id));
  const DeliveredView now{view, version_, view.other ? asides_.version : 0,
                          showsReference ? reference_.version : 0};
  if (!isShown(view) || last == now) return;
  const Look look{view.id, view.lane, {}};
  std::optional<Look> other;
  if (view.other) other = otherLook(*view.other, inspector_.shot().frame(), inspector_.shot().frameCount());
  if (other && !inspector_.views().isAtHand(*other)) other.reset(); // on its way
  const bool isLaneThere = view.lane < inspector_.shot().laneCount();
  if (!isLaneThere || (view.asDifference && !other)) return;
  last = now; // also when it fails: once is enough to tell
  attempt(RequestKind::Views, [&] {
    ViewResult result = draw(index, look, other);
    if (listener_.onPicture) listener_.onPicture(std::move(result));
  });
}

// Of the whole picture, once for each that it is of: panning asks again and again.
ReasonCounts RenderWorker::reasonsOf(const Look& look, IntermediateId id, const ViewStyle& style) {
  if (!style.markRejected && id != IntermediateId::rejectReason) return {};
  const std::pair now(version_, asides_.version);
  if (reasons_.version != now) reasons_ = {now, {}};
  const Look reasons{IntermediateId::rejectReason, look.lane, look.frame};
  const auto known = std::ranges::find(reasons_.counts, reasons, &std::pair<Look, ReasonCounts>::first);
  if (known != reasons_.counts.end()) return known->second;
  const gl::Rect whole{0, 0, inspector_.shot().width(), inspector_.shot().height()};
  const ReasonCounts counts = countReasons(inspector_.views().image(reasons, {}, whole));
  reasons_.counts.emplace_back(reasons, counts);
  return counts;
}

ViewResult RenderWorker::draw(int index, const Look& look, const std::optional<Look>& other) {
  const ViewRequest& view = views_[static_cast<std::size_t>(index)];
  ViewResult result{.view = index, .request = view, .picture = {}, .values = {}, .region = {}};
  const gl::Rect region = visiblePixels(view, inspector_.shot().width(), inspector_.shot().height());
  if (isOfReference(view.id)) addReference(result);
  const bool hasValues =
      view.withValues && inspector_.views().isAtHand(look) && region.width > 0 && region.height > 0;
  if (hasValues) result.region = region;
  const std::optional<Look> minus = view.asDifference ? other : std::nullopt;
  result.frame = inspector_.shot().frame();
  result.subject = subject_;
  result.exact = inspector_.views().isExact(look) && (!minus || inspector_.views().isExact(*minus));
  result.picture =
      inspector_.views().picture(look, minus, view.style, view.transform, view.width, view.height);
  if (hasValues) result.values = inspector_.views().image(look, minus, region);
  result.reasons = reasonsOf(look, view.id, view.style);
  if (!other) return result;
  ViewSide& side = result.other.emplace();
  side.frame = other->frame.value_or(inspector_.shot().frame());
  side.exact = inspector_.views().isExact(*other);
  side.picture =
      inspector_.views().picture(*other, {}, view.other->style, view.transform, view.width, view.height);
  if (hasValues) side.values = inspector_.views().image(*other, {}, region);
  side.reasons = reasonsOf(*other, view.other->id, view.other->style);
  return result;
}

} // namespace taa
