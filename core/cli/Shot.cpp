#include "core/cli/Shot.h"

#include "core/base/OldNames.h"
#include "core/capture/source/Capture.h"
#include "core/cli/Terminal.h"
#include "core/io/CameraTrackJson.h"
#include "core/io/SessionFile.h"
#include "core/render/CaptureFacts.h"
#include "core/render/FrameClock.h"
#include "core/replay/Checkpoints.h"
#include "core/scene/Pose.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Lanes.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

constexpr std::string_view kMotionPrefix = "motion."; ///< of assignments that are for an object

/// Returns that of the camera.
CLI::Option* addSceneOptions(CLI::App& command, ShotOptions& shot) {
  CLI::Option* camera =
      command.add_option("--camera", shot.camera,
                         "still, pan, orbit, dolly or gltf:NAME; else the scene's own. A captured "
                         "sequence has no other than that it was taken with");
  CLI::Option* pose =
      command
          .add_option("--camera-pose", shot.cameraPose,
                      "x,y,z,yaw,pitch or with the field of view after them: a camera that rests there; "
                      "degrees, yaw 0 looks along -z")
          ->excludes(camera);
  command.add_option("--camera-path", shot.cameraPath, "A .json file with a pose for each frame")
      ->type_name("FILE")
      ->excludes(camera)
      ->excludes(pose);
  command.add_option("--animation", shot.choice.animation,
                     "Of a file with several: the one that plays, by its name, or all; else the first");
  command
      .add_option("--length", shot.choice.frames,
                  "How many frames the shot has, 1 to 100000; else as many as the scene's own")
      ->check(CLI::Range(1, kMaxShotFrames));
  command
      .add_option("--hide", shot.filter.hidden,
                  "Do not draw the objects of this name and what is below them; repeat it for more")
      ->allow_extra_args(false);
  command
      .add_option("--isolate", shot.filter.isolated,
                  "Draw only the objects of this name and what is below them; repeat it for more")
      ->allow_extra_args(false);
  command
      .add_option(
          "--motion-mode", shot.motionModes,
          "NODE=MODE: motion of the objects of this name; perObject, cameraOnly or none; repeat it for "
          "more")
      ->allow_extra_args(false);
  command
      .add_option("--class", shot.classes,
                  "OBJECT=CLASS: class of the objects of this name and of what is below them; still, moving, "
                  "deforming or character; repeat it for more")
      ->allow_extra_args(false);
  command
      .add_option("--restart", shot.restarts,
                  "A frame at which history starts anew, as after a cut; repeat it for more")
      ->check(CLI::Range(0, kMaxShotFrames - 1))
      ->allow_extra_args(false);
  return camera;
}

/// To every lane; motion modes are of objects.
void assign(std::vector<LaneChoice>& lanes, const std::vector<std::string>& assignments) {
  for (LaneChoice& lane : lanes)
    for (const std::string& assignment : assignments) {
      if (assignment.starts_with(kMotionPrefix)) continue;
      addNotes(lane.notes, readOption("--set", [&] { return applyAssignment(lane.settings, assignment); }));
    }
}

std::vector<ClassOverride> objectClassesOf(const ShotOptions& options) {
  std::vector<ClassOverride> classes;
  for (const std::string& text : options.classes)
    classes.push_back(readOption("--class", [&] { return parseClassOverride(text); }));
  return classes;
}

ShotWishes wishesOfCall(const ShotOptions& options) {
  return {.camera = options.camera,
          .track = cameraTrackOf(options),
          .motionModes = motionModesOf(options),
          .filter = options.filter,
          .objectClasses = objectClassesOf(options),
          .restarts = options.restarts};
}

// The session's, with --set on top.
void planSession(const ShotOptions& options, ShotPlan& plan) {
  const SessionFile session = readSession(options.session);
  plan.source = session.source;
  plan.size = session.size;
  plan.sessionFrame = session.frame;
  plan.notes = session.notes;
  plan.ofSession = {session.camera, session.track,         session.motionModes,
                    session.filter, session.objectClasses, session.restarts};
  std::vector<SessionLane> lanes{session.settings};
  lanes.insert(lanes.end(), session.lanes.begin(), session.lanes.end());
  for (const SessionLane& lane : lanes) {
    const std::string name(1, static_cast<char>('A' + plan.lanes.size()));
    plan.lanes.push_back({lanes.size() > 1 ? name : "", lane.preset, lane.settings});
  }
  assign(plan.lanes, options.assignments);
  plan.choice = session.choice;
  // An animation that is the session's is its fault, whatever length the call gives.
  if (!session.choice.animation.empty()) plan.isChoiceAsked = !options.choice.animation.empty();
  if (!options.choice.animation.empty()) plan.choice.animation = options.choice.animation;
  if (options.choice.frames > 0) plan.choice.frames = options.choice.frames;
}

