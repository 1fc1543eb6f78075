// What the render thread does for figures of frames: of each one on show, and of the others in idle time.
#include "core/base/Say.h"
#include "core/jobs/RenderWorker.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr int kFramesAtOnce = 8; ///< in their order, since each goes on from the one before

bool isOverTimeFigure(Figure figure) {
  return figureInfo(figure).isOverTime;
}

// Where each takes many frames before it the first of a row is dear.
int framesAtOnce(const std::vector<Figure>& wanted) {
  return std::ranges::any_of(wanted, isOverTimeFigure) ? 4 * kFlickerFrames : kFramesAtOnce;
}

bool needsReferenceFor(Figure figure) {
  return figureInfo(figure).needsReference;
}

} // namespace

void RenderWorker::applyFigures(const Wishes& wishes) {
  if (wishes.figures) {
    figures_.wanted = *wishes.figures;
    figures_.deliveredOf = {};
  }
  if (wishes.figures || wishes.referenceSamples || figures_.subject != subject_) {
    figures_.subject = subject_;
    figures_.known.clear();
    figures_.frames.reset();
    figures_.cursor = {};
    figures_.isStopped = false;
  }
  if (wishes.cancel) figures_.isStopped = true;
}

void RenderWorker::deliverFigures() {
  const std::pair state(version_, reference_.version);
  if (figures_.wanted.empty() || figures_.deliveredOf == state) return;
  figures_.deliveredOf = state; // also when it fails: once is enough to tell
  attempt(RequestKind::Figures, [&] {
    for (int lane = 0; lane < inspector_.shot().laneCount(); ++lane)
      deliver(inspector_.metrics().figures(figures_.wanted, lane));
  });
}

void RenderWorker::deliver(FrameFigures figures) {
  const bool isWhole =
      !std::ranges::any_of(figures_.wanted, needsReferenceFor) || figures.referenceSamples == reference_.goal;
  const bool lacksFlicker = std::ranges::any_of(figures_.wanted, [&](Figure figure) {
    const int samples = figureInfo(figure).needsReference ? reference_.goal : 0;
    return isOverTimeFigure(figure) && figures.flickerSamples.value_or(-1) < samples;
  });
  if (figures.lane == 0 && figures.exact && isWhole && !lacksFlicker) figures_.known.insert(figures.frame);
  figures.subject = subject_;
  if (listener_.onFigures) listener_.onFigures(figures);
}

// The next frame whose figures are missing: of those that are played the nearest to the one on show, and what
// is missing right behind it.
std::optional<int> RenderWorker::frameOfFigures() const {
  if (figures_.wanted.empty() || figures_.isStopped || figures_.subject != subject_ || !isOpen() ||
      playing_ || hasFrameGoal() || laneOfReference() || laneOfFlicker())
    return {};
  const auto [first, last] = playedFrames();
  const auto isMissing = [&, from = first, to = last](int frame) {
    return frame >= from && frame <= to && !figures_.known.contains(frame);
  };
  const int now = inspector_.shot().frame();
  if (figures_.frames && figures_.around == now)
    for (int frame = figures_.frames->first; frame <= figures_.frames->second; ++frame)
      if (isMissing(frame)) return frame;
  for (int distance = 0; distance <= inspector_.shot().frameCount(); ++distance)
    for (const int frame : {now + distance, now - distance})
      if (isMissing(frame)) {
        int start = frame; // of those before it as many as one way brings along
        while (frame < now && frame - start + 1 < framesAtOnce(figures_.wanted) && isMissing(start - 1))
          --start;
        return start;
      }
  return {};
}

// One frame; any wish is answered first, and what is there of its reference is kept.
void RenderWorker::fillFigures(int frame) {
  if (!figures_.frames || figures_.around != inspector_.shot().frame() || frame < figures_.frames->first ||
      frame > figures_.frames->second) {
    figures_.frames = {frame, frame + framesAtOnce(figures_.wanted) - 1};
    figures_.around = inspector_.shot().frame();
  }
  const auto [first, last] = playedFrames();
  const auto done = std::ranges::count_if(
      figures_.known, [from = first, to = last](int known) { return known >= from && known <= to; });
  figures_.isTold = true;
  if (listener_.onWork)
    listener_.onWork({say<"Measuring the frames">(), static_cast<int>(done), last - first + 1});
  const auto stops = [this](std::string_view, int, int) {
    const auto thumbnail = thumbnailDueAt(); // it comes first, too
    return !ends_ && !pending_(isAny) && !(thumbnail && *thumbnail <= Clock::now());
  };
  const bool isDone = attempt(RequestKind::Figures, [&] {
    try {
      deliver(inspector_.metrics().figuresBeside(frame, figures_.wanted, reference_.goal, figures_.cursor,
                                                 stops));
    } catch (const Cancelled&) { // goes on later
    }
  });
  if (!isDone) figures_.isStopped = true;
  endFigures();
}

// Once there is nothing more to measure.
void RenderWorker::endFigures() {
  if (!figures_.isTold || frameOfFigures()) return;
  figures_.isTold = false;
  if (!hasFrameGoal() && !playing_) figures_.cursor = {}; // else it goes on soon
  if (listener_.onWork) listener_.onWork({});
}

} // namespace taa
