// What is looked at: an open scene, its lanes of settings, and the frame on show.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/Context.h"
#include "core/render/FrameInputs.h"
#include "core/replay/BackgroundCompiler.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneCost.h"
#include "core/scene/ShotChoice.h"
#include "core/scene/camera/CameraTrack.h"
#include "core/settings/Lanes.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa {

struct CaptureFacts;
struct FrameCameraPair;
class ReferenceOfShot;
class ShotPlayer;
class ShotProfiler;
class Visualizer;

/// Milliseconds of the frame on show, by glFinish and the wall clock; 0: it was kept, nothing was done for
/// it.
struct FrameTimes {
  double scene = 0.0, resolve = 0.0; ///< of all lanes together
};

/// The part of the Inspector that changes something. Frame n of a lane is f(scene, camera, the lane's
/// settings, size, n): however it was reached, the same bits (manual, architecture). Strong guarantee: when a
/// member throws, everything is as it was before.
class InspectedShot {
 public:
  /// Reloads the shaders of the visualizer, makes the reference forget what was drawn of another scene or by
  /// other shaders, and prepares nothing while the profiler times passes.
  InspectedShot(const gl::Driver& driver, ShotPlayer& player, Visualizer& visualizer,
                ReferenceOfShot& reference, const ShotProfiler& profiler);
  InspectedShot(const InspectedShot&) = delete;
  InspectedShot& operator=(const InspectedShot&) = delete;

  const gl::Driver& driver() const { return driver_; }

  // What is looked at; all but settings, lanes and size expect that something is open
  /// A glTF file, "builtin:NAME", or a capture's folder or capture.json. Goes to frame 0 with the scene's own
  /// camera, of a capture with its size, too. `budget`: what this scene may ask for; else as
  /// setSceneBudget().
  void open(const std::string& source, const Progress& progress = {}, const ShotChoice& choice = {},
            const std::optional<SceneBudget>& budget = {});
  /// What scenes may ask for from the next open() on.
  void setSceneBudget(const SceneBudget& budget) { sceneBudget_ = budget; }
  const ShotChoice& choice() const { return choice_; } ///< it was opened with
  const std::string& source() const;                   ///< empty: nothing is open yet
  const Scene& scene() const;                          ///< of a capture it holds nothing to draw
  /// What is the capture's own; null: a scene is open. Whatever changes camera, objects or size of a capture
  /// throws Error.
  std::shared_ptr<const CaptureFacts> capture() const;
  std::vector<std::string> cameras() const;
  const std::string& camera() const;
  /// Stays at the frame, which is drawn anew without history: isExact() is false until refine() or a seek,
  /// unless no frame before it counts. Throws Error naming the paths there are.
  void setCamera(const std::string& name);
  const std::vector<MotionOverride>& motionModes() const;
  /// Motion modes of objects by the names of their nodes, instead of all earlier ones; open() forgets them.
  /// As setSettings. Throws Error naming the objects there are.
  void setMotionModes(const std::vector<MotionOverride>& modes);
  const ObjectFilter& objectFilter() const;
  void setObjectFilter(const ObjectFilter& filter); ///< as setMotionModes
  const std::vector<ClassOverride>& objectClasses() const;
  void setObjectClasses(const std::vector<ClassOverride>& classes); ///< as setMotionModes
  const std::vector<int>& restarts() const;                         ///< rising
  /// Frames at which history starts anew, as after a cut, instead of all earlier ones; what is drawn stays as
  /// it is, motion too. Frames before the first that changes stay as they are; open() forgets them. Throws
  /// Error naming the frames there are.
  void setRestarts(std::vector<int> frames);
  const std::vector<CameraTrackHandle>& cameraTracks() const;
  /// Adds a camera, or changes the one of its name, and looks through it; open() forgets it. As setCamera,
  /// but frames before the first that changes stay as they are.
  void setCameraTrack(CameraTrack track);
  /// These and no others, looking through one of them or of the scene's. As setCamera; stays exact where the
  /// frame's camera does. Throws Error.
  void setFlownCameras(const FlownCameras& cameras);
  CameraPose cameraPose() const; ///< at the frame on show
  /// Of the frame on show; of a capture without matrices a place to stand.
  FrameCameraPair shownCameras(int lane = 0) const;
  /// At first 1280 × 720, or 960 × 540 where the driver rasterizes in software.
  /// As setCamera. Throws Error when the size is out of the driver's limits (4 to maxTextureSize a side) or
  /// memory.
  void setSize(int width, int height);
  int width() const;
  int height() const;

