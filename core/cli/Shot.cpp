#include "core/cli/Shot.h"

#include "core/base/Error.h"
#include "core/base/OldNames.h"
#include "core/base/Text.h"
#include "core/capture/source/Capture.h"
#include "core/cli/Terminal.h"
#include "core/io/SessionFile.h"
#include "core/render/CaptureFacts.h"
#include "core/scene/SceneSource.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

// The session's, with --set on top.
ShotPlan planSession(const ShotArguments& arguments) {
  const SessionFile session = readSession(arguments.session);
  ObjectFilter filter = session.filter; // and what is said besides
  filter.hidden.insert(filter.hidden.end(), arguments.filter.hidden.begin(), arguments.filter.hidden.end());
  if (!arguments.filter.isolated.empty()) filter.isolated = arguments.filter.isolated;
  ShotPlan plan{session.source,        session.camera,  session.size, {},
                session.motionModes,   session.track,   filter,       session.frame,
                session.objectClasses, session.restarts};
  std::vector<SessionLane> lanes{session.settings};
  lanes.insert(lanes.end(), session.lanes.begin(), session.lanes.end());
  for (const SessionLane& lane : lanes) {
    const std::string name(1, static_cast<char>('A' + plan.lanes.size()));
    plan.lanes.push_back({lanes.size() > 1 ? name : "", lane.preset, lane.settings});
  }
  assign(plan.lanes, arguments.assignments);
  for (const MotionOverride& mode : motionModesOf(arguments)) plan.motionModes.push_back(mode);
  for (const ClassOverride& given : objectClassesOf(arguments)) plan.objectClasses.push_back(given);
  plan.restarts.insert(plan.restarts.end(), arguments.restarts.begin(), arguments.restarts.end());
  plan.notes = session.notes;
  plan.choice = session.choice;
  if (!arguments.choice.animation.empty()) plan.choice.animation = arguments.choice.animation;
  if (arguments.choice.frames > 0) plan.choice.frames = arguments.choice.frames;
  return plan;
}

void requireBuiltin(const std::string& source) {
  if (!isBuiltinScene(source)) return;
  std::vector<std::string> known;
  for (const BuiltinScene& scene : builtinScenes()) known.push_back("builtin:" + scene.id);
  if (std::ranges::find(known, source) == known.end())
    throw UsageError("there is no built-in scene \"" + source + "\"; there are " + joined(known));
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
  if (!arguments.session.empty()) return planSession(arguments);
  if (arguments.source.empty()) throw UsageError("SOURCE is required, or --session FILE instead of it");
  requireBuiltin(arguments.source);
  const bool isSizeAsked = !arguments.size.empty();
  return {arguments.source,
          arguments.camera,
          parseSize(isSizeAsked ? arguments.size : kDefaultSize),
          lanesOf(arguments),
          motionModesOf(arguments),
          cameraTrackOf(arguments),
          arguments.filter,
          -1,
          objectClassesOf(arguments),
          arguments.restarts,
          isSizeAsked,
          {},
          arguments.choice};
}

namespace {

// What would have no effect is refused: nobody shall believe that it had one.
void checkForCapture(const CaptureFacts& captured, const ShotArguments& arguments, const ShotPlan& plan) {
  if (plan.isSizeAsked && plan.size != captured.outputPx)
    throw UsageError("--size " + arguments.size + ": " + whyOneSize(captured));
  if (!plan.motionModes.empty()) throw UsageError("--motion-mode: " + whyNoScene());
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
  inspector.shot().open(plan.source, progress, plan.choice);
  if (const auto captured = inspector.shot().capture()) checkForCapture(*captured, arguments, plan);
  if (!plan.camera.empty()) inspector.shot().setCamera(plan.camera);
  if (plan.track) inspector.shot().setCameraTrack(*plan.track);
  inspector.shot().setMotionModes(plan.motionModes);
  inspector.shot().setObjectFilter(plan.filter);
  inspector.shot().setObjectClasses(plan.objectClasses);
  inspector.shot().setRestarts(plan.restarts);
  for (const std::string& warning : inspector.shot().scene().warnings) tell("warning", warning);
}

void requireFrame(const Inspector& inspector, int frame) {
  const int last = inspector.shot().frameCount() - 1;
  if (frame > last)
    throw UsageError("there is no frame " + std::to_string(frame) + ": " + inspector.shot().source() +
                     " has frames 0 to " + std::to_string(last));
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
