// The façade: open a source, choose settings, go to a frame, look. Everything the app and taa-batch do goes
// through it.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/Context.h"
#include "core/inspect/Look.h"
#include "core/inspect/Metrics.h"
#include "core/inspect/PixelTrace.h"
#include "core/inspect/ProbePin.h"
#include "core/inspect/Profiler.h"
#include "core/inspect/StageMeter.h"
#include "core/inspect/Visualizer.h"
#include "core/inspect/WhatIf.h"
#include "core/render/FrameInputs.h"
#include "core/scene/CameraTrack.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/Scene.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"
#include "core/taa/reference/Details.h"
#include "core/taa/reference/Reference.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa {

using reference::PixelRecord;

inline constexpr int kMostLanes = 4;

/// Of 1280 × 720 with the default settings it holds 72 histories.
inline constexpr std::size_t kDefaultCheckpointBudget = std::size_t(1) << 30;
/// What a program can be asked for, MiB.
inline constexpr int kMostCheckpointMiB = 1 << 20;

/// Milliseconds of the frame on show, by glFinish and the wall clock; 0: it was kept, nothing was done for
/// it.
struct FrameTimes {
  double scene = 0.0, resolve = 0.0; ///< of all lanes together
};

/// Lives on the thread that made it, one at a time there, with its own GL context. Strong guarantee: when a
/// member throws, everything is as it was before. Frame n of a lane is f(scene, camera, the lane's settings,
/// size, n): however it was reached, the same bits (design §2.1).
class Inspector {
 public:
  Inspector();
  ~Inspector();
  Inspector(const Inspector&) = delete;
  Inspector& operator=(const Inspector&) = delete;

  const gl::Driver& driver() const;

  // What is looked at; all but settings, lanes and size expect that something is open
  /// A glTF file or "builtin:NAME". Goes to frame 0 with the scene's own camera.
  void open(const std::string& source, const Progress& progress = {});
  const std::string& source() const; ///< empty: nothing is open yet
  const Scene& scene() const;
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
  const std::vector<CameraTrackHandle>& cameraTracks() const;
  /// Adds a camera, or changes the one of its name, and looks through it; open() forgets it. As setCamera,
  /// but frames before the first that changes stay as they are.
  void setCameraTrack(CameraTrack track);
  CameraPose cameraPose() const; ///< at the frame on show
  /// At first 1280 × 720, or 960 × 540 where the driver rasterizes in software.
  /// As setCamera. Throws Error when the size is out of the driver's limits (4 to maxTextureSize a side) or
  /// memory.
  void setSize(int width, int height);
  int width() const;
  int height() const;

  // Lanes: one to four (settings, history) pairs on the same inputs
  void setLanes(const std::vector<Settings>& lanes);
  /// The first ones stay as they are, others come and go at once: a new one has no history, so that it is not
  /// exact until refine() or a seek.
  void changeLanes(const std::vector<Settings>& lanes);
  int laneCount() const;
  const Settings& settings(int lane = 0) const;
  /// Resolves the current frame again at once, on the history it had: isExact() is false until refine() or a
  /// seek.
  void setSettings(const Settings& settings, int lane = 0);
  /// Makes sure that setSettings() need not wait for a compiler, and changes nothing else: resolves the frame
  /// with them once, unless their programs are there. Does nothing for what only draws the scene anew.
  void prepare(const Settings& settings, int lane = 0);

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
  int nearestAtHand(int frame) const;
  /// Frames whose history is kept in every lane, rising: nothing before them has to be made again.
  std::vector<int> keptFrames() const;
  /// Bytes that kept histories of all lanes may use on the GPU; default kDefaultCheckpointBudget.
  void setCheckpointBudget(std::size_t bytes);
  std::size_t checkpointBudget() const;

