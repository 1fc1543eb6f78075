// What the render thread does: takes wishes in their order of importance, works, and delivers what changed.
#pragma once

#include "core/jobs/RenderIdle.h"
#include "core/jobs/RenderMemory.h"
#include "core/requests/RenderWishes.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace taa {

/// The rows that views show, with those that lie over them.
std::vector<IntermediateId> rowsOf(const std::vector<ViewRequest>& views);

/// Lives on the render thread, with the Inspector. `pending` answers what has been wished for since: called
/// with a function that looks at the wishes while nobody changes them.
class RenderWorker {
 public:
  using Clock = std::chrono::steady_clock;
  using Pending = std::function<bool(bool (*)(const Wishes&))>;
  using ClockNow = std::function<Clock::time_point()>;

  /// `now` is the clock of whoever flies the camera. Throws Error when there is no GL.
  RenderWorker(const RenderListener& listener, Pending pending, const std::atomic<bool>& ends, ClockNow now);

  void apply(Wishes wishes);
  /// Goes on with what is not done: a frame to go to, the next frame of a playing shot, an exact picture.
  void work();
  void deliver();
  /// When nothing else is to be done, compiles what may be needed soon, draws a thumbnail, goes on with the
  /// reference, or measures a frame that is not on show.
  void useIdleTime();

  /// Whether work() would do something now, besides playing.
  bool hasGoal() const {
    return hasFrameGoal() || wantsToFillTraces() || laneOfReference() || frameOfFigures() ||
           laneOfFlicker() || isCompilingAhead();
  }
  /// When there is something to do again without a wish; nothing: never.
  std::optional<Clock::time_point> wakeAt();

 private:
  struct Reasons {
    std::pair<std::uint64_t, std::uint64_t> version; ///< of the frame on show and those beside it
    std::vector<std::pair<Look, ReasonCounts>> counts;
  };
  bool hasFrameGoal() const { return goal_ || needsRefinement() || needsAside() || measuring_; }
  bool isOpen() const { return !inspector_.shot().source().empty(); }
  bool needsRefinement() const;
  bool needsAside() const;
  bool open(const std::string& source);
  void applyShot(const Wishes& wishes);
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
  ReasonCounts reasonsOf(const Look& look, IntermediateId id, const ViewStyle& style);
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
  bool isCompilingAhead() const { return prepared_ && isOpen() && !playing_; }
  bool compileAhead();
  void applyReference(const Wishes& wishes);
  std::optional<int> laneOfReference() const;
  void refineReference(int lane);
  int flickerSamplesFor(int lane) const;
  std::optional<int> laneOfFlicker() const;
  void refineFlicker(int lane);
  void endFlicker();
  void endReference();
  void applyFigures(const Wishes& wishes);
  void deliverFigures();
  void deliver(FrameFigures figures);
  std::optional<int> frameOfFigures() const;
  void fillFigures(int frame);
  void endFigures();
  void addReference(ViewResult& result);
  double playedPerSecond() const;
  void applyScene(const Wishes& wishes);
  void applyFlight(const ShotWishes& wishes);
  void beginRecording(Clock::time_point at);
  void endRecording(Clock::time_point at);
  void layTrack(int frame, const CameraPose& pose);
  void endFlight();
  CameraTrackHandle currentTrack() const;
  void deliverArea();
  void deliverShares();
  void sendStatus();
  void reloadShaders();
  void exportSequence(const SequenceRequest& request);
  Progress progress(const std::string& what, bool (*stops)(const Wishes&));
  /// Errors are told, as answers to the latest request of that kind, and change nothing; returns whether the
  /// action was done.
  bool attempt(RequestKind kind, const std::function<void()>& action);
  /// The same of something that all frames depend on: what was delivered is of another subject then.
  bool change(RequestKind kind, const std::function<void()>& action);
  void noteChange(RequestKind kind);

  const RenderListener& listener_;
  Pending pending_;
  const std::atomic<bool>& ends_;
  ClockNow now_;
  LatestRequests latest_; // that were taken up
  RequestId opened_ = 0;  // the one that opened the scene
  std::vector<RequestKind> inexactSince_;
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
  std::vector<DeliveredView> delivered_;
  AsideWork asides_;
  PinWish pins_;
  std::uint64_t pinsDelivered_ = 0;
  bool measuring_ = false; // stages
  ThumbnailSchedule thumbnails_;
  std::optional<Settings> prepared_; // to compile
  Playback playback_;
  ReferenceWork reference_;
  FigureWork figures_;
  Reasons reasons_;
  Flight flight_;
  std::shared_ptr<const SceneOutline> outline_; // of the scene
  std::vector<int> located_;                    // objects
  std::uint64_t areaDelivered_ = 0, sharesDelivered_ = 0;
  TraceWork traces_;
  std::uint64_t subject_ = 0; // see Status
};

} // namespace taa
