#include "core/jobs/idle/Comparing.h"

#include "core/base/Say.h"
#include "core/inspect/ShownPicture.h"

#include <algorithm>

namespace taa {

// Those that are not the one on show.
std::vector<int> Comparing::frames() const {
  std::vector<int> frames;
  if (!desk_.isOpen()) return frames;
  const InspectedShot& shot = desk_.inspector.shot();
  for (const ViewRequest& view : wanted_.views) {
    if (!isShown(view) || !view.other) continue;
    const auto frame = otherSource(*view.other, shot.frame(), shot.frameCount()).frame;
    if (frame && std::ranges::find(frames, *frame) == frames.end()) frames.push_back(*frame);
  }
  return frames;
}

void Comparing::take(const request::SetViews&) {
  if (desk_.isOpen() && frames().empty()) desk_.inspector.views().keepComparisonFrames({});
}

bool Comparing::isDue() {
  if (!desk_.isOpen() || transport_.isPlaying()) return false;
  const std::vector<int> wanted = frames();
  if (stoppedAt_ == desk_.version() && stopped_ == wanted) return false;
  return std::ranges::any_of(wanted,
                             [&](int frame) { return !desk_.inspector.views().isCached({.frame = frame}); });
}

void Comparing::stop() {
  stoppedAt_ = desk_.version();
  stopped_ = frames();
}

// What requests interrupt is taken up again by the next step().
void Comparing::step() {
  bool isCancelled = false;
  const bool isDone = desk_.attempt(RequestKind::Views, [&] {
    try {
      desk_.inspector.views().keepComparisonFrames(
          frames(), desk_.progressOfReplay(WorkKind::Comparing, say<"Drawing the frame to compare with">()));
    } catch (const Cancelled&) {
      isCancelled = true;
    }
  });
  desk_.endWork();
  if (!isDone) stop();
  if (!isCancelled) ++desk_.comparisonVersion;
}

} // namespace taa
