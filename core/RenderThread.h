// The Inspector on a thread of its own: wishes in, results out; std only. The caller never waits for GL.
#pragma once

#include "core/Inspector.h"
#include "core/Playback.h"
#include "core/RenderScene.h"
#include "core/SequenceExport.h"
#include "core/ViewRequest.h"
#include "core/inspect/PixelTrace.h"
#include "core/inspect/ProbePin.h"
#include "core/inspect/StageShares.h"
#include "core/inspect/WhatIf.h"
#include "core/scene/SceneOutline.h"
#include "core/taa/reference/Details.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa {

struct ProbeResult {
  ProbePin pin{}; ///< whose, with its anchor
  PinSpot spot{}; ///< where it is now; there is nothing around one that is off screen or gone
  int x = 0, y = 0, frame = 0;
  std::vector<PixelRecord> around{}; ///< 3×3 row-major, [4] is the pixel itself
  bool exact = true;
  Settings settings{}; ///< that made the values
  FrameInfo info{};
  // Of the active pin.
  std::shared_ptr<const reference::Details> details{}; ///< by the CPU twin
  std::vector<WhatIfRow> whatIf{};                     ///< when it is asked for
};

/// The pinned probes, and of which more is wanted.
struct PinWish {
  std::vector<ProbePin> pins;
  int active = -1;
  bool whatIf = false; ///< also the active pixel under other choices
};

/// A small picture of a stage's main row, in the style it opens with.
struct Thumbnail {
  IntermediateId id{};
  int frame = 0;
  Picture picture;
};

/// Names of objects that the status holds at most: more than a menu has room for.
inline constexpr std::size_t kMostObjects = 40;

/// What the window shows about the state; sent whenever any of it changes. Before the pictures of a frame
/// that is not exact or not the wished one, after those of one that is: who shows badges by it never lacks
/// one.
struct Status {
  std::string source, camera;
  std::vector<std::string> cameras, warnings;
  std::vector<std::string> objects; ///< names of what is drawn, at most kMostObjects
  std::vector<MotionOverride> motionModes;
  int width = 0, height = 0, frameCount = 0;
  double framesPerSecond = 60.0;
  FrameInfo info;
  Settings settings;
  int jitterPeriod = 0;
  bool playing = false, exact = true;
  std::optional<int> goal; ///< frame that is on its way, while info.frame is another one near it
  std::size_t checkpointBudget = 0;
  int referenceGoal = 0; ///< samples that a reference will have
  FrameTimes times;
  gl::Driver driver;
  std::vector<int> cuts;       ///< frames at which history starts anew, besides frame 0
  std::vector<int> keptFrames; ///< those whose history is kept, rising
  Playback playback;
  std::shared_ptr<const SceneOutline> outline; ///< made once, when it was opened
  ObjectFilter filter;
  std::vector<CameraTrackHandle> tracks; ///< flown cameras, which are among `cameras`
  CameraPose pose;                       ///< of the camera at this frame
  bool recording = false;
  /// Counts the changes of what frames are a function of: what was known of frames is no longer true then.
  std::uint64_t subject = 0;
};

/// Long work under way; `what` empty: none.
struct Work {
  std::string what;
  int done = 0, total = 0;
};

/// Called on the render thread; must return soon (post to your own thread). Results are values.
struct RenderListener {
  std::function<void(ViewResult)> onPicture;
  std::function<void(ProbeResult)> onProbe;
  std::function<void(Status)> onStatus;
  std::function<void(Work)> onWork;
  std::function<void(std::string)> onError; ///< a sentence; nothing was lost
  std::function<void(FrameProfile)> onProfile{};
  std::function<void(StageCosts)> onStageCosts{};
  std::function<void(Thumbnail)> onThumbnail{};
  std::function<void(FrameFigures)> onFigures{};
  /// After reloadShaders(): what does not compile, with file and line; empty: they are in use.
  std::function<void(std::string)> onShaders{};
  std::function<void(ExportResult)> onExported{};
  std::function<void(ObjectArea)> onObjectArea{};
  /// Of frames that it rests at, while thumbnails are wanted.
  std::function<void(StageShares)> onStageShares{};
  std::function<void(TraceDelivery)> onTrace{};
};

/// Every member returns at once and may be called from any one thread. Wishes coalesce: the last one of a
/// kind wins, and long work that a newer wish makes useless is cancelled. Errors come by onError and change
/// nothing.
class RenderThread {
 public:
  explicit RenderThread(RenderListener listener);
  /// Cancels what is under way and joins.
  ~RenderThread();
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;

  void open(const std::string& source);
  void setSize(int width, int height);
  void setCamera(const std::string& name);
  void setMotionModes(const std::vector<MotionOverride>& modes);
  void setSettings(const Settings& settings); ///< answered at once on the old history, then exactly
  /// Settings of the lanes after the first, to compare with: at most three. At once without history, then
  /// exactly.
  void setOtherLanes(const std::vector<Settings>& lanes);
  /// Compiles what these will need when nothing else is to be done and nothing plays: somebody looks at a
  /// choice and may take it.
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
  /// has come on. They cost a run of the resolve a frame. None: an empty list.
  void setFigures(const std::vector<Figure>& figures);
  void setObjectFilter(const ObjectFilter& filter);
  /// Looks from there, from now on; while it plays or records, from the next frame on.
  void fly(const CameraPose& pose);
  /// Keeps the pose of each frame from now on, as a camera "Recorded N"; ended by a jump or the last frame.
  void setRecording(bool recording);
  void addCameraTrack(const CameraTrack& track); ///< several add up; looks through the last one
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

  /// Waits until all wishes so far are answered; for tests and screenshots only.
  void waitUntilIdle();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace taa
