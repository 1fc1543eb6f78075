// What the render thread answers: values and finished pictures.
#pragma once

#include "core/inspect/Inspector.h"
#include "core/measure/StageShares.h"
#include "core/picture/ViewRequest.h"
#include "core/report/SequenceExport.h"
#include "core/requests/Playback.h"
#include "core/requests/RequestKinds.h"
#include "core/scene/SceneCost.h"
#include "core/scene/SceneOutline.h"
#include "core/scene/ShotChoice.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace taa {

struct CaptureFacts;

/// Index of the pixel itself in ProbeResult::around.
inline constexpr std::size_t kProbedMiddle = 4;

struct ProbeResult {
  Probe probe{};    ///< whose, with its anchor
  ProbeSpot spot{}; ///< where it is now; there is nothing around one that is off screen or gone
  int x = 0, y = 0, frame = 0;
  std::vector<PixelRecord> around{}; ///< 3×3 row-major
  bool exact = true;
  Settings settings{}; ///< that made the values
  FrameInfo info{};
  // Of the active probe.
  std::shared_ptr<const twin::Details> details{}; ///< by the CPU twin
  std::vector<WhatIfRow> whatIf{};                ///< when it is asked for
  std::vector<Sensitivity> sensitivities{};       ///< likewise
  std::optional<ComparedPixel> compared{};        ///< when it is asked for and there
};

/// A small picture of a stage's main row, in the style it opens with.
struct Thumbnail {
  IntermediateId id{};
  int frame = 0;
  Picture picture;
  std::uint64_t shotVersion = 0; ///< see Status
};

/// Names of objects that the status holds at most: more than a menu has room for.
inline constexpr std::size_t kMaxObjects = 40;

/// What the window shows about the state; sent whenever any of it changes. Before the pictures of a frame
/// that is not exact or not the wished one, after those of one that is: who shows badges by it never lacks
/// one.
struct Status {
  std::string source, camera;
  std::vector<std::string> cameras, warnings;
  std::vector<std::string> animations; ///< that can be chosen
  ShotChoice choice;                   ///< what was chosen of the scene when it was opened
  std::vector<std::string> objects;    ///< names of what is drawn, at most kMaxObjects
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
  std::shared_ptr<const CaptureFacts> capture; ///< null: a scene is open, not a capture
  std::vector<CameraTrackHandle> tracks;       ///< flown cameras, which are among `cameras`
  CameraPose pose;                             ///< of the camera at this frame
  bool recording = false;
  int recordedFrames = 0; ///< poses of the recording so far
  RequestId opened = 0;   ///< the request that opened the scene
  LatestRequests taken;   ///< that were taken up before this
  /// Kinds of requests since which what is on show is not exact; empty: it is.
  std::vector<RequestKind> inexactSince;
  /// Counts the changes of what frames are a function of: what was known of frames is no longer true then.
  std::uint64_t shotVersion = 0;
};

/// What long work is for.
enum class WorkKind {
  None, ///< nothing is under way
  Opening,
  Replay,
  Comparing, ///< draws the frame to compare with
  Stages,    ///< measures what they cost
  Traces,
  Reference,
  OverTime,
  Metrics,
  Lineage,
  Verdict,
  Export
};

/// Long work under way.
struct Work {
  WorkKind kind = WorkKind::None;
  std::string what{}; ///< for people; empty: nothing is under way
  int done = 0, total = 0;
};

/// Something that could not be done: a sentence for people, and what it answers. Nothing else was lost, but
/// for an end.
struct Failure {
  std::string sentence;
  RequestKind kind = RequestKind::None;
  RequestId request = 0;                     ///< the latest of its kind that was taken up
  std::optional<SceneBudget> neededBudget{}; ///< that lets in a scene that asks for more than it may
  bool isChoice = false;                     ///< the shot has no such camera, object, animation or length
  bool isEnd = false; ///< nothing is drawn from now on, as without OpenGL; it answers all that follows, too
};

/// Shaders were read anew.
struct ShadersRead {
  std::string error; ///< what does not compile, with file and line; empty: they are in use
};

/// Where objects are seen on a frame.
struct ObjectArea {
  std::vector<int> objects;  ///< that were asked for, by their numbers
  int frame = 0, pixels = 0; ///< 0: not seen
  glm::ivec2 pixel{0};       ///< one of them, near their middle
  gl::Rect box;
};

/// One of the worst pixels of the frame on show.
struct WorstDelivery {
  int frame = 0;
  FoundWorst found;
};

/// What the active probe's pixel is made of.
struct LineageDelivery {
  Probe probe{};                            ///< whose
  int frame = 0;                            ///< on show
  std::shared_ptr<const Lineage> lineage{}; ///< null: the probe is not in its picture
  std::uint64_t shotVersion = 0;            ///< see Status
};

/// What is wrong with a probe's pixel. It comes once with the verdict, where something is wrong once more
/// with what corrects it, and where something does a third time with what that costs the picture.
struct VerdictDelivery {
  int frame = 0;
  glm::ivec2 pixel{0};
  std::uint64_t shotVersion = 0;        ///< see Status
  std::optional<VerdictAnswer> answer;  ///< nothing: `whyNot` says why
  std::optional<RemedyAnswer> remedies; ///< nothing: they are to come, or `whyNot` says why they do not
  std::string whyNot;
};

/// Those that arrive together are taken in this order.
using Result = std::variant<Failure, Status, Work, ViewResult, ProbeResult, VerdictDelivery, FrameProfile,
                            StageCosts, TraceDelivery, Thumbnail, FrameMetrics, ShadersRead, ExportResult,
                            StageShares, LineageDelivery, WorstDelivery, ObjectArea>;

/// A result, and the request that it answers: the latest of its kind that was taken up.
struct Answer {
  RequestId request = 0;
  Result result;
};

/// Called on the render thread; must return soon (post to your own thread). Results are values.
using Listener = std::function<void(Answer)>;

} // namespace taa
