// Sessions come from anywhere: nothing in them is believed before it is looked at.
#include "core/io/SessionFile.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/OldNames.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/Json.h"
#include "core/base/json/JsonFields.h"
#include "core/base/json/LimitedJson.h"
#include "core/io/CameraTrackJson.h"
#include "core/settings/Lanes.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace taa {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr int kSessionFormat = 1;
constexpr std::uintmax_t kMaxSessionBytes = 4u << 20;
constexpr std::size_t kLongestName = 4096, kMaxModes = 4096;
constexpr std::size_t kMaxFurtherLanes = kMaxLanes - 1;
constexpr int kMaxFrame = 1'000'000, kMaxSide = 32768, kMinSide = 4, kMaxMiB = 1 << 20;

enum class Part { Session, Lane };

void checkKeys(const Json& object, Part part, std::initializer_list<std::string_view> known) {
  const bool isLane = part == Part::Lane;
  if (!object.is_object())
    throw Error(isLane ? say<"a lane is not an object">() : say<"the session is not an object">());
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string shown = shownText(key);
    throw Error(isLane ? say<"there is no field \"%1\" in a lane">(shown)
                       : say<"there is no field \"%1\" in the session">(shown));
  }
}

const Json& field(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw Error(say<"the field \"%1\" is missing">(key));
  return *found;
}

std::string nameFrom(const Json& value, const char* key) {
  std::string text = textOf(value, key);
  if (text.size() > kLongestName) throw Error(say<"\"%1\" is too long">(key));
  return text;
}

int wholeFrom(const Json& value, const char* key, int least, int most) {
  return static_cast<int>(integerOf(value, key, least, most));
}

using Notes = std::vector<std::string>;

SessionLane laneFromJson(const Json& preset, const Json& settings, const Json* presetSettings, Notes& notes) {
  SessionLane lane;
  lane.preset = nameFrom(preset, "preset");
  addNotes(notes, fromJson(settings, lane.settings));
  const auto known = std::ranges::find(builtinPresets(), lane.preset, &Preset::id);
  if (known != builtinPresets().end()) lane.presetSettings = known->settings;
  if (presetSettings)
    addNotes(notes, fromJson(*presetSettings, lane.presetSettings));
  else if (known == builtinPresets().end()) {
    lane.presetSettings = lane.settings;
    addNotes(notes, {say<"there is no preset \"%1\"; the settings of the session are taken for it">(
                        shownText(lane.preset))});
  }
  return lane;
}

SessionLane laneFromJson(const Json& object, Notes& notes) {
  const auto own = object.find("presetSettings");
  return laneFromJson(field(object, "preset"), field(object, "settings"),
                      own == object.end() ? nullptr : &*own, notes);
}

// What a built-in preset says is not said again.
void laneToJson(const SessionLane& lane, ordered_json& object) {
  const auto known = std::ranges::find(builtinPresets(), lane.preset, &Preset::id);
  object["preset"] = lane.preset;
  if (known == builtinPresets().end() || !(known->settings == lane.presetSettings))
    object["presetSettings"] = toJson(lane.presetSettings);
  object["settings"] = toJson(lane.settings);
}

std::vector<std::string> namesFromJson(const Json& object, const char* key) {
  const Json list = object.value(key, Json::array());
  if (!list.is_array() || list.size() > kMaxModes)
    throw Error(say<"\"%1\" is not a list of at most %2 names">(key, kMaxModes));
  std::vector<std::string> names;
  for (const Json& name : list) names.push_back(nameFrom(name, key));
  return names;
}

std::vector<ClassOverride> classesFromJson(const Json& object) {
  if (!object.is_object() || object.size() > kMaxModes)
    throw Error(say<"\"%1\" is not an object of at most %2 names">("classes", kMaxModes));
  std::vector<ClassOverride> classes;
  for (const auto& [name, given] : object.items())
    classes.push_back(parseClassOverride(name.substr(0, kLongestName) + "=" + nameFrom(given, "classes")));
  return classes;
}

std::vector<int> restartsFromJson(const Json& list) {
  if (!list.is_array() || list.size() > kMaxModes)
    throw Error(say<"\"%1\" is not a list of at most %2">("restarts", kMaxModes));
  std::vector<int> frames;
  for (const Json& frame : list) frames.push_back(wholeFrom(frame, "restarts", 0, kMaxFrame));
  return frames;
}

std::vector<MotionOverride> modesFromJson(const Json& object) {
  if (!object.is_object() || object.size() > kMaxModes)
    throw Error(say<"\"%1\" is not an object of at most %2 names">("motionModes", kMaxModes));
  std::vector<MotionOverride> modes;
  for (const auto& [node, mode] : object.items())
    modes.push_back(parseMotionOverride(node.substr(0, kLongestName) + "=" + nameFrom(mode, "motionModes")));
  return modes;
}

/// Fields of the window's state as earlier versions wrote them. They are read for one version more.
constexpr std::array<OldName, 3> kOldFields{
    {{"pins", "probes"}, {"activePin", "activeProbe"}, {"timeline.figure", "timeline.metric"}}};

/// Its object within `window` and its key there; null: there is no such object.
std::pair<Json*, std::string> fieldPlace(std::string_view field, Json& window) {
  const std::size_t dot = field.find('.');
  if (dot == std::string_view::npos) return {&window, std::string(field)};
  const auto group = window.find(std::string(field.substr(0, dot)));
  const bool isGroup = group != window.end() && group->is_object();
  return {isGroup ? &*group : nullptr, std::string(field.substr(dot + 1))};
}

