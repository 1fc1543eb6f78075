#include "core/jobs/idle/Comparing.h"

#include "core/base/Say.h"
#include "core/inspect/ShownPicture.h"

#include <algorithm>

namespace taa {

// Those that are not the one on show.
std::vector<int> Comparing::frames() const {
  std::vector<int> frames;
  if (!jobContext_.isOpen()) return frames;
  const InspectedShot& shot = jobContext_.inspector.shot();
  for (const ViewRequest& view : subscriptions_.views) {
    if (!isShown(view) || !view.other) continue;
    const auto frame = otherSource(*view.other, shot.frame(), shot.frameCount()).frame;
    if (frame && std::ranges::find(frames, *frame) == frames.end()) frames.push_back(*frame);
  }
  return frames;
}

void Comparing::take(const request::SetViews&) {
  if (jobContext_.isOpen() && frames().empty()) jobContext_.inspector.views().keepComparisonFrames({});
}

bool Comparing::isDue() {
  if (!jobContext_.isOpen() || transport_.isPlaying()) return false;
  const std::vector<int> subscriptions = frames();
  if (stoppedAt_ == jobContext_.version() && stopped_ == subscriptions) return false;
  return std::ranges::any_of(
      subscriptions, [&](int frame) { return !jobContext_.inspector.views().isCached({.frame = frame}); });
}

void Comparing::stop() {
  stoppedAt_ = jobContext_.version();
  stopped_ = frames();
}

// What requests interrupt is taken up again by the next step().
void Comparing::step() {
  bool isCancelled = false;
  const bool isDone = jobContext_.attempt(RequestKind::Views, [&] {
    try {
      jobContext_.inspector.views().keepComparisonFrames(
          frames(),
          jobContext_.progressOfReplay(WorkKind::Comparing, say<"Drawing the frame to compare with">()));
    } catch (const Cancelled&) {
      isCancelled = true;
    }
  });
  jobContext_.endWork();
  if (!isDone) stop();
  if (!isCancelled) ++jobContext_.comparisonVersion;
}

} // namespace taa