  // Looking: changes nothing that is looked at
  /// Intermediates that each new frame exposes in its own resolve. Others are exposed on demand by running it
  /// again.
  void watch(const std::vector<IntermediateId>& ids);
  /// Values of the current frame, with the row's channels; `region` empty: the whole picture.
  Image image(IntermediateId id, int lane = 0, std::optional<gl::Rect> region = {});
  /// Several at once, in one run of the resolve.
  std::vector<Image> images(const std::vector<IntermediateId>& ids, int lane = 0);
  /// Everything at one pixel, (0,0) top left. Throws Error outside the picture.
  PixelRecord probe(int x, int y, int lane = 0);
  /// Everything at a square of pixels around (x, y), `radius` 1: 3×3, row-major; clamped at the border.
  std::vector<PixelRecord> probeAround(int x, int y, int radius, int lane = 0);
  // By the CPU twin, which reads what the GPU read
  /// What formulas of a pixel are made of.
  reference::Details details(int x, int y, int lane = 0);
  /// The pixel under other choices. The row of the present ones has the bits of probe() where the driver
  /// rounds as IEEE 754 says.
  std::vector<WhatIfRow> whatIf(int x, int y, int lane = 0);
  /// The pin with the surface it follows looked up, in the frame it was set in; others as they are.
  ProbePin anchored(const ProbePin& pin);
  /// Where a pin is in the frame on show. Expects an anchored one.
  PinSpot spot(const ProbePin& pin);
  /// What is at pins in any frame, exactly; nothing at those that are not seen there. What is on show stays.
  /// Frame after frame costs one frame each. Of the first lane. Expects anchored pins.
  std::vector<std::optional<TraceSample>> traceFrame(int frame, const std::vector<ProbePin>& pins,
                                                     TraceCursor& cursor, const Progress& progress = {});
  /// The finished picture of a view.
  Picture picture(IntermediateId id, const ViewStyle& style, const ViewTransform& transform, int width,
                  int height, int lane = 0);
  // Beside the frame on show, others can be kept at hand
  /// These frames of all lanes from now on, exactly, and no others, until anything but the frame changes.
  /// Cancelled: those that are done are kept.
  void keepAside(const std::vector<int>& frames, const Progress& progress = {});
  /// Whether its frame is the one on show or kept aside, and its lane is there.
  bool isAtHand(const Look& look) const;
  bool isExact(const Look& look) const;
  /// The picture of a view, or of what it is more than `minus` (of as many channels). Expects isAtHand().
  Picture picture(const Look& look, const std::optional<Look>& minus, const ViewStyle& style,
                  const ViewTransform& transform, int width, int height);
  /// Values of a part of the picture, or of the difference.
  Image image(const Look& look, const std::optional<Look>& minus, const gl::Rect& region);

  /// A small picture of it in the style it opens with; costs only the pixels that are in it.
  Picture thumbnail(IntermediateId id, const glm::ivec2& texels, int lane = 0);
  /// Drawn now when they are not.
  const FrameInputs& inputs(int lane = 0) const;

  // Reference: the frame on show supersampled (core/inspect/References.h). It depends on nothing of a lane
  // but how transparent materials are drawn, and is kept: coming back to the frame finds it. Looking at its
  // rows (isOfReference()) without one: picture() is empty, image() throws Error, probe() gives NaN.
  /// Draws until it has `samples`, 4 to 1024; with more it starts anew. Reports after each one; cancelled: it
  /// keeps what it has. Throws Error.
  void refineReference(int samples, const Progress& progress = {}, int lane = 0);
  int referenceSamples(int lane = 0) const; ///< 0: there is none
  /// Bytes of main memory that references of all frames may use; default kReferenceBudget.
  void setReferenceBudget(std::size_t bytes);
  /// Of the output against it. Throws Error where there is none.
  PictureError referenceError(int lane = 0);
  /// Figures of the frame on show; those against a reference stay empty where there is none.
  FrameFigures figures(const std::vector<Figure>& wanted, int lane = 0);

  // Measuring: nothing of it is done before it is asked for
  /// Times every pass from now on, or no longer.
  void setProfiling(bool on);
  /// The frame made last, with what was looked at of it since; nothing when none was made since the last
  /// call.
  std::optional<FrameProfile> takeProfile();
  /// What each stage costs on the frame on show. Cancelled: keeps what it has and goes on from there when it
  /// is asked again for the same frame.
  StageCosts measureStages(const Progress& progress = {}, int lane = 0);

  /// Compiles all shaders again; on Error everything stays as it was.
  void reloadShaders();

 private:
  /// Throws Error when there are too many or the memory is too small for them.
  void checkLanes(const std::vector<Settings>& lanes) const;

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace taa
