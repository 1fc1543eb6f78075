// The Inspector on a thread of its own: wishes in, results out; std only. The caller never waits for GL.
#pragma once

#include "core/requests/RenderWishes.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace taa {

/// Every member returns at once and may be called from any one thread. Wishes coalesce: the last one of a
/// kind wins, and long work that a newer wish makes useless is cancelled. Errors come by onError, say what
/// they answer and change nothing.
class RenderThread {
 public:
  using Clock = FlightRecording::Clock;
  using ClockNow = std::function<Clock::time_point()>; ///< called from any thread
  /// `now` is the clock of whoever flies the camera.
  explicit RenderThread(RenderListener listener, ClockNow now = Clock::now);
  /// Cancels what is under way and joins.
  ~RenderThread();
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;

  /// What was asked of the scene before counts where this one is refused.
  void open(const std::string& source);
  void setSize(int width, int height);
  void setCamera(const std::string& name);
  void setMotionModes(const std::vector<MotionOverride>& modes);
  void setSettings(const Settings& settings); ///< answered at once on the old history, then exactly
  /// Settings of the lanes after the first, to compare with: at most kMostLanes − 1. At once without history,
  /// then exactly.
  void setOtherLanes(const std::vector<Settings>& lanes);
  /// Compiles what these will need beside the frames: somebody looks at a choice and may take it.
  void prepare(const Settings& settings);
  void setPlaying(bool playing);
  void setLooping(bool looping); ///< at the end: start again, or pause
  void setPlayback(const Playback& playback);
  void seek(int frame);  ///< the nearest frame that is at hand at once, then exactly this one
  void step(int frames); ///< relative; steps add up while they wait; pauses
  void setViews(const std::vector<ViewRequest>& views);
  /// Stay: each is delivered again for each new frame until it is taken back.
  void setPins(const PinWish& pins);
  void setCheckpointBudget(std::size_t bytes);
  /// Times every pass from now on, which costs; a profile of each frame made is delivered.
  void setProfiling(bool profiling);
  /// Measures what each stage costs on the frame on show; playing waits for it.
  void measureStages();
  /// Thumbnails of the stages at this size, drawn only while nothing else is to be done; 0: none.
  void setThumbnails(int width, int height);
  /// How many samples a reference has, 4 to 1024. It is drawn while nothing plays and nothing else is to be
  /// done, as long as a view shows a row of it or figures need it; the views see it with 4, 16, 64 …
  void setReferenceSamples(int samples);
  /// Figures of each new frame on show, of each lane, played or not, by onFigures; again when its reference
  /// has come on. They cost a run of the resolve a frame. Those of the other frames that are played come in
  /// idle time, of the first lane, the nearest first. None: an empty list.
  void setFigures(const std::vector<Figure>& figures);
  void setObjectFilter(const ObjectFilter& filter);
  void setObjectClasses(const std::vector<ClassOverride>& classes);
  void setRestarts(const std::vector<int>& frames); ///< at which history starts anew
  /// Looks from there, from now on, after it moved there for `took`; while it plays, from the next frame on.
  void fly(const CameraPose& pose, Clock::duration took = {});
  /// Plays, and keeps where the camera is flown from now on, as a camera "Recorded N" with a pose for each
  /// frame that goes by on the clock, however many of them can be shown. Ended by a pause, a jump or the last
  /// frame; then goes to the frame that it ended at.
  void setRecording(bool recording);
  void addCameraTrack(const CameraTrack& track); ///< several add up; looks through the last one
  /// Instead of all flown cameras there are. Throws nothing: what cannot be comes by onError.
  void setFlownCameras(const FlownCameras& cameras);
  /// Says where these are seen, again for each frame that it rests at; none: no longer.
  void locate(const std::vector<int>& objects);
  /// From now on what is at the pins in each exact frame on show is delivered as a trace, too.
  void setTracing(bool tracing);
  /// Also in the frames from `first` to `last` that were not shown, while nothing plays: what is shown stays.
  void fillTraces(int first, int last);
  void reloadShaders();
  void cancel(); ///< stops the long work under way
  /// Other wishes wait until it is done; cancel() stops it.
  void exportSequence(const SequenceRequest& request);

  /// Of what was called last.
  RequestId lastRequest() const;
  /// Waits until all wishes so far are answered; for tests and screenshots only.
  void waitUntilIdle();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace taa