/// The driver knows which sizes it draws.
void setAskedSize(Inspector& inspector, const ShotPlan& plan) {
  const auto set = [&] { inspector.shot().setSize(plan.size.x, plan.size.y); };
  if (plan.options.size.empty()) {
    set();
    return;
  } // a session's, or the default
  readOption("--size", set);
}

/// Refuses what `flag`, or the session's field for the same, says.
using Refuse = std::function<void(std::string_view flag, const std::string& reason)>;

void refuseCall(std::string_view flag, const std::string& reason) {
  throw UsageError(std::string(flag) + ": " + reason);
}

Refuse refuseSession(const ShotPlan& plan) {
  return [&plan](std::string_view, const std::string& reason) {
    throw Error(sessionRefusal(plan.options.session, reason));
  };
}

void check(const ShotWishes& wishes, const OpenedShot& opened, const Refuse& refuse) {
  const auto require = [&](std::string_view flag, bool isSaid, const auto& action) {
    if (isSaid) try {
        if (!opened.scene) throw Error(whyNoScene());
        action(*opened.scene);
      } catch (const Error& error) {
        refuse(flag, error.what());
      }
  };
  const bool isCamera = !wishes.camera.empty() && (opened.scene || wishes.camera != kCaptureCamera);
  require("--camera", isCamera, [&](const Scene& scene) { cameraAt(scene, wishes.camera, 0.0, 1.0f); });
  require("--camera-path", wishes.track.has_value(),
          [&](const Scene& scene) { requireNewCamera(scene, wishes.track->name); });
  require("--motion-mode", !wishes.motionModes.empty(),
          [&](const Scene& scene) { checkMotionOverrides(scene, wishes.motionModes); });
  require("--hide", !wishes.filter.hidden.empty(),
          [&](const Scene& scene) { checkObjectNames(scene, wishes.filter.hidden); });
  require("--isolate", !wishes.filter.isolated.empty(),
          [&](const Scene& scene) { checkObjectNames(scene, wishes.filter.isolated); });
  require("--class", !wishes.objectClasses.empty(),
          [&](const Scene& scene) { checkClassOverrides(scene, wishes.objectClasses); });
  try {
    checkRestarts(wishes.restarts, opened.frames);
  } catch (const Error& error) {
    refuse("--restart", error.what());
  }
}

// What would have no effect is refused: nobody shall believe that it had one.
void checkForCapture(const CaptureFacts& captured, const ShotPlan& plan) {
  if (!plan.options.size.empty() && plan.size != captured.outputPx)
    throw UsageError("--size " + plan.options.size + ": " + whyOneSize(captured));
  for (const std::string& assignment : plan.options.assignments) {
    const Parameter& row = parameter(std::string_view(assignment).substr(0, assignment.find('=')));
    if (isFixedBy(captured, row)) throw UsageError("--set " + assignment + ": " + whyFixed(row));
  }
}

} // namespace

void addShotOptions(CLI::App& command, ShotOptions& shot) {
  CLI::Option* source =
      command.add_option("SOURCE", shot.source,
                         "A glTF file (.gltf, .glb), the folder or the .json of a captured sequence, or "
                         "builtin:NAME (see list scenes)");
  CLI::Option* size =
      command.add_option("--size", shot.size,
                         "Size of the picture, WxH pixels; else " + std::string(kDefaultSize) +
                             ", and of a captured sequence its own, which is the only one it has");
  CLI::Option* camera = addSceneOptions(command, shot);
  CLI::Option* preset =
      command.add_option("--preset", shot.preset, "A preset (see list presets) or a .json file")
          ->capture_default_str();
  CLI::Option* lane =
      command
          .add_option("--lane", shot.lanes, "A preset; repeat it to run up to five side by side, as A to E")
          ->allow_extra_args(false)
          ->excludes(preset);
  CLI::Option* session = command.add_option(
      "--session", shot.session,
      "A session of taa-inspector (.taa.json): its scene, camera, frame, size and settings");
  for (CLI::Option* instead : {source, size, camera, preset, lane}) session->excludes(instead);
  command.add_option("--checkpoints", shot.checkpointsMiB, "Memory for the histories that are kept, MiB")
      ->check(CLI::Range(0, kMaxCheckpointMiB))
      ->capture_default_str();
  addSceneBudget(command, shot.sceneMillions, shot.sceneMiB);
  command
      .add_option(
          "--set", shot.assignments,
          "path=value (see list parameters), or motion.NODE=MODE (see --motion-mode); repeat it for more")
      ->allow_extra_args(false);
}

