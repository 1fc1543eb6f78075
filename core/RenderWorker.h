// What the render thread does: takes wishes in their order of importance, works, and delivers what changed.
#pragma once

#include "core/RenderIdle.h"
#include "core/RenderThread.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace taa {

/// What is asked for and not yet taken up; the last wish of a kind wins, steps add up.
struct Wishes {
  bool reload = false, cancel = false, measureStages = false;
  std::optional<std::string> source, camera;
  std::optional<glm::ivec2> size;
  std::optional<std::vector<MotionOverride>> motionModes;
  std::optional<Settings> settings, prepared;
  std::optional<bool> looping, playing;
  std::optional<int> frame; ///< to go to, before the steps
  int steps = 0;
  std::optional<std::vector<ViewRequest>> views;
  std::optional<PinWish> pins;
  std::optional<std::size_t> checkpointBudget;
  std::optional<bool> profiling;
  std::optional<glm::ivec2> thumbnails;
  std::optional<Playback> playback;
  std::optional<int> referenceSamples;
  std::optional<std::vector<Figure>> figures;
  std::optional<std::vector<Settings>> otherLanes;
  std::optional<SequenceRequest> exported;
  SceneWishes scene;
  std::optional<bool> tracing;
  std::optional<std::pair<int, int>> fillTraces; ///< first and last frame

  bool isEmpty() const;
  /// Whether going to a frame is of no use any more once these are taken up.
  bool endReplay() const;
};

/// A question for RenderWorker's `pending`.
bool endsReplay(const Wishes& wishes);

/// The rows that views show, with those that lie over them.
std::vector<IntermediateId> rowsOf(const std::vector<ViewRequest>& views);

/// Lives on the render thread, with the Inspector. `pending` answers what has been wished for since: called
/// with a function that looks at the wishes while nobody changes them.
class RenderWorker {
 public:
  using Clock = std::chrono::steady_clock;
  using Pending = std::function<bool(bool (*)(const Wishes&))>;

  /// Throws Error when there is no GL.
  RenderWorker(const RenderListener& listener, Pending pending, const std::atomic<bool>& ends);

  void apply(const Wishes& wishes);
  /// Goes on with what is not done: a frame to go to, the next frame of a playing shot, an exact picture.
  void work();
  void deliver();
  /// When nothing else is to be done, compiles what may be needed soon, draws a thumbnail, or goes on with
  /// the reference.
  void useIdleTime();

  /// Whether work() would do something now, besides playing.
  bool hasGoal() const { return hasFrameGoal() || wantsToFillTraces() || laneOfReference(); }
  /// When there is something to do again without a wish; nothing: never.
  std::optional<Clock::time_point> wakeAt();

