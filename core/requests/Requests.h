// What the render thread can be asked for: one plain struct for each request, and what is to be known of its
// type.
#pragma once

#include "core/inspect/WorstOfShot.h"
#include "core/measure/Metrics.h"
#include "core/picture/ViewRequest.h"
#include "core/probe/Probe.h"
#include "core/report/SequenceExport.h"
#include "core/requests/Playback.h"
#include "core/requests/RequestKinds.h"
#include "core/scene/MotionMode.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/SceneCost.h"
#include "core/scene/ShotChoice.h"
#include "core/scene/camera/CameraTrack.h"
#include "core/scene/camera/FlightRecording.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace taa {

/// When a request is taken up among those that are taken up together; within a turn, as they were asked for.
enum class Turn {
  First,
  Views, ///< before a source, so that its first frame exposes what is shown and the resolve is compiled once
  Source,
  Shot,
  Flight,
  Time,
  Rest
};
inline constexpr Turn kTurns[] = {Turn::First,  Turn::Views, Turn::Source, Turn::Shot,
                                  Turn::Flight, Turn::Time,  Turn::Rest};

/// What is to be known of a type of requests. Of one that waits a newer one of its type takes the place.
struct RequestRule {
  RequestKind kind = RequestKind::None;
  Turn turn = Turn::Rest;
  bool endsReplay = false; ///< going to a frame is of no use any more once it is taken up
  /// It is asked of the scene that is open: another source makes it void, unless that is refused.
  bool isOfScene = false;
  bool addsUp = false; ///< each one counts, also while others of its type wait
};