void addSceneBudget(CLI::App& command, int& millions, int& mib) {
  command
      .add_option("--scene-triangles", millions,
                  "Triangles that a scene may draw, its instances counted, millions; one with more is not "
                  "opened")
      ->check(CLI::Range(1, kMaxSceneMillions))
      ->capture_default_str();
  command.add_option("--scene-memory", mib, "Memory for the buffers and textures of a scene, MiB")
      ->check(CLI::Range(1, kMaxSceneMiB))
      ->capture_default_str();
}

std::vector<MotionOverride> motionModesOf(const ShotOptions& options) {
  std::vector<MotionOverride> modes;
  const auto add = [&](const std::string& text, const char* flag) {
    modes.push_back(readOption(flag, [&] { return parseMotionOverride(text); }));
  };
  for (const std::string& text : options.motionModes) add(text, "--motion-mode");
  for (const std::string& text : options.assignments)
    if (text.starts_with(kMotionPrefix)) add(text.substr(kMotionPrefix.size()), "--set");
  return modes;
}

std::optional<CameraTrack> cameraTrackOf(const ShotOptions& options) {
  if (!options.cameraPath.empty()) return readCameraTrack(options.cameraPath);
  if (options.cameraPose.empty()) return {};
  return readOption("--camera-pose", [&] {
    return CameraTrack{kFreeCamera, 0, {parseCameraPose(options.cameraPose)}};
  });
}

LaneChoice laneOfPreset(const std::string& name, const std::string& preset) {
  // A name that is wrong is the caller's mistake; a file that cannot be read is the world's.
  try {
    const Preset row = taa::preset(preset);
    return {name, preset, row.settings, row.notes};
  } catch (const Error& error) {
    if (preset.ends_with(".json")) throw;
    throw UsageError(error.what());
  }
}

std::vector<LaneChoice> lanesOf(const ShotOptions& options) {
  if (options.lanes.size() > std::size_t{kMaxLanes})
    throw UsageError("--lane was given " + std::to_string(options.lanes.size()) + " times; there are " +
                     std::to_string(kMaxLanes) + " lanes at most");
  std::vector<LaneChoice> lanes;
  for (const std::string& name : options.lanes)
    lanes.push_back(laneOfPreset(std::string(1, static_cast<char>('A' + lanes.size())), name));
  if (lanes.empty()) lanes.push_back(laneOfPreset("", options.preset));
  if (lanes.size() == 1) lanes[0].name.clear();
  assign(lanes, options.assignments);
  return lanes;
}

ShotPlan planShot(const ShotOptions& options) {
  ShotPlan plan;
  plan.options = options;
  plan.ofCall = wishesOfCall(options);
  plan.isChoiceAsked = options.choice != ShotChoice{};
  if (!options.session.empty()) {
    planSession(options, plan);
    return plan;
  }
  if (options.source.empty()) throw UsageError("SOURCE is required, or --session FILE instead of it");
  if (isBuiltinScene(options.source)) readOption("", [&] { requireBuiltinScene(options.source); });
  plan.source = options.source;
  plan.size = parseSize(options.size.empty() ? kDefaultSize : options.size);
  plan.lanes = lanesOf(options);
  plan.choice = options.choice;
  return plan;
}

int frameOf(const ShotPlan& plan, int asked) {
  const int frame = asked >= 0 ? asked : plan.sessionFrame;
  if (frame < 0) throw UsageError("--frame is required: the number of a frame, from 0");
  return frame;
}

ShotWishes wishesOf(const ShotPlan& plan) {
  ShotWishes wishes = plan.ofSession;
  const ShotWishes& call = plan.ofCall;
  const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  if (!call.camera.empty()) wishes.camera = call.camera;
  if (call.track) wishes.track = call.track;
  append(wishes.motionModes, call.motionModes);
  append(wishes.filter.hidden, call.filter.hidden);
  if (!call.filter.isolated.empty()) wishes.filter.isolated = call.filter.isolated;
  append(wishes.objectClasses, call.objectClasses);
  append(wishes.restarts, call.restarts);
  return wishes;
}

