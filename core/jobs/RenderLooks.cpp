// What the render thread does besides frames: profiles, the cost of stages; thumbnails, programs and the
// reference in idle time.
#include "core/jobs/RenderWorker.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace taa {

void RenderWorker::applyLooks(const Wishes& wishes) {
  if (wishes.profiling) inspector_.profiler().setProfiling(*wishes.profiling);
  if (wishes.cancel && measuring_) {
    measuring_ = false;
    if (listener_.onWork) listener_.onWork({});
  }
  if (wishes.measureStages) measuring_ = isOpen();
  if (wishes.thumbnails) thumbnails_.want(*wishes.thumbnails);
  if (wishes.prepared && isOpen()) {
    prepared_ = wishes.prepared;
    inspector_.shot().prepareAside(*prepared_);
  }
  if (wishes.settings) prepared_.reset(); // it came too late
  if (wishes.exported) exportSequence(*wishes.exported);
}

void RenderWorker::deliverProfile() {
  attempt(RequestKind::Profile, [&] {
    if (auto profile = inspector_.profiler().takeProfile(); profile && listener_.onProfile)
      listener_.onProfile(std::move(*profile));
  });
}

// Any wish is answered between two draws; then it goes on, or starts anew where the frame is another one.
void RenderWorker::measureStages() {
  bool goesOn = false;
  attempt(RequestKind::Profile, [&] {
    try {
      StageCosts costs = inspector_.profiler().measureStages(progress("", isAny));
      if (listener_.onStageCosts) listener_.onStageCosts(std::move(costs));
    } catch (const Cancelled&) {
      goesOn = true;
    }
  });
  measuring_ = goesOn;
  if (!goesOn && listener_.onWork) listener_.onWork({});
}

std::optional<RenderWorker::Clock::time_point> RenderWorker::thumbnailDueAt() {
  if (!isOpen()) return {};
  return thumbnails_.dueAt(version_, Clock::now(), playing_ ? std::optional(nextFrameAt_) : std::nullopt);
}

std::optional<RenderWorker::Clock::time_point> RenderWorker::wakeAt() {
  const auto thumbnail = thumbnailDueAt();
  if (playing_ && thumbnail) return std::min(*thumbnail, nextFrameAt_);
  return playing_ ? std::optional(nextFrameAt_) : thumbnail;
}

// Once what is looked at was compiled beside the frames it is taken over, which takes no longer than a frame;
// where nothing is kept on disk it is compiled here. Neither holds up a play. Whether there was something to
// do. Errors are told to whoever makes the choice.
bool RenderWorker::compileAhead() {
  constexpr std::chrono::milliseconds kSlice{5}; // that a wish may have to wait
  if (!isCompilingAhead()) return false;
  if (!inspector_.shot().waitUntilPrepared(kSlice)) return true;
  try {
    inspector_.shot().prepare(*std::exchange(prepared_, {}));
  } catch (const Error&) {
  }
  return true;
}

void RenderWorker::deliverShares() {
  sharesDelivered_ = version_;
  attempt(RequestKind::Thumbnails, [&] {
    StageShares shares{.frame = inspector_.shot().frame(),
                       .startsHistory = inspector_.shot().info().startsHistory,
                       .stages = {}};
    shares.stages = sharesOf(inspector_.views().images(shareRows()), inspector_.shot().settings());
    if (listener_.onStageShares) listener_.onStageShares(std::move(shares));
  });
}

void RenderWorker::useIdleTime() {
  if (ends_ || hasFrameGoal() || pending_(isAny) || compileAhead()) return;
  const auto due = thumbnailDueAt();
  const Clock::time_point began = Clock::now();
  if (!due || *due > began) {
    if (const std::optional<int> lane = laneOfReference()) return refineReference(*lane);
    if (const std::optional<int> lane = laneOfFlicker()) return refineFlicker(*lane);
    if (const std::optional<int> frame = frameOfFigures()) fillFigures(*frame);
    return;
  }
  if (!playing_ && sharesDelivered_ != version_) return deliverShares(); // then the thumbnails, which wait
  const bool isDrawn = attempt(RequestKind::Thumbnails, [&] {
    const IntermediateId id = thumbnails_.next();
    Thumbnail thumbnail{id, inspector_.shot().frame(), inspector_.views().thumbnail(id, thumbnails_.texels()),
                        subject_};
    if (listener_.onThumbnail) listener_.onThumbnail(std::move(thumbnail));
  });
  if (!isDrawn) return thumbnails_.want({}); // told once; wanted again when the window says so
  thumbnails_.drawn(began, Clock::now());
}

} // namespace taa
