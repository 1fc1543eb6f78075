#include "core/jobs/idle/FigureMeasuring.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace taa {

namespace {

constexpr int kFramesInARow = 8; ///< since each goes on from the one before

bool isOverTimeFigure(Figure figure) {
  return figureInfo(figure).isOverTime;
}

bool needsReferenceFor(Figure figure) {
  return figureInfo(figure).needsReference;
}

// Where each takes many frames before it the first of a row is dear.
int framesInARow(const std::vector<Figure>& wanted) {
  return std::ranges::any_of(wanted, isOverTimeFigure) ? 4 * kFlickerFrames : kFramesInARow;
}

} // namespace

void FigureMeasuring::take(const request::SetFigures& wanted) {
  wanted_.figures = wanted.figures;
  deliveredOf_ = {};
  forget();
}

void FigureMeasuring::forget() {
  shotVersion_ = desk_.shotVersion();
  known_.clear();
  row_.reset();
  cursor_ = {};
  isStopped_ = false;
}

void FigureMeasuring::settle() {
  if (shotVersion_ != desk_.shotVersion()) forget();
  endIfDone();
}

void FigureMeasuring::deliver() {
  const std::pair now(desk_.version(), desk_.referenceVersion);
  if (wanted_.figures.empty() || deliveredOf_ == now) return;
  deliveredOf_ = now; // also when it fails: once is enough to tell
  desk_.attempt(RequestKind::Figures, [this] {
    const int lanes = desk_.inspector.shot().laneCount();
    for (int lane = 0; lane < lanes; ++lane) tell(desk_.inspector.metrics().figures(wanted_.figures, lane));
  });
}

bool FigureMeasuring::isWhole(const FrameFigures& figures) const {
  const int samples = wanted_.referenceSamples;
  if (std::ranges::any_of(wanted_.figures, needsReferenceFor) && figures.referenceSamples != samples)
    return false;
  return std::ranges::none_of(wanted_.figures, [&](Figure figure) {
    const int needed = figureInfo(figure).needsReference ? samples : 0;
    return isOverTimeFigure(figure) && figures.flickerSamples.value_or(-1) < needed;
  });
}

void FigureMeasuring::tell(FrameFigures figures) {
  if (figures.lane == 0 && figures.exact && isWhole(figures)) known_.insert(figures.frame);
  figures.shotVersion = desk_.shotVersion();
  desk_.tell(RequestKind::Figures, std::move(figures));
}

bool FigureMeasuring::isMissing(int frame) const {
  const auto [first, last] = transport_.frames();
  return frame >= first && frame <= last && !known_.contains(frame);
}

// Of those before it as many as one way brings along.
int FigureMeasuring::firstOfRow(int frame) const {
  const int now = desk_.inspector.shot().frame();
  int first = frame;
  while (frame < now && frame - first + 1 < framesInARow(wanted_.figures) && isMissing(first - 1)) --first;
  return first;
}

// The next frame whose figures are missing: of those that are played the nearest to the one on show, and what
// is missing right behind it.
std::optional<int> FigureMeasuring::frame() const {
  if (wanted_.figures.empty() || isStopped_ || shotVersion_ != desk_.shotVersion() || !desk_.isOpen() ||
      transport_.isPlaying())
    return {};
  const int now = desk_.inspector.shot().frame();
  if (row_ && around_ == now)
    for (int frame = row_->first; frame <= row_->second; ++frame)
      if (isMissing(frame)) return frame;
  const int count = desk_.inspector.shot().frameCount();
  for (int distance = 0; distance <= count; ++distance)
    for (const int frame : {now + distance, now - distance})
      if (isMissing(frame)) return firstOfRow(frame);
  return {};
}

void FigureMeasuring::step() {
  const int frame = *this->frame();
  const int now = desk_.inspector.shot().frame();
  if (!row_ || around_ != now || frame < row_->first || frame > row_->second) {
    row_ = {frame, frame + framesInARow(wanted_.figures) - 1};
    around_ = now;
  }
  const auto [first, last] = transport_.frames();
  const auto done = std::ranges::count_if(
      known_, [from = first, to = last](int known) { return known >= from && known <= to; });
  isTold_ = true;
  desk_.tellWork(WorkKind::Figures, say<"Measuring the frames">(), static_cast<int>(done), last - first + 1);
  const auto goesOn = [this](std::string_view, int, int) {
    return !desk_.waiting().any() && !thumbnails_.isDue(); // they come first, too
  };
  const bool isDone = desk_.attempt(RequestKind::Figures, [&] {
    try {
      tell(desk_.inspector.metrics().figuresBeside(frame, wanted_.figures, wanted_.referenceSamples, cursor_,
                                                   goesOn));
    } catch (const Cancelled&) { // goes on later
    }
  });
  if (!isDone) isStopped_ = true;
  endIfDone();
}

// There is nothing more to measure.
void FigureMeasuring::endIfDone() {
  if (!isTold_ || frame()) return;
  isTold_ = false;
  if (!transport_.isPlaying()) cursor_ = {}; // else it goes on soon
  desk_.endWork();
}

} // namespace taa