  // Lanes: one to kMaxLanes (settings, history) pairs on the same inputs
  void setLanes(const std::vector<Settings>& lanes);
  /// The first ones stay as they are, others come and go at once: a new one has no history, so that it is not
  /// exact until refine() or a seek.
  void changeLanes(const std::vector<Settings>& lanes);
  int laneCount() const;
  const Settings& settings(int lane = 0) const; ///< those that were set
  /// Those that count: the same, but for what a capture has of its own (settingsOn()).
  const Settings& usedSettings(int lane = 0) const;
  /// Resolves the current frame again at once, on the history it had: isExact() is false until refine() or a
  /// seek.
  void setSettings(const Settings& settings, int lane = 0);
  /// Makes sure that setSettings() need not wait for a compiler, and changes nothing else: resolves the frame
  /// with them once, unless their programs are there. Does nothing for what only draws the scene anew.
  void prepare(const Settings& settings, int lane = 0);
  /// Begins to compile for that on another thread, so that prepare() and setSettings() find it on disk where
  /// the driver keeps programs there. Returns at once; one that has not begun gives way to the next.
  void prepareInBackground(const Settings& settings, int lane = 0);
  /// Whether that is done, after `duration` at most.
  bool waitUntilPrepared(std::chrono::milliseconds duration);

  // Time
  int frameCount() const;
  int frame() const;
  FrameInfo info(int lane = 0) const; ///< jitter is the lane's
  /// Goes to frame n (0 to frameCount − 1), replaying from the nearest checkpoint. Cancelled: stays where it
  /// was.
  void seek(int frame, const Progress& progress = {});
  /// Goes to the next frame on the history at hand, exact or not: for playing. Expects that there is a next
  /// one.
  void advance();
  /// Replays the current frame so that it is exact again.
  void refine(const Progress& progress = {});
  /// False while the picture rests on history from old settings (the badge).
  bool isExact(int lane = 0) const;
  bool areAllExact() const;
  FrameTimes times() const;
  /// How many frames seek(frame) resolves: 0 when all of it is kept.
  int replayLength(int frame) const;
  /// The frame nearest to `frame` for which that is one at most.
  int nearestCached(int frame) const;
  /// Frames whose history is kept in every lane, rising: nothing before them has to be made again.
  std::vector<int> keptFrames() const;
  /// Bytes that kept histories of all lanes may use on the GPU; default kDefaultCheckpointBudget.
  void setCheckpointBudget(std::size_t bytes);
  std::size_t checkpointBudget() const;
  /// Bytes that inputs of frames drawn lately may use on the GPU, so that other settings of the resolve and
  /// other lanes draw them no second time; default 0.
  void setInputsBudget(std::size_t bytes);

  /// Compiles all shaders again; on Error everything stays as it was.
  void reloadShaders();

 private:
  /// Throws Error when there are too many or the memory is too small for them.
  void checkLanes(const std::vector<Settings>& lanes) const;
  /// Throws Error where a capture is open.
  void requireScene() const;
  Settings used(const Settings& settings) const;
  std::vector<Settings> used(const std::vector<Settings>& lanes) const;

  const gl::Driver& driver_;
  ShotPlayer& player_;
  Visualizer& visualizer_;
  ReferenceOfShot& reference_;
  const ShotProfiler& profiler_;
  BackgroundCompiler compiler_;
  std::vector<Settings> lanes_{Settings{}}; // as they were set
  ShotChoice choice_;
  std::optional<glm::ivec2> scenePx_; // while a capture is open: the size of what was open before
  SceneBudget sceneBudget_;
};

} // namespace taa