 private:
  /// What was delivered of the pins, and what is to be filled in.
  struct Traces {
    bool wanted = false;
    std::uint64_t subject = 0;                             // what follows is of this one
    std::vector<std::pair<ProbePin, std::set<int>>> known; // frames
    std::optional<std::pair<int, int>> filling;
    TraceCursor cursor;
  };
  struct Delivered {
    ViewRequest request;
    std::uint64_t version = 0, asides = 0, reference = 0;
    bool operator==(const Delivered&) const = default;
  };
  /// The reference that is drawn while nothing else is to be done.
  struct Reference {
    int goal = kReferenceSamples;
    std::uint64_t version = 1;   ///< changes with each picture of it that is to be shown
    std::uint64_t stoppedAt = 0; ///< version of the frame that it was cancelled or failed for
    bool isTold = false;         ///< somebody was told that it is under way
  };
  struct Figures {
    std::vector<Figure> wanted;
    std::pair<std::uint64_t, std::uint64_t> deliveredOf; ///< versions of frame and reference
  };
  bool hasFrameGoal() const { return goal_ || needsRefinement() || needsAside() || measuring_; }
  bool isOpen() const { return !inspector_.source().empty(); }
  bool needsRefinement() const;
  bool needsAside() const;
  void applySource(const Wishes& wishes);
  void applyTime(const Wishes& wishes);
  void applyLooks(const Wishes& wishes);
  void applyPlayback(const Wishes& wishes);
  std::pair<int, int> playedFrames() const;
  void playOn();
  bool goNear();
  void replay(int frame, const std::string& what);
  void setPlaying(bool playing);
  void applyLanes(const std::vector<Settings>& others);
  std::optional<int> otherFrame(const ViewRequest& view) const;
  std::vector<int> asideFrames() const;
  void makeAside();
  void stopAside();
  void deliverView(int index);
  ViewResult draw(int index, const Look& look, const std::optional<Look>& other);
  void applyPins(const PinWish& wish);
  void deliverPins();
  void deliverPin(int index);
  void applyTraces(const Wishes& wishes);
  std::set<int>& tracedFrames(const ProbePin& pin);
  void traceShown(const ProbeResult& result);
  void deliverTrace(const ProbePin& pin, int frame, const std::optional<TraceSample>& sample);
  bool wantsToFillTraces() const;
  void fillTraces();
  void deliverProfile();
  void measureStages();
  std::optional<Clock::time_point> thumbnailDueAt();
  bool compileAhead();
  void applyReference(const Wishes& wishes);
  std::optional<int> laneOfReference() const;
  void refineReference(int lane);
  void endReference();
  void deliverFigures();
  void addReference(ViewResult& result);
  void applyScene(const Wishes& wishes);
  void fly(const CameraPose& pose);
  void setRecording(bool recording);
  void layTrack(int frame, const CameraPose& pose);
  void endFlight();
  void pauseFlight();
  CameraTrackHandle currentTrack() const;
  void deliverArea();
  void deliverShares();
  void sendStatus();
  void reloadShaders();
  void exportSequence(const SequenceRequest& request);
  Progress progress(const std::string& what, bool (*stops)(const Wishes&));
  template <typename Action>
  bool attempt(Action action);
  template <typename Action>
  void change(Action action);

  const RenderListener& listener_;
  Pending pending_;
  const std::atomic<bool>& ends_;
  Inspector inspector_;
  bool playing_ = false, looping_ = true;
  bool refinementStopped_ = false; // cancelled or failed: not again until something changes
  std::optional<int> goal_;        // frame to go to
  bool isNear_ = false;            // the nearest frame at hand is shown until then
  Clock::time_point nextFrameAt_;
  std::uint64_t version_ = 1; // of the frame on show; changes with everything that it depends on
  bool statusChanged_ = true;
  std::vector<std::string> objects_; // of the scene
  std::vector<ViewRequest> views_;
  std::vector<Delivered> delivered_;
  std::uint64_t asides_ = 1;       // changes when frames beside the one on show are at hand
  std::uint64_t asideStopped_ = 0; // version for which these were cancelled or failed: not again
  std::vector<int> framesStopped_;
  PinWish pins_;
  std::uint64_t pinsDelivered_ = 0;
  bool measuring_ = false; // stages
  ThumbnailSchedule thumbnails_;
  std::optional<Settings> prepared_; // to compile
  Playback playback_;
  Reference reference_;
  Figures figures_;
  Flight flight_;
  std::shared_ptr<const SceneOutline> outline_; // of the scene
  std::vector<int> located_;                    // objects
  std::uint64_t areaDelivered_ = 0, sharesDelivered_ = 0;
  Traces traces_;
  std::uint64_t subject_ = 0; // see Status
};

// Errors are told and change nothing; returns whether the action was done.
template <typename Action>
bool RenderWorker::attempt(Action action) {
  try {
    action();
    return true;
  } catch (const Cancelled&) {
    return false; // whoever asked for it knows
  } catch (const std::exception& error) {
    if (listener_.onError) listener_.onError(error.what());
    return false;
  }
}

// Something that all frames depend on: what was delivered is of another subject now.
template <typename Action>
void RenderWorker::change(Action action) {
  if (!attempt(action)) return;
  ++version_;
  ++subject_;
  statusChanged_ = true;
  refinementStopped_ = false;
}

} // namespace taa
