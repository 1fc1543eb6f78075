#include "core/cli/Shot.h"

#include "core/base/Error.h"
#include "core/base/OldNames.h"
#include "core/capture/source/Capture.h"
#include "core/cli/PlanChecks.h"
#include "core/cli/Terminal.h"
#include "core/io/SessionFile.h"
#include "core/render/CaptureFacts.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

ShotWishes wishesOfCall(const ShotArguments& arguments) {
  return {.camera = arguments.camera,
          .track = cameraTrackOf(arguments),
          .motionModes = motionModesOf(arguments),
          .filter = arguments.filter,
          .objectClasses = objectClassesOf(arguments),
          .restarts = arguments.restarts};
}

// The session's, with --set on top.
void planSession(const ShotArguments& arguments, ShotPlan& plan) {
  const SessionFile session = readSession(arguments.session);
  plan.session = arguments.session;
  plan.source = session.source;
  plan.size = session.size;
  plan.frame = session.frame;
  plan.notes = session.notes;
  plan.ofSession = {session.camera, session.track,         session.motionModes,
                    session.filter, session.objectClasses, session.restarts};
  std::vector<SessionLane> lanes{session.settings};
  lanes.insert(lanes.end(), session.lanes.begin(), session.lanes.end());
  for (const SessionLane& lane : lanes) {
    const std::string name(1, static_cast<char>('A' + plan.lanes.size()));
    plan.lanes.push_back({lanes.size() > 1 ? name : "", lane.preset, lane.settings});
  }
  assign(plan.lanes, arguments.assignments);
  plan.choice = session.choice;
  // An animation that is the session's is its fault, whatever length the call gives.
  if (!session.choice.animation.empty()) plan.isChoiceAsked = !arguments.choice.animation.empty();
  if (!arguments.choice.animation.empty()) plan.choice.animation = arguments.choice.animation;
  if (arguments.choice.frames > 0) plan.choice.frames = arguments.choice.frames;
}

void requireBuiltin(const std::string& source) {
  if (!isBuiltinScene(source)) return;
  try {
    requireBuiltinScene(source);
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
}

/// The driver knows which sizes it draws.
void setAskedSize(Inspector& inspector, const ShotPlan& plan) {
  try {
    inspector.shot().setSize(plan.size.x, plan.size.y);
  } catch (const Error& error) {
    if (!plan.isSizeAsked) throw;
    throw UsageError(std::string("--size: ") + error.what());
  }
}

} // namespace

ShotPlan planShot(const ShotArguments& arguments) {
  ShotPlan plan;
  plan.ofCall = wishesOfCall(arguments);
  plan.isChoiceAsked = arguments.choice != ShotChoice{};
  if (!arguments.session.empty()) {
    planSession(arguments, plan);
    return plan;
  }
  if (arguments.source.empty()) throw UsageError("SOURCE is required, or --session FILE instead of it");
  requireBuiltin(arguments.source);
  plan.source = arguments.source;
  plan.isSizeAsked = !arguments.size.empty();
  plan.size = parseSize(plan.isSizeAsked ? arguments.size : kDefaultSize);
  plan.lanes = lanesOf(arguments);
  plan.choice = arguments.choice;
  return plan;
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

namespace {

// What would have no effect is refused: nobody shall believe that it had one.
void checkForCapture(const CaptureFacts& captured, const ShotArguments& arguments, const ShotPlan& plan) {
  if (plan.isSizeAsked && plan.size != captured.outputPx)
    throw UsageError("--size " + arguments.size + ": " + whyOneSize(captured));
  for (const std::string& assignment : arguments.assignments) {
    const Parameter& row = parameter(std::string_view(assignment).substr(0, assignment.find('=')));
    if (isFixedBy(captured, row)) throw UsageError("--set " + assignment + ": " + whyFixed(row));
  }
}

} // namespace

void sayNotes(std::vector<std::string> notes, const std::vector<LaneChoice>& lanes) {
  for (const LaneChoice& lane : lanes) addNotes(notes, lane.notes);
  for (const std::string& note : notes) tell("note", note);
}

void openShot(Inspector& inspector, const ShotArguments& arguments, const ShotPlan& plan,
              const Progress& progress) {
  sayNotes(plan.notes, plan.lanes);
  std::vector<Settings> settings;
  for (const LaneChoice& lane : plan.lanes) settings.push_back(lane.settings);
  inspector.shot().setCheckpointBudget(static_cast<std::size_t>(arguments.checkpointsMiB) << 20);
  inspector.shot().setSceneBudget(sceneBudget(arguments.sceneMillions, arguments.sceneMiB));
  inspector.shot().setLanes(settings);
  const bool isCaptured = !isBuiltinScene(plan.source) && capture::isCapture(plan.source);
  if (!isCaptured) setAskedSize(inspector, plan);
  openChosen(plan, [&] { inspector.shot().open(plan.source, progress, plan.choice); });
  const auto captured = inspector.shot().capture();
  if (captured) checkForCapture(*captured, arguments, plan);
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
  requireFrame(plan, inspector.shot().source(), inspector.shot().frameCount(), frame);
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

LaneFacts laneFacts(const Inspector& inspector, const LaneChoice& choice, int lane) {
  return {choice.name, choice.preset, inspector.shot().usedSettings(lane), inspector.shot().info(lane)};
}

ordered_json laneJson(const Inspector& inspector, const LaneChoice& choice, int lane) {
  return taa::laneJson(laneFacts(inspector, choice, lane));
}

} // namespace taa::cli
