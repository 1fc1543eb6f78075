// What the commands of taa-batch are asked for, and reading it from text.
#pragma once

#include "core/base/ShownText.h"
#include "core/doctor/Diagnosis.h"
#include "core/inspect/VerdictOfShot.h"
#include "core/scene/MotionMode.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/SceneCost.h"
#include "core/scene/ShotChoice.h"
#include "core/scene/camera/CameraTrack.h"
#include "core/settings/Settings.h"
#include "core/sweep/SweepPoints.h"
#include "core/sweep/tune/TuneGoal.h"
#include "core/taa/Intermediates.h"
#include "core/verdict/lineage/Lineage.h"

#include <glm/vec2.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace taa::cli {

/// The caller's mistake on the command line, told in a sentence; ends the program with 2.
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(const std::string& message) : std::runtime_error(shownLine(message)) {}
};

inline constexpr const char* kDefaultSize = "1280x720";

/// What to look at and with which settings: shared by render and probe.
struct ShotArguments {
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

struct ListArguments {
  std::string what; ///< "intermediates", "parameters", "presets" or "scenes"
  bool json = false;
};

struct RenderArguments {
  ShotArguments shot;
  std::string frames, folder;                   ///< frames empty: that of the session
  std::vector<std::string> emit = {"resolved"}; ///< ids, or "all"
  std::string format = "exr";
  int referenceSamples = 64;            ///< of frames whose reference is looked at
  bool isReferenceAsked = false;        ///< by the caller, not as the default
  std::string like;                     ///< starting point of a capture; empty: this program's own
  std::vector<std::string> conventions; ///< of a capture, "path=value" on top of it
  std::vector<std::string> style;       ///< "key=value" on top of the styles that rows open with
  std::string compare, compareAs;       ///< of pictures; empty: with nothing, as a wipe
  std::vector<std::string> otherStyle;  ///< as style, of the other side
  double divider = 0.5;                 ///< where it lies in a wipe, share of the width
  double framesPerSecond = 0.0;         ///< of a GIF; 0: the scene's
  bool force = false;                   ///< replace files that are there
  bool json = false;
  bool verbose = false;
};

struct ProbeArguments {
  ShotArguments shot;
  std::string pixel;
  int frame = -1; ///< −1: that of the session
  bool json = false;
  bool whatIf = false;                    ///< also the pixel under other choices
  std::string compare;                    ///< the other side; empty: none
  std::string region;                     ///< X,Y,WxH instead of a pixel; empty: none
  std::string find;                       ///< "rejected", "clipped" or "nan" instead of a pixel; empty: none
  std::vector<std::string> emit;          ///< of a region; empty: all of the frame's own resolve
  int referenceSamples = kVerdictSamples; ///< of rows of the reference that are named
};

struct LineageArguments {
  ShotArguments shot;
  std::string pixel;
  int frame = -1;              ///< −1: that of the session
  int frames = kLineageFrames; ///< how far back
  bool json = false;
};

struct VerdictArguments {
  ShotArguments shot;
  std::string pixel;             ///< empty: of the whole picture
  int frame = -1;                ///< −1: that of the session
  int samples = kVerdictSamples; ///< of the references
  int worst = 5;                 ///< pixels of each category and error of the whole picture
  bool remedies = false;         ///< also what mends it
  bool json = false;
};

struct DoctorArguments {
  ShotArguments shot;
  int frames = doctor::kDoctorFrames;
  std::string html;                      ///< a file; empty: none is written
  std::string baseline, writtenBaseline; ///< of known findings: read, written; empty: none
  std::string mended;                    ///< a folder; empty: what is found is not mended
  bool json = false, force = false;
};

struct TraceArguments {
  ShotArguments shot;
  std::string frames;
  std::vector<std::string> pixels;
  std::vector<std::string> emit = {"alpha", "historyLength"}; ///< ids, or "all"
  int referenceSamples = kVerdictSamples;                     ///< of rows of the reference that are named
  bool surface = false;           ///< follow what is seen at the pixels in the first frame
  bool json = false, csv = false; ///< CSV is also what neither asks for
};

struct ProfileArguments {
  ShotArguments shot;
  std::string frames = "1..30";
  bool json = false;
};

struct MetricsArguments {
  ShotArguments shot;
  std::string frames;
  int referenceSamples = 64;      ///< 0: nothing is compared with a reference
  bool flicker = false;           ///< also what is over time: frames before those, and their references
  bool parts = false;             ///< also what the error is made of, over those frames
  std::vector<std::string> named; ///< ids of these alone; empty: all that are not costly
  int flickerFrames = 16;
  bool json = false, csv = false;
};

struct GlslArguments {
  std::string preset = "balanced", file; ///< file empty: standard output
  std::vector<std::string> assignments;
  bool force = false; ///< replace the file when it is there
};

struct ImportArguments {
  std::string folder, out; ///< out empty: it is only measured
  std::string like;        ///< id of a starting point; empty: none
  std::vector<std::string> assignments;
  bool check = false; ///< measure what is stated or guessed, and write nothing
  bool force = false; ///< replace files that are there
  bool json = false;
};

struct SweepArguments {
  std::string spec, folder;
  std::string shard = "1/1";
  int sceneMillions = kDefaultSceneMillions, sceneMiB = kDefaultSceneMiB; ///< what each scene may ask for
  bool json = false;
};

struct TuneArguments {
  ShotArguments shot;
  std::string goal = kDefaultGoal; ///< "METRIC=WEIGHT,…"
  std::string frames;              ///< empty: that of the session
  std::string preset, glsl;        ///< files; glsl empty: none
  std::vector<std::string> varied; ///< paths or groups; empty: all of the resolve
  int referenceSamples = 64, flickerFrames = 16;
  int evaluations = 200;
  int seconds = 0; ///< instead of evaluations; 0: those
  unsigned seed = 1;
  bool trades = false; ///< RMSE and flicker may become worse
  bool force = false;  ///< replace files that are there
  bool json = false;
};

/// First and last frame, both included.
struct FrameRange {
  int first = 0, last = 0;
  int count() const { return last - first + 1; }
};

struct LaneChoice {
  std::string name; ///< "A" to "D"; empty when it is the only one
  std::string preset;
  Settings settings;
  std::vector<std::string> notes{}; ///< to say of preset and assignments: what has another name by now
};

// Each throws UsageError that says what is expected.
FrameRange parseFrames(const std::string& text); ///< "A..B", or one frame
glm::ivec2 parseSize(const std::string& text);   ///< "WxH"
glm::ivec2 parsePixel(const std::string& text);  ///< "X,Y"
SweepShard parseShard(const std::string& text);  ///< "I/N", from 1
std::vector<IntermediateId> parseEmit(const std::vector<std::string>& names);
void checkReferenceSamples(int samples);
std::vector<MotionOverride> motionModesOf(const ShotArguments& arguments); ///< --motion-mode, then --set
std::vector<ClassOverride> objectClassesOf(const ShotArguments& arguments);
std::optional<CameraTrack> cameraTrackOf(const ShotArguments& arguments); ///< also Error: its file
/// A lane of a preset; also Error: a preset file.
LaneChoice laneOfPreset(const std::string& name, const std::string& preset);
std::vector<LaneChoice> lanesOf(const ShotArguments& arguments); ///< also Error: a preset file
void assign(std::vector<LaneChoice>& lanes,
            const std::vector<std::string>& assignments); ///< but motion modes

} // namespace taa::cli