void renameFields(Json& window, Notes& notes) {
  for (const OldName& name : kOldFields) {
    const auto [group, old] = fieldPlace(name.old, window);
    if (!group || !group->contains(old)) continue;
    const std::string now = fieldPlace(name.now, window).second;
    if (!group->contains(now)) (*group)[now] = group->at(old);
    group->erase(old);
    addNotes(notes, {oldNameNote(name)});
  }
}

SessionFile sessionFromJson(const Json& object) {
  checkKeys(object, Part::Session,
            {"format", "source", "camera", "frame", "size", "preset", "presetSettings", "settings", "lanes",
             "track", "animation", "length", "hidden", "isolated", "motionModes", "classes", "restarts",
             "checkpointsMiB", "window"});
  if (const Json& format = field(object, "format"); format != kSessionFormat)
    throw Error(say<"its format is %1, this program reads %2">(shownText(format.dump()), kSessionFormat));
  SessionFile session;
  session.source = nameFrom(field(object, "source"), "source");
  session.camera = nameFrom(object.value("camera", Json("")), "camera");
  session.choice.animation = nameFrom(object.value("animation", Json("")), "animation");
  session.choice.frames = wholeFrom(object.value("length", Json(0)), "length", 0, kMaxShotFrames);
  session.frame = wholeFrom(field(object, "frame"), "frame", 0, kMaxFrame);
  const Json& size = field(object, "size");
  if (!size.is_array() || size.size() != 2) throw Error(say<"\"%1\" wants [width, height]">("size"));
  session.size = {wholeFrom(size[0], "size", kMinSide, kMaxSide),
                  wholeFrom(size[1], "size", kMinSide, kMaxSide)};
  session.settings = laneFromJson(object, session.notes);
  const Json lanes = object.value("lanes", Json::array());
  if (!lanes.is_array() || lanes.size() > kMaxFurtherLanes)
    throw Error(say<"\"%1\" is not a list of at most %2">("lanes", kMaxFurtherLanes));
  for (const Json& lane : lanes) {
    checkKeys(lane, Part::Lane, {"preset", "presetSettings", "settings"});
    session.lanes.push_back(laneFromJson(lane, session.notes));
  }
  if (const auto track = object.find("track"); track != object.end()) session.track = cameraTrackFrom(*track);
  session.filter = {namesFromJson(object, "hidden"), namesFromJson(object, "isolated")};
  session.motionModes = modesFromJson(object.value("motionModes", Json::object()));
  session.objectClasses = classesFromJson(object.value("classes", Json::object()));
  session.restarts = restartsFromJson(object.value("restarts", Json::array()));
  session.checkpointsMiB =
      wholeFrom(object.value("checkpointsMiB", Json(session.checkpointsMiB)), "checkpointsMiB", 0, kMaxMiB);
  Json window = object.value("window", Json::object());
  if (!window.is_object()) throw Error(say<"\"%1\" is not an object">("window"));
  renameFields(window, session.notes);
  session.window = window.dump();
  return session;
}

bool isPath(const std::string& source) {
  return !source.empty() && !source.starts_with("builtin:");
}

} // namespace

bool isSessionName(std::string_view path) {
  return path.ends_with(kSessionEnding);
}

SessionFile sessionFromText(const std::string& text, const std::string& place) {
  try {
    return sessionFromJson(parseLimited(text, {.bytes = kMaxSessionBytes}));
  } catch (const Json::exception& error) {
    throw Error(say<"cannot open the session %1: %2">(place, shownReason(error)));
  } catch (const Error& error) {
    throw Error(say<"cannot open the session %1: %2">(place, error.what()));
  }
}

std::string sessionToText(const SessionFile& session) {
  ordered_json object;
  object["format"] = kSessionFormat;
  object["source"] = session.source;
  object["camera"] = session.camera;
  if (!session.choice.animation.empty()) object["animation"] = session.choice.animation;
  if (session.choice.frames > 0) object["length"] = session.choice.frames;
  object["frame"] = session.frame;
  object["size"] = {session.size.x, session.size.y};
  laneToJson(session.settings, object);
  for (const SessionLane& lane : session.lanes) {
    ordered_json row;
    laneToJson(lane, row);
    object["lanes"].push_back(row);
  }
  if (session.track) object["track"] = cameraTrackJson(*session.track);
  if (!session.filter.hidden.empty()) object["hidden"] = session.filter.hidden;
  if (!session.filter.isolated.empty()) object["isolated"] = session.filter.isolated;
  Json modes = Json::object(); // by name
  for (const MotionOverride& mode : session.motionModes)
    modes[mode.node] = kMotionModes.at(static_cast<std::size_t>(mode.mode)).id;
  object["motionModes"] = modes;
  Json classes = Json::object();
  for (const ClassOverride& given : session.objectClasses)
    classes[given.object] = kObjectClasses.at(static_cast<std::size_t>(given.objectClass)).id;
  if (!classes.empty()) object["classes"] = classes;
  if (!session.restarts.empty()) object["restarts"] = session.restarts;
  object["checkpointsMiB"] = session.checkpointsMiB;
  object["window"] = ordered_json::parse(session.window);
  return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

SessionFile readSession(const fs::path& path) {
  SessionFile session = sessionFromText(readFile(path, kMaxSessionBytes), path.string());
  if (isPath(session.source) && fs::path(session.source).is_relative())
    session.source = (fs::absolute(path).parent_path() / session.source).lexically_normal().string();
  return session;
}

void writeSession(const fs::path& path, const SessionFile& session) {
  SessionFile written = session;
  if (isPath(session.source)) {
    const fs::path source = fs::absolute(session.source).lexically_normal();
    const fs::path relative = source.lexically_relative(fs::absolute(path).parent_path().lexically_normal());
    const bool isBelow = !relative.empty() && *relative.begin() != "..";
    written.source = (isBelow ? relative : source).string();
  }
  writeFile(path, sessionToText(written));
}

} // namespace taa
