#include "core/lessons/LessonState.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/capture/format/Conventions.h"
#include "core/inspect/SceneSettings.h"
#include "core/io/CameraTrackJson.h"
#include "core/lessons/LessonText.h"
#include "core/measure/Metrics.h"
#include "core/picture/StyleText.h"
#include "core/picture/Visualizer.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Faults.h"
#include "core/settings/Lanes.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <glm/common.hpp>

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

namespace taa {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxLessonFrame = 100'000, kMaxLessonSide = 1920, kMinLessonSide = 16, kMaxPoseFrame = 1000;
constexpr std::size_t kMaxLessonViews = 4, kMaxLessonProbes = 4, kMaxLessonRows = 8;
constexpr double kMaxLessonZoom = 256.0;

/// What a line of a header is about.
struct HeaderLine {
  LessonState& state;
  std::string_view value;
  const std::string& folder;
};

/// Of the built-in ones: a lesson depends on no file of a preset.
const Preset& lessonPreset(std::string_view id) {
  const auto found = std::ranges::find(builtinPresets(), id, &Preset::id);
  if (found != builtinPresets().end()) return *found;
  std::vector<std::string_view> known;
  for (const Preset& preset : builtinPresets()) known.push_back(preset.id);
  requireName(id, known, say<"preset">());
  return *found; // never: the name was not known
}

/// A built-in scene there is, or a file below the lesson's folder.
std::string sourceOf(const HeaderLine& line) {
  const std::string source(line.value);
  if (isBuiltinScene(source)) {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) names.push_back("builtin:" + scene.id);
    const std::vector<std::string_view> known(names.begin(), names.end());
    requireName(source, known, say<"scene">());
    return source;
  }
  if (line.folder.empty())
    throw Error(say<"\"%1\" is no built-in scene, and only a lesson that is a file has files beside it">(
        shownText(source)));
  return requireRegularBelow(line.folder, source).string();
}

void setScene(const HeaderLine& line) {
  LessonState& state = line.state;
  SessionFile shot;
  shot.source = sourceOf(line);
  shot.size = state.shot.size;
  shot.settings = state.shot.settings;
  shot.settings.settings = settingsForScene(shot.settings.settings, state.shot.source, shot.source);
  state.shot = shot;
  state.recording.reset();
  state.probes.clear();
  state.look.reset();
}

void setSize(const HeaderLine& line) {
  const std::size_t by = std::min(line.value.find('x'), line.value.size());
  line.state.shot.size = {wholeNumberFrom(line.value.substr(0, by), kMinLessonSide, kMaxLessonSide),
                          wholeNumberFrom(line.value.substr(std::min(by + 1, line.value.size())),
                                          kMinLessonSide, kMaxLessonSide)};
}

void setPreset(const HeaderLine& line) {
  const Preset& preset = lessonPreset(line.value);
  line.state.shot.settings = {preset.id, preset.settings, preset.settings};
  line.state.stages.clear();
}

/// The last one that is named is the one that the step speaks of.
void showStage(LessonState& state, Stage stage) {
  std::erase(state.stages, stage);
  state.stages.push_back(stage);
}

void assignWords(Settings& settings, std::string_view words) {
  for (const std::string_view assignment : wordsOf(words)) applyAssignment(settings, assignment);
}

void setSettings(const HeaderLine& line) {
  assignWords(line.state.shot.settings.settings, line.value);
  for (const std::string_view assignment : wordsOf(line.value))
    showStage(line.state, parameter(assignment.substr(0, assignment.find('='))).stage);
}

void addStage(const HeaderLine& line) {
  std::vector<std::string_view> known;
  for (const StageInfo& info : kStages) known.push_back(info.id);
  requireName(line.value, known, say<"stage">());
  showStage(line.state, std::ranges::find(kStages, line.value, &StageInfo::id)->stage);
}

/// "16 like=unreal preset=balanced fault=motionNegated reference=16": in this order, all but the frames may
/// be left out. The state's own settings are those that resolve them.
void setRecording(const HeaderLine& line) {
  const std::vector<std::string_view> words = wordsOf(line.value);
  LessonRecording recording{.frames = wholeNumberFrom(words.front(), 1, kMaxRecordedFrames)};
  recording.settings = builtinPresets().front().settings;
  for (const std::string_view word : std::span(words).subspan(1)) {
    const std::string_view value = word.substr(std::min(word.find('=') + 1, word.size()));
    if (word.starts_with("like="))
      recording.like = capture::startingPoint(std::string(value)).id;
    else if (word.starts_with("preset="))
      recording.settings = lessonPreset(value).settings;
    else if (word.starts_with("fault="))
      inject(faultInfo(value).fault, recording.settings);
    else if (word.starts_with("reference="))
      recording.referenceSamples = wholeNumberFrom(value, kMinReferenceSamples, kMaxReferenceSamples);
    else
      throw Error(say<"expected FRAMES like=ENGINE preset=PRESET fault=FAULT reference=SAMPLES">());
  }
  line.state.recording = recording;
}

