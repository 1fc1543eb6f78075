#include "core/jobs/RenderWorker.h"

#include "core/base/Say.h"
#include "core/render/jitter/Jitter.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <utility>

namespace taa {

namespace {

bool stopsOpening(const Wishes& wishes) {
  return wishes.source || wishes.cancel;
}

} // namespace

RenderWorker::RenderWorker(const RenderListener& listener, Pending pending, const std::atomic<bool>& ends,
                           ClockNow now)
    : listener_(listener), pending_(std::move(pending)), ends_(ends), now_(std::move(now)) {}

// Whoever asked for something that failed shows what it asked for: the status says what is in force.
bool RenderWorker::attempt(RequestKind kind, const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (const Cancelled&) {
    return false; // whoever asked for it knows
  } catch (const std::exception& error) {
    if (listener_.onError) listener_.onError({error.what(), kind, latest_.of(kind)});
    statusChanged_ = true;
    return false;
  }
}

bool RenderWorker::change(RequestKind kind, const std::function<void()>& action) {
  if (!attempt(kind, action)) return false;
  noteChange(kind);
  refinementStopped_ = false;
  return true;
}

void RenderWorker::noteChange(RequestKind kind) {
  ++version_;
  ++subject_;
  statusChanged_ = true;
  if (std::ranges::find(inexactSince_, kind) == inexactSince_.end()) inexactSince_.push_back(kind);
}

// Reports `what` unless the progress names it itself, and stops when a wish says so: at once, or, for wishes
// that a replay only pauses for, after the first step, so that it comes on however fast they arrive: what was
// replayed until then is kept, and the replay goes on.
Progress RenderWorker::progress(const std::string& what, bool (*stops)(const Wishes&)) {
  return [this, what, stops](std::string_view doing, int done, int total) {
    if (ends_ || pending_(stops)) return false;
    if (what.empty() || total > 1) {
      if (listener_.onWork) listener_.onWork({what.empty() ? std::string(doing) : what, done, total});
    }
    if (!what.empty() && done > 0 && pending_(isAny)) return false;
    return true;
  };
}

void RenderWorker::apply(Wishes wishes) {
  latest_.take(wishes.latest);
  if (wishes.cancel) {
    goal_.reset();
    refinementStopped_ = statusChanged_ = true;
    stopAside();
  }
  if (wishes.checkpointBudget) {
    inspector_.shot().setCheckpointBudget(*wishes.checkpointBudget);
    statusChanged_ = true;
  }
  applyPlayback(wishes);
  // Before the source, so that its first frame exposes what is shown and the resolve is compiled once.
  if (wishes.views) {
    views_ = *wishes.views;
    delivered_.resize(views_.size());
    inspector_.views().watch(rowsOf(views_));
    if (isOpen() && asideFrames().empty()) inspector_.views().keepAside({});
  }
  if (wishes.reload) reloadShaders();
  if (wishes.source && !open(*wishes.source)) wishes.refuseSource();
  applyShot(wishes);
  applyScene(wishes);
  applyTime(wishes);
  if (wishes.pins) applyPins(*wishes.pins);
  applyTraces(wishes);
  applyLooks(wishes);
  applyReference(wishes);
  applyFigures(wishes);
  endReference();
  endFlicker();
  endFigures();
}

bool RenderWorker::open(const std::string& source) {
  endFlight(); // of the old one, which stays where the new one is refused
  goal_.reset();
  const bool isOpened = change(RequestKind::Source, [&] {
    inspector_.shot().open(source, progress("", stopsOpening));
    objects_ = objectNames(inspector_.shot().scene());
    objects_.resize(std::min(objects_.size(), kMostObjects));
    outline_ = std::make_shared<const SceneOutline>(
        outlineOf(inspector_.shot().scene(), inspector_.shot().source()));
  });
  if (isOpened) opened_ = latest_.of(RequestKind::Source);
  if (listener_.onWork) listener_.onWork({});
  return isOpened;
}

void RenderWorker::applyShot(const Wishes& wishes) {
  if (wishes.size && *wishes.size != glm::ivec2(inspector_.shot().width(), inspector_.shot().height()))
    change(RequestKind::Size, [&] { inspector_.shot().setSize(wishes.size->x, wishes.size->y); });
  const SceneWishes& scene = wishes.scene;
  if (wishes.camera || wishes.frame || scene.cameras || !scene.tracks.empty()) endFlight();
  if (isOpen() && scene.cameras)
    change(RequestKind::FlownCameras, [&] { inspector_.shot().setFlownCameras(*scene.cameras); });
  if (isOpen())
    for (const CameraTrack& track : scene.tracks)
      change(RequestKind::FlownCameras, [&] { inspector_.shot().setCameraTrack(track); });
  if (wishes.camera && isOpen() && *wishes.camera != inspector_.shot().camera())
    change(RequestKind::Camera, [&] { inspector_.shot().setCamera(*wishes.camera); });
  if (wishes.motionModes && isOpen() && *wishes.motionModes != inspector_.shot().motionModes())
    change(RequestKind::MotionModes, [&] { inspector_.shot().setMotionModes(*wishes.motionModes); });
  if (wishes.settings && !(*wishes.settings == inspector_.shot().settings()))
    change(RequestKind::Settings, [&] { inspector_.shot().setSettings(*wishes.settings); });
  if (wishes.otherLanes) change(RequestKind::Lanes, [&] { applyLanes(*wishes.otherLanes); });
}

void RenderWorker::applyTime(const Wishes& wishes) {
  if (!isOpen()) return;
  if (wishes.playing) {
    const auto [first, last] = playedFrames();
    const bool restarts = *wishes.playing && !playing_ && !looping_ && inspector_.shot().frame() == last;
    if (!*wishes.playing) endFlight();
    setPlaying(*wishes.playing);
    if (restarts) goal_ = first;
    isNear_ = false;
  }
  if (!wishes.frame && wishes.steps == 0) return;
  if (flight_.recording) endFlight(); // time is taken out of its hands
  const int last = inspector_.shot().frameCount() - 1;
  const int from = wishes.frame ? *wishes.frame : goal_.value_or(inspector_.shot().frame());
  goal_ = static_cast<int>(std::clamp<std::int64_t>(std::int64_t(from) + wishes.steps, 0, last));
  if (*goal_ < from) endFlight();
  isNear_ = false;
  refinementStopped_ = false;
}

bool RenderWorker::needsRefinement() const {
  return isOpen() && !playing_ && !refinementStopped_ && !inspector_.shot().areAllExact();
}

void RenderWorker::work() {
  if (!isOpen()) return;
  if (goal_ && goNear()) return;
  if (goal_)
    replay(*goal_, say<"Going to frame %1">(*goal_));
  else if (measuring_ && !needsRefinement() && !needsAside())
    measureStages();
  else if (playing_ && Clock::now() >= nextFrameAt_)
    playOn();
  else if (needsRefinement())
    replay(inspector_.shot().frame(), replayText(inexactSince_));
  else if (needsAside())
    makeAside();
  else if (wantsToFillTraces())
    fillTraces();
}

// Before a long way: shows the nearest frame at hand when it is much nearer than what is on show, and tells
// that another one is on its way. Returns whether there is something to deliver.
bool RenderWorker::goNear() {
  if (std::exchange(isNear_, true) || inspector_.shot().replayLength(*goal_) <= 1) return false;
  const int near = inspector_.shot().nearestAtHand(*goal_);
  statusChanged_ = true;
  if (2 * std::abs(*goal_ - near) > std::abs(*goal_ - inspector_.shot().frame())) return true;
  attempt(RequestKind::Time, [&] { inspector_.shot().seek(near); });
  ++version_;
  return true;
}

// Goes to a frame, as far as wishes let it; what they interrupt is taken up again by the next work().
void RenderWorker::replay(int frame, const std::string& what) {
  const int oldFrame = inspector_.shot().frame();
  const bool wasExact = inspector_.shot().areAllExact();
  bool isCancelled = false;
  const RequestKind kind = goal_ || inexactSince_.empty() ? RequestKind::Time : inexactSince_.back();
  attempt(kind, [&] {
    try {
      inspector_.shot().seek(frame, progress(what, endsReplay));
    } catch (const Cancelled&) {
      isCancelled = true;
    }
  });
  if (listener_.onWork) listener_.onWork({});
  if (isCancelled) return;
  if (std::exchange(goal_, {})) statusChanged_ = true;
  if (!inspector_.shot().areAllExact()) refinementStopped_ = true; // it failed
  if (inspector_.shot().frame() == oldFrame && inspector_.shot().areAllExact() == wasExact) return;
  ++version_;
  statusChanged_ = true;
}

void RenderWorker::deliver() {
  if (isOpen()) {
    if (statusChanged_ && (goal_ || !inspector_.shot().isExact())) sendStatus();
    for (int index = 0; index < static_cast<int>(views_.size()); ++index) deliverView(index);
    deliverPins();
    deliverFigures();
    deliverArea();
    deliverProfile();
  }
  if (statusChanged_) sendStatus();
}

void RenderWorker::sendStatus() {
  statusChanged_ = false;
  if (isOpen() && inspector_.shot().areAllExact()) inexactSince_.clear();
  if (!listener_.onStatus) return;
  Status status;
  status.width = inspector_.shot().width();
  status.height = inspector_.shot().height();
  status.settings = inspector_.shot().settings();
  status.jitterPeriod = jitterPeriod(status.settings.jitter);
  status.playing = playing_;
  status.driver = inspector_.shot().driver();
  status.referenceGoal = reference_.goal;
  status.checkpointBudget = inspector_.shot().checkpointBudget();
  status.playback = playback_;
  status.subject = subject_;
  status.inexactSince = inexactSince_;
  if (isOpen()) {
    status.source = inspector_.shot().source();
    status.camera = inspector_.shot().camera();
    status.cameras = inspector_.shot().cameras();
    status.warnings = inspector_.shot().scene().warnings;
    status.objects = objects_;
    status.motionModes = inspector_.shot().motionModes();
    status.frameCount = inspector_.shot().frameCount();
    status.framesPerSecond = inspector_.shot().scene().shot.framesPerSecond;
    status.info = inspector_.shot().info();
    status.exact = inspector_.shot().isExact();
    if (goal_ && isNear_ && *goal_ != inspector_.shot().frame()) status.goal = goal_;
    status.times = inspector_.shot().times();
    status.cuts = inspector_.shot().scene().shot.cuts;
    status.restarts = inspector_.shot().restarts();
    status.keptFrames = inspector_.shot().keptFrames();
    status.outline = outline_;
    status.filter = inspector_.shot().objectFilter();
    status.objectClasses = inspector_.shot().objectClasses();
    status.tracks = inspector_.shot().cameraTracks();
    status.pose = inspector_.shot().cameraPose();
    status.recording = flight_.recording.has_value();
    status.recordedFrames = flight_.recording ? flight_.recording->frameCount(now_()) : 0;
    status.opened = opened_;
  }
  listener_.onStatus(std::move(status));
}

} // namespace taa