void sayNotes(std::vector<std::string> notes, const std::vector<LaneChoice>& lanes) {
  for (const LaneChoice& lane : lanes) addNotes(notes, lane.notes);
  for (const std::string& note : notes) tell("note", note);
}

void checkWishes(const ShotPlan& plan, const OpenedShot& opened) {
  check(plan.ofSession, opened, refuseSession(plan));
  check(plan.ofCall, opened, refuseCall);
}

void openChosen(const ShotPlan& plan, const std::function<void()>& open) {
  try {
    open();
  } catch (const ChoiceError& error) {
    if (plan.isChoiceAsked) refuseCall("--animation, --length", error.what());
    refuseSession(plan)("", error.what());
  }
}

void openShot(Inspector& inspector, const ShotPlan& plan, const Progress& progress) {
  const ShotOptions& options = plan.options;
  sayNotes(plan.notes, plan.lanes);
  std::vector<Settings> settings;
  for (const LaneChoice& lane : plan.lanes) settings.push_back(lane.settings);
  inspector.shot().setCheckpointBudget(static_cast<std::size_t>(options.checkpointsMiB) << 20);
  inspector.shot().setSceneBudget(sceneBudget(options.sceneMillions, options.sceneMiB));
  inspector.shot().setLanes(settings);
  const bool isCaptured = !isBuiltinScene(plan.source) && capture::isCapture(plan.source);
  if (!isCaptured) setAskedSize(inspector, plan);
  openChosen(plan, [&] { inspector.shot().open(plan.source, progress, plan.choice); });
  const auto captured = inspector.shot().capture();
  if (captured) checkForCapture(*captured, plan);
  checkWishes(plan, {captured ? nullptr : &inspector.shot().scene(), inspector.shot().frameCount()});
  const ShotWishes wishes = wishesOf(plan);
  if (!wishes.camera.empty()) inspector.shot().setCamera(wishes.camera);
  if (wishes.track) inspector.shot().setCameraTrack(*wishes.track);
  inspector.shot().setMotionModes(wishes.motionModes);
  inspector.shot().setObjectFilter(wishes.filter);
  inspector.shot().setObjectClasses(wishes.objectClasses);
  inspector.shot().setRestarts(wishes.restarts);
  for (const std::string& warning : inspector.shot().scene().warnings) tell("warning", warning);
}

void requireFrame(const Inspector& inspector, const ShotPlan& plan, int frame) {
  const int frames = inspector.shot().frameCount();
  if (frame < frames) return;
  const std::string reason = "there is no frame " + std::to_string(frame) + ": " + inspector.shot().source() +
                             " has frames 0 to " + std::to_string(frames - 1);
  if (frame == plan.sessionFrame) throw Error(sessionRefusal(plan.options.session, reason));
  throw UsageError(reason);
}

void requirePixel(const Inspector& inspector, const glm::ivec2& pixel) {
  const glm::ivec2 size(inspector.shot().width(), inspector.shot().height());
  if (pixel.x >= size.x || pixel.y >= size.y)
    throw UsageError("pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) +
                     " lies outside the picture of " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                     " pixels");
}

ShotFacts shotFacts(const Inspector& inspector) {
  return {inspector.shot().source(), inspector.shot().camera(),
          inspector.shot().driver().renderer + ", " + inspector.shot().driver().version,
          inspector.shot().width(), inspector.shot().height()};
}

ordered_json shotJson(const Inspector& inspector) {
  return taa::shotJson(shotFacts(inspector));
}

LaneFacts laneFacts(const Inspector& inspector, const ShotPlan& plan, int lane) {
  return {plan.lane(lane).name, plan.lane(lane).preset, inspector.shot().usedSettings(lane),
          inspector.shot().info(lane)};
}

ordered_json laneJson(const Inspector& inspector, const ShotPlan& plan, int lane) {
  return taa::laneJson(laneFacts(inspector, plan, lane));
}

std::string laneHeading(const ShotPlan& plan, int lane) {
  const LaneChoice& choice = plan.lane(lane);
  return (lane > 0 ? "\n" : "") +
         (choice.name.empty() ? "" : "LANE " + choice.name + ": " + choice.preset + "\n");
}

} // namespace taa::cli