/// "20 0.5,1.4,4 -3,0": frame, position, yaw and pitch. Poses between two that are said lie evenly between
/// them; before the first and after the last the camera rests.
void addPose(const HeaderLine& line) {
  const std::vector<std::string_view> words = wordsOf(line.value);
  if (words.size() != 3) throw Error(say<"expected FRAME X,Y,Z YAW,PITCH">());
  const int frame = wholeNumberFrom(words[0], 0, kMaxPoseFrame);
  const CameraPose pose = parseCameraPose(std::string(words[1]) + "," + std::string(words[2]));
  std::optional<CameraTrack>& track = line.state.shot.track;
  if (!track) {
    track = CameraTrack{"lesson", frame, {pose}};
    line.state.shot.camera = track->name;
    return;
  }
  const int last = track->firstFrame + static_cast<int>(track->poses.size()) - 1;
  if (frame <= last) throw Error(say<"frame %1 comes after frame %2">(frame, last));
  const CameraPose before = track->poses.back();
  for (int between = last + 1; between <= frame; ++between) {
    const float part = static_cast<float>(between - last) / static_cast<float>(frame - last);
    track->poses.push_back({glm::mix(before.position, pose.position, part),
                            glm::mix(before.yaw, pose.yaw, part), glm::mix(before.pitch, pose.pitch, part),
                            glm::mix(before.fovY, pose.fovY, part)});
  }
}

/// "clip = this rectify.method=clip": a preset, or "this" for the state's own settings, and what differs.
void addLessonLane(const HeaderLine& line) {
  const std::size_t equals = line.value.find('=');
  if (equals == line.value.npos)
    throw Error(say<"a lane is NAME = PRESET path=value …, or NAME = this path=value …">());
  LessonLane lane{std::string(withoutBlanks(line.value.substr(0, equals))),
                  line.state.shot.settings.settings};
  const std::vector<std::string_view> words = wordsOf(line.value.substr(equals + 1));
  if (lane.name.empty() || words.empty())
    throw Error(say<"a lane is NAME = PRESET path=value …, or NAME = this path=value …">());
  if (static_cast<int>(line.state.lanes.size()) + 1 >= kMaxLanes)
    throw Error(say<"a step has at most %1 lanes">(kMaxLanes - 1));
  if (words.front() != "this") lane.settings = lessonPreset(words.front()).settings;
  for (std::size_t word = 1; word < words.size(); ++word) applyAssignment(lane.settings, words[word]);
  line.state.lanes.push_back(std::move(lane));
}

/// "resolved compare=preset:off shows=wipe exposure=1"
void addView(const HeaderLine& line) {
  const std::vector<std::string_view> words = wordsOf(line.value);
  if (words.empty()) throw Error(say<"a view is the name of an intermediate">());
  if (line.state.views.size() >= kMaxLessonViews)
    throw Error(say<"there are at most %1 views">(kMaxLessonViews));
  LessonView view{.id = intermediateNamed(words.front())};
  ViewStyle style = defaultStyle(intermediate(view.id));
  for (const std::string_view word : std::span(words).subspan(1)) {
    if (word.starts_with("compare=")) {
      view.comparison = parseComparison(std::string(word.substr(8)));
      if (view.comparison.kind == OtherKind::Preset) lessonPreset(view.comparison.preset);
    } else if (word.starts_with("shows=")) {
      view.showing = showingNamed(word.substr(6));
    } else {
      applyStyle(style, word);
      view.style.emplace_back(word);
    }
  }
  line.state.views.push_back(std::move(view));
}

void addProbe(const HeaderLine& line) {
  if (line.state.probes.size() >= kMaxLessonProbes)
    throw Error(say<"there are at most %1 probes">(kMaxLessonProbes));
  line.state.probes.push_back(pixelFrom(line.value));
}

void setPlots(const HeaderLine& line) {
  for (const std::string_view name : wordsOf(line.value)) {
    if (line.state.plots.size() >= kMaxLessonRows)
      throw Error(say<"there are at most %1 plots">(kMaxLessonRows));
    line.state.plots.push_back(intermediateNamed(name));
  }
}

