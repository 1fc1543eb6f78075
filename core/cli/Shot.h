// Opens an Inspector on what the command line asks for.
#pragma once

#include "core/cli/Arguments.h"
#include "core/inspect/Inspector.h"
#include "core/report/ProbeReport.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace taa::cli {

/// Cameras, objects and frames of what is not open yet, so that they may not be there.
struct ShotWishes {
  std::string camera; ///< empty: the scene's own
  std::optional<CameraTrack> track;
  std::vector<MotionOverride> motionModes;
  ObjectFilter filter;
  std::vector<ClassOverride> objectClasses;
  std::vector<int> restarts;
};

/// Everything about `arguments` that can be wrong before a scene is opened, read once.
struct ShotPlan {
  std::string session; ///< the file; empty: none
  std::string source;
  glm::ivec2 size{0};
  bool isSizeAsked = false; ///< by the caller, not by a session or as the default
  std::vector<LaneChoice> lanes;
  ShotWishes ofSession, ofCall;
  int frame = -1; ///< of the session; −1: none is said
  ShotChoice choice;
  bool isChoiceAsked = false;     ///< by the caller, as far as it can be wrong
  std::vector<std::string> notes; ///< to say of the session
};
ShotPlan planShot(const ShotArguments& arguments);

/// Those of the session with those of the call on top.
ShotWishes wishesOf(const ShotPlan& plan);

/// Says on stderr, each once, which names that were given have changed: `notes` and those of the lanes.
void sayNotes(std::vector<std::string> notes, const std::vector<LaneChoice>& lanes);

/// Opens source, camera, size and lanes; the plan's notes and the scene's warnings go to stderr. Throws
/// Error, Cancelled.
void openShot(Inspector& inspector, const ShotArguments& arguments, const ShotPlan& plan,
              const Progress& progress);

/// Throws UsageError that names the frames there are, Error where `frame` is that of the session.
void requireFrame(const Inspector& inspector, const ShotPlan& plan, int frame);
/// Throws UsageError that names the size of the picture.
void requirePixel(const Inspector& inspector, const glm::ivec2& pixel);

/// What was rendered, on which driver.
ShotFacts shotFacts(const Inspector& inspector);
nlohmann::ordered_json shotJson(const Inspector& inspector);

/// A lane's name, preset, settings and where in the jitter pattern its frame lies.
LaneFacts laneFacts(const Inspector& inspector, const LaneChoice& choice, int lane);
nlohmann::ordered_json laneJson(const Inspector& inspector, const LaneChoice& choice, int lane);

} // namespace taa::cli