/// A request says by `using Overrides = std::tuple<…>` which others that wait are void once it is there.
namespace request {

/// What was asked of the scene before counts where this one is refused.
struct Open {
  std::string source;
  ShotChoice choice{};
  std::optional<SceneBudget> budget{}; ///< what this scene may ask for; else what SetSceneBudget says
  static constexpr RequestRule kRule{.kind = RequestKind::Source, .turn = Turn::Source, .endsReplay = true};
};

struct SetSize {
  int width = 0, height = 0;
  static constexpr RequestRule kRule{.kind = RequestKind::Size, .turn = Turn::Shot, .endsReplay = true};
};

struct SetMotionModes {
  std::vector<MotionOverride> modes;
  static constexpr RequestRule kRule{
      .kind = RequestKind::MotionModes, .turn = Turn::Shot, .endsReplay = true, .isOfScene = true};
};

/// Compiles what these will need beside the frames: somebody looks at a choice and may take it.
struct Prepare {
  Settings settings;
  static constexpr RequestRule kRule{};
};

/// Answered at once on the old history, then exactly.
struct SetSettings {
  Settings settings;
  using Overrides = std::tuple<Prepare>;
  static constexpr RequestRule kRule{.kind = RequestKind::Settings, .turn = Turn::Shot, .endsReplay = true};
};

/// Settings of the lanes after the first, to compare with: at most kMaxLanes − 1. At once without history,
/// then exactly.
struct SetOtherLanes {
  std::vector<Settings> lanes;
  static constexpr RequestRule kRule{.kind = RequestKind::Lanes, .turn = Turn::Shot, .endsReplay = true};
};

struct SetObjectFilter {
  ObjectFilter filter;
  static constexpr RequestRule kRule{
      .kind = RequestKind::Objects, .turn = Turn::Shot, .endsReplay = true, .isOfScene = true};
};

struct SetObjectClasses {
  std::vector<ClassOverride> classes;
  static constexpr RequestRule kRule{
      .kind = RequestKind::Classes, .turn = Turn::Shot, .endsReplay = true, .isOfScene = true};
};

/// Frames at which history starts anew.
struct SetRestarts {
  std::vector<int> frames;
  static constexpr RequestRule kRule{
      .kind = RequestKind::Restarts, .turn = Turn::Shot, .endsReplay = true, .isOfScene = true};
};

/// Looks from there, from now on; while it plays, from the next frame on.
struct Fly {
  CameraPose pose;
  FlightRecording::Clock::duration took{0}; ///< it was moving for so long
  FlightRecording::Clock::time_point at{};  ///< it got there; set when it is posted
  static constexpr RequestRule kRule{.kind = RequestKind::Flight,
                                     .turn = Turn::Flight,
                                     .endsReplay = true,
                                     .isOfScene = true,
                                     .addsUp = true};
};

/// Plays, and keeps where the camera is flown from now on, as a camera "Recorded N" with a pose for each
/// frame that goes by on the clock, however many of them can be shown. Ended by a pause, a jump or the last
/// frame; then goes to the frame that it ended at.
struct SetRecording {
  bool on = false;
  FlightRecording::Clock::time_point at{}; ///< set when it is posted
  static constexpr RequestRule kRule{.kind = RequestKind::Recording,
                                     .turn = Turn::Flight,
                                     .endsReplay = true,
                                     .isOfScene = true,
                                     .addsUp = true};
};

struct SetCamera {
  std::string name;
  using Overrides = std::tuple<Fly>;
  static constexpr RequestRule kRule{
      .kind = RequestKind::Camera, .turn = Turn::Shot, .endsReplay = true, .isOfScene = true};
};

/// Looks through the last one.
struct AddCameraTrack {
  CameraTrack track;
  using Overrides = std::tuple<Fly, SetCamera>;
  static constexpr RequestRule kRule{.kind = RequestKind::FlownCameras,
                                     .turn = Turn::Shot,
                                     .endsReplay = true,
                                     .isOfScene = true,
                                     .addsUp = true};
};

/// Instead of all flown cameras there are. What cannot be is answered by a Failure.
struct SetFlownCameras {
  FlownCameras cameras;
  using Overrides = std::tuple<Fly, SetCamera, AddCameraTrack>;
  static constexpr RequestRule kRule{
      .kind = RequestKind::FlownCameras, .turn = Turn::Shot, .endsReplay = true, .isOfScene = true};
};

/// Says where these are seen, again for each frame that it rests at; none: no longer.
struct Locate {
  std::vector<int> objects;
  static constexpr RequestRule kRule{.kind = RequestKind::Objects, .turn = Turn::Shot, .isOfScene = true};
};

struct SetPlaying {
  bool playing = false;
  static constexpr RequestRule kRule{.kind = RequestKind::Time, .turn = Turn::Time};
};

/// At the end: start again, or pause.
struct SetLooping {
  bool looping = true;
  static constexpr RequestRule kRule{.kind = RequestKind::Time, .turn = Turn::First};
};

struct SetPlayback {
  Playback playback;
  static constexpr RequestRule kRule{.kind = RequestKind::Time, .turn = Turn::First};
};

/// Relative; steps add up while they wait; pauses.
struct Step {
  int frames = 0;
  using Overrides = std::tuple<SetPlaying>;
  static constexpr RequestRule kRule{
      .kind = RequestKind::Time, .turn = Turn::Time, .endsReplay = true, .isOfScene = true, .addsUp = true};
};

/// The nearest cached frame at once, then exactly this one; clamped to the shot.
struct Seek {
  int frame = 0;
  using Overrides = std::tuple<Step>;
  static constexpr RequestRule kRule{
      .kind = RequestKind::Time, .turn = Turn::Time, .endsReplay = true, .isOfScene = true};
};

struct SetViews {
  std::vector<ViewRequest> views;
  static constexpr RequestRule kRule{.kind = RequestKind::Views, .turn = Turn::Views};
};

/// Stay: each is delivered again for each new frame until it is taken back.
struct SetProbes {
  std::vector<Probe> all;
  int active = -1;                  ///< of which more is wanted
  bool whatIf = false;              ///< also the active pixel under other choices, and what moves it
  std::optional<OtherSide> other{}; ///< that the active pixel comes with, whatever its row
  bool reference = false;           ///< has the first lane's reference drawn, so that pixels come with it
  static constexpr RequestRule kRule{.kind = RequestKind::Probes};
};

struct SetCheckpointBudget {
  std::size_t bytes = 0;
  static constexpr RequestRule kRule{.kind = RequestKind::None, .turn = Turn::First};
};

/// What scenes may ask for that are opened from now on.
struct SetSceneBudget {
  SceneBudget budget;
  static constexpr RequestRule kRule{.kind = RequestKind::None, .turn = Turn::First};
};

/// Times every pass from now on, which costs; a profile of each frame made is delivered.
struct SetProfiling {
  bool on = false;
  static constexpr RequestRule kRule{.kind = RequestKind::Profile};
};

/// Measures what each stage's settings cost on the frame on show; playing waits for it.
struct MeasureStages {
  static constexpr RequestRule kRule{.kind = RequestKind::Profile};
};

/// Pictures of the stages at this size, drawn only while nothing else is to be done; 0: none.
struct SetThumbnails {
  int width = 0, height = 0;
  static constexpr RequestRule kRule{.kind = RequestKind::Thumbnails};
};

/// Where a resolve takes so long, each change of settings is first shown by few of the pixels of each view,
/// and those that a newer change follows at once by them alone. Nothing: no previews.
struct SetPreviews {
  std::optional<double> fromMs;
  static constexpr RequestRule kRule{.kind = RequestKind::None, .turn = Turn::First};
};

/// How many samples a reference has, 4 to 1024. It is drawn while nothing plays and nothing else is to be
/// done, as long as a view shows a row of it or metrics need it; the views see it with 4, 16, 64 …
struct SetReferenceSamples {
  int samples = 0;
  static constexpr RequestRule kRule{.kind = RequestKind::Reference};
};

/// Says where the frame on show is worst, by what a row shows of it (see WorstOfShot::next()).
struct FindWorst {
  IntermediateId row = IntermediateId::referenceErrorAbs;
  int lane = 0;
  std::optional<glm::ivec2> after; ///< the next one after this pixel; nothing: the worst
  WorstStep step = WorstStep::Pixel;
  static constexpr RequestRule kRule{.kind = RequestKind::Worst, .isOfScene = true};
};

/// Metrics of each new frame on show, of each lane, played or not; again when its reference has come on. They
/// cost a run of the resolve a frame. Those of the other frames that are played come in idle time, of the
/// first lane, the nearest first. None: an empty list.
struct SetMetrics {
  std::vector<Metric> metrics;
  static constexpr RequestRule kRule{.kind = RequestKind::Metrics};
};

/// From now on what is at the probes in each exact frame on show is delivered as a trace, too.
struct SetTracing {
  bool on = false;
  static constexpr RequestRule kRule{.kind = RequestKind::Traces};
};

/// Also in the frames from `first` to `last` that were not shown, while nothing plays: what is shown stays.
struct FillTraces {
  int first = 0, last = 0;
  static constexpr RequestRule kRule{.kind = RequestKind::Traces};
};

/// The frames from `first` to `last` are filled in where nothing else is to be done, until it is cancelled;
/// `last` before `first`: none.
struct TraceInIdleTime {
  int first = 0, last = -1;
  static constexpr RequestRule kRule{.kind = RequestKind::Traces};
};

/// From now on the samples that the active probe's pixel is made of are delivered, of each exact frame on
/// show that is not played, in the first lane.
struct SetLineage {
  int frames = 0; ///< how far back, with the frame itself, at most kMaxLineageFrames; 0: no longer
  static constexpr RequestRule kRule{.kind = RequestKind::Lineage};
};

/// The verdict on the active probe's pixel in each exact frame on show, of the first lane, and after that
/// what corrects it: both are made while nothing plays and nothing else is to be done.
struct SetVerdicts {
  bool on = false;
  static constexpr RequestRule kRule{.kind = RequestKind::Verdicts};
};

struct ReloadShaders {
  static constexpr RequestRule kRule{.kind = RequestKind::Shaders, .turn = Turn::Views, .endsReplay = true};
};

/// Other requests wait until it is done; Cancel stops it.
struct ExportSequence {
  SequenceRequest sequence;
  static constexpr RequestRule kRule{.kind = RequestKind::Export};
};

/// Stops the long work under way, and what waits to be begun.
struct Cancel {
  using Overrides = std::tuple<MeasureStages, FillTraces, ExportSequence>;
  static constexpr RequestRule kRule{.kind = RequestKind::None, .turn = Turn::First, .endsReplay = true};
};

} // namespace request

using Request =
    std::variant<request::Open, request::SetSize, request::SetMotionModes, request::Prepare,
                 request::SetSettings, request::SetOtherLanes, request::SetObjectFilter,
                 request::SetObjectClasses, request::SetRestarts, request::Fly, request::SetRecording,
                 request::SetCamera, request::AddCameraTrack, request::SetFlownCameras, request::Locate,
                 request::SetPlaying, request::SetLooping, request::SetPlayback, request::Step, request::Seek,
                 request::SetViews, request::SetProbes, request::SetCheckpointBudget, request::SetSceneBudget,
                 request::SetProfiling, request::MeasureStages, request::SetThumbnails, request::SetPreviews,
                 request::SetReferenceSamples, request::FindWorst, request::SetLineage, request::SetMetrics,
                 request::SetTracing, request::FillTraces, request::TraceInIdleTime, request::SetVerdicts,
                 request::ReloadShaders, request::Cancel, request::ExportSequence>;

inline const RequestRule& ruleOf(const Request& request) {
  return std::visit([](const auto& each) -> const RequestRule& { return each.kRule; }, request);
}

} // namespace taa
