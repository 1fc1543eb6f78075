// What a command looks at and with which settings: the options, their values, and an Inspector opened on
// them.
#pragma once

#include "core/cli/Options.h"
#include "core/inspect/Inspector.h"
#include "core/report/ProbeReport.h"
#include "core/scene/MotionMode.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/SceneCost.h"
#include "core/scene/ShotChoice.h"
#include "core/scene/camera/CameraTrack.h"
#include "core/settings/Settings.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace taa::cli {

struct ShotOptions {
  std::string source;  ///< a glTF file, "builtin:NAME" or a capture
  std::string session; ///< a file instead of source, camera, size, preset, lanes and motion modes
  std::string camera;  ///< empty: the scene's own
  std::string size;    ///< empty: kDefaultSize, of a capture its own
  std::string preset = "balanced";
  std::vector<std::string> lanes;       ///< presets; empty: one lane with `preset`
  std::vector<std::string> assignments; ///< "path=value", applied to every lane
  std::vector<std::string> motionModes; ///< "NODE=MODE"
  std::vector<std::string> classes;     ///< "OBJECT=CLASS"
  std::vector<int> restarts;            ///< frames
  int checkpointsMiB = 1024;
  int sceneMillions = kDefaultSceneMillions, sceneMiB = kDefaultSceneMiB; ///< what it may ask for
  ShotChoice choice;                  ///< instead of a session's, as far as it is said
  std::string cameraPose, cameraPath; ///< "x,y,z,yaw,pitch[,fov]"; a file
  ObjectFilter filter;
};

inline constexpr const char* kDefaultSize = "1280x720";

/// SOURCE, or --session instead of it, with camera, size, settings and what the scene is made of.
void addShotOptions(CLI::App& command, ShotOptions& shot);
/// What a scene may ask for (SceneBudget).
void addSceneBudget(CLI::App& command, int& millions, int& mib);

struct LaneChoice {
  std::string name; ///< "A" to "E", or "other"; empty when it is the only one
  std::string preset;
  Settings settings;
  std::vector<std::string> notes{}; ///< to say of preset and assignments: what has another name by now
};

// Each throws UsageError that says what is expected.
std::vector<MotionOverride> motionModesOf(const ShotOptions& options); ///< --motion-mode, then --set
std::optional<CameraTrack> cameraTrackOf(const ShotOptions& options);  ///< also Error: its file
/// A lane of a preset; also Error: a preset file.
LaneChoice laneOfPreset(const std::string& name, const std::string& preset);
std::vector<LaneChoice> lanesOf(const ShotOptions& options); ///< also Error: a preset file

/// Cameras, objects and frames of what is not open yet, so that they may not be there.
struct ShotWishes {
  std::string camera; ///< empty: the scene's own
  std::optional<CameraTrack> track;
  std::vector<MotionOverride> motionModes;
  ObjectFilter filter;
  std::vector<ClassOverride> objectClasses;
  std::vector<int> restarts;
};

/// Everything about the options that can be wrong before a scene is opened, read once.
struct ShotPlan {
  ShotOptions options;
  std::string source;
  glm::ivec2 size{0};
  std::vector<LaneChoice> lanes;
  ShotWishes ofSession, ofCall;
  int sessionFrame = -1; ///< −1: none is said
  ShotChoice choice;
  bool isChoiceAsked = false;     ///< by the caller, as far as it can be wrong
  std::vector<std::string> notes; ///< to say of the session

  const LaneChoice& lane(int index) const { return lanes.at(static_cast<std::size_t>(index)); }
};
ShotPlan planShot(const ShotOptions& options);

/// `asked`, or where that is −1 the session's. Throws UsageError where that is none.
int frameOf(const ShotPlan& plan, int asked);

/// Those of the session with those of the call on top.
ShotWishes wishesOf(const ShotPlan& plan);

/// Says on stderr, each once, which names that were given have changed: `notes` and those of the lanes.
void sayNotes(std::vector<std::string> notes, const std::vector<LaneChoice>& lanes);

/// What is open, and how many frames it has.
struct OpenedShot {
  const Scene* scene; ///< null: a capture, which has nothing to choose
  int frames;
};

/// Throws UsageError that names the flag where the call asks for a camera, an object or a frame that is not
/// there, and Error that names the session where that does.
void checkWishes(const ShotPlan& plan, const OpenedShot& opened);

/// Calls `open`; whose mistake it is that there is no such animation or length is told as above.
void openChosen(const ShotPlan& plan, const std::function<void()>& open);

/// Opens source, camera, size and lanes; the plan's notes and the scene's warnings go to stderr. Throws
/// UsageError, Error, Cancelled.
void openShot(Inspector& inspector, const ShotPlan& plan, const Progress& progress);

/// Throws UsageError that names the frames there are, Error where `frame` is that of the session.
void requireFrame(const Inspector& inspector, const ShotPlan& plan, int frame);
/// Throws UsageError that names the size of the picture.
void requirePixel(const Inspector& inspector, const glm::ivec2& pixel);

/// What was rendered, on which driver.
ShotFacts shotFacts(const Inspector& inspector);
nlohmann::ordered_json shotJson(const Inspector& inspector);

/// A lane's name, preset, settings and where in the jitter pattern its frame lies.
LaneFacts laneFacts(const Inspector& inspector, const ShotPlan& plan, int lane);
nlohmann::ordered_json laneJson(const Inspector& inspector, const ShotPlan& plan, int lane);

/// "LANE B: balanced", after an empty line unless it is the first; nothing where there is one lane.
std::string laneHeading(const ShotPlan& plan, int lane);

} // namespace taa::cli
