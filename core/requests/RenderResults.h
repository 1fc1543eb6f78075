// What the render thread answers: values and finished pictures, and who they are given to.
#pragma once

#include "core/inspect/Inspector.h"
#include "core/measure/StageShares.h"
#include "core/picture/ViewRequest.h"
#include "core/report/SequenceExport.h"
#include "core/requests/Playback.h"
#include "core/requests/RenderRequests.h"
#include "core/requests/RenderScene.h"
#include "core/scene/SceneOutline.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
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
  std::shared_ptr<const twin::Details> details{}; ///< by the CPU twin
  std::vector<WhatIfRow> whatIf{};                ///< when it is asked for
};

/// A small picture of a stage's main row, in the style it opens with.
struct Thumbnail {
  IntermediateId id{};
  int frame = 0;
  Picture picture;
  std::uint64_t subject = 0; ///< see Status
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
  std::vector<int> restarts;   ///< those at which somebody restarts it, rising
  std::vector<int> keptFrames; ///< those whose history is kept, rising
  Playback playback;
  std::shared_ptr<const SceneOutline> outline; ///< made once, when it was opened
  ObjectFilter filter;
  std::vector<ClassOverride> objectClasses;
  std::vector<CameraTrackHandle> tracks; ///< flown cameras, which are among `cameras`
  CameraPose pose;                       ///< of the camera at this frame
  bool recording = false;
  int recordedFrames = 0; ///< poses of the recording so far
  RequestId opened = 0;   ///< the request that opened the scene
  /// Kinds of requests since which what is on show is not exact; empty: it is.
  std::vector<RequestKind> inexactSince;
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
  std::function<void(Failure)> onError;
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

} // namespace taa