void setValues(const HeaderLine& line) {
  for (const std::string_view name : wordsOf(line.value)) {
    if (line.state.values.size() >= kMaxLessonRows)
      throw Error(say<"there are at most %1 values">(kMaxLessonRows));
    line.state.values.push_back(intermediateNamed(name));
  }
}

/// "120,60 zoom 8"
void setLook(const HeaderLine& line) {
  const std::vector<std::string_view> words = wordsOf(line.value);
  if (words.size() != 3 || words[1] != "zoom") throw Error(say<"expected X,Y zoom Z, or fit">());
  const double zoom = numberFrom(words[2]);
  if (!(zoom > 0.0 && zoom <= kMaxLessonZoom))
    throw Error(say<"the zoom is not above 0 and up to %1">(static_cast<int>(kMaxLessonZoom)));
  line.state.look = LessonLook{pixelFrom(words[0]), zoom};
}

void addRestart(const HeaderLine& line) {
  if (line.state.shot.restarts.size() >= kMaxLessonRows)
    throw Error(say<"there are at most %1 restarts">(kMaxLessonRows));
  line.state.shot.restarts.push_back(wholeNumberFrom(line.value, 0, kMaxLessonFrame));
}

/// Of a fixed list; "none" is empty.
std::string listedName(const HeaderLine& line, std::span<const std::string_view> known,
                       const std::string& what) {
  if (line.value == "none") return {};
  requireName(line.value, known, what);
  return std::string(line.value);
}

constexpr std::array<std::string_view, 5> kLessonPages{"profiler", "plots", "jitter", "weights", "lineage"};
constexpr std::array<std::string_view, 4> kLessonTabs{"values", "colorSpace", "whatIf", "sensitivity"};
constexpr std::array<std::string_view, 2> kOnOff{"on", "off"};

struct LessonKey {
  std::string_view key;
  void (*apply)(const HeaderLine& line);
};

constexpr LessonKey kLessonKeys[] = {
    {"scene", setScene},
    {"camera",
     [](const HeaderLine& line) {
       line.state.shot.camera = std::string(line.value);
       line.state.shot.track.reset();
     }},
    {"pose", addPose},
    {"record", setRecording},
    {"length",
     [](const HeaderLine& line) {
       line.state.shot.choice.frames = wholeNumberFrom(line.value, 1, kMaxShotFrames);
     }},
    {"frame",
     [](const HeaderLine& line) { line.state.shot.frame = wholeNumberFrom(line.value, 0, kMaxLessonFrame); }},
    {"size", setSize},
    {"preset", setPreset},
    {"set", setSettings},
    {"stage", addStage},
    {"fault",
     [](const HeaderLine& line) { inject(faultInfo(line.value).fault, line.state.shot.settings.settings); }},
    {"hide", [](const HeaderLine& line) { line.state.shot.filter.hidden.emplace_back(line.value); }},
    {"restart", addRestart},
    {"lane", addLessonLane},
    {"view", addView},
    {"probe", addProbe},
    {"plots", setPlots},
    {"values", setValues},
    {"look", setLook},
    {"page", [](const HeaderLine& line) { line.state.page = listedName(line, kLessonPages, say<"page">()); }},
    {"tab", [](const HeaderLine& line) { line.state.tab = listedName(line, kLessonTabs, say<"tab">()); }},
    {"highlight",
     [](const HeaderLine& line) { line.state.highlight = listedName(line, kLessonParts, say<"part">()); }},
    {"play",
     [](const HeaderLine& line) {
       requireName(line.value, kOnOff, say<"switch">());
       line.state.plays = line.value == "on";
     }},
    {"samples",
     [](const HeaderLine& line) {
       line.state.samples = wholeNumberFrom(line.value, kMinReferenceSamples, kMaxReferenceSamples);
     }},
};

} // namespace

std::vector<std::string_view> lessonKeys() {
  std::vector<std::string_view> keys;
  for (const LessonKey& row : kLessonKeys) keys.push_back(row.key);
  return keys;
}

void applyLessonKey(LessonState& state, std::string_view key, std::string_view value,
                    const std::string& folder) {
  const auto row = std::ranges::find(kLessonKeys, key, &LessonKey::key);
  if (row == std::end(kLessonKeys)) requireName(key, lessonKeys(), say<"key">());
  if (value.empty()) throw Error(say<"\"%1\" has no value">(key));
  if (key == "look" && value == "fit") {
    state.look.reset();
    return;
  }
  row->apply({state, value, folder});
}

} // namespace taa
