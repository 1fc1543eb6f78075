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

std::string nameFrom(const Json& value, const std::string& place) {
  std::string text = textOf(value, place);
  if (text.size() > kLongestName) throw Error(say<"\"%1\" is longer than %2 bytes">(place, kLongestName));
  return text;
}

int wholeFrom(const Json& value, const std::string& place, int least, int most) {
  return static_cast<int>(integerOf(value, place, least, most));
}

using Notes = std::vector<std::string>;

/// Reads what settings(path) holds; errors name it.
void settingsFrom(const Json& json, const std::string& place, Settings& settings, Notes& notes) {
  try {
    addNotes(notes, fromJson(json, settings));
  } catch (const Error& error) {
    throw Error(say<"\"%1\": %2">(place, error.what()));
  }
}

/// `place`: of the object that has a lane's three fields.
SessionLane laneFromJson(const Json& object, const std::string& place, Notes& notes) {
  SessionLane lane;
  lane.preset = nameFrom(requireField(object, place, "preset"), pathOf(place, "preset"));
  settingsFrom(requireField(object, place, "settings"), pathOf(place, "settings"), lane.settings, notes);
  const auto known = std::ranges::find(builtinPresets(), lane.preset, &Preset::id);
  if (known != builtinPresets().end()) lane.presetSettings = known->settings;
  if (const Json* const own = findField(object, "presetSettings"))
    settingsFrom(*own, pathOf(place, "presetSettings"), lane.presetSettings, notes);
  else if (known == builtinPresets().end()) {
    lane.presetSettings = lane.settings;
    addNotes(notes, {say<"there is no preset \"%1\"; the settings of the session are taken for it">(
                        shownText(lane.preset))});
  }
  return lane;
}

// What a built-in preset says is not said again.
void laneToJson(const SessionLane& lane, ordered_json& object) {
  const auto known = std::ranges::find(builtinPresets(), lane.preset, &Preset::id);
  object["preset"] = lane.preset;
  if (known == builtinPresets().end() || !(known->settings == lane.presetSettings))
    object["presetSettings"] = toJson(lane.presetSettings);
  object["settings"] = toJson(lane.settings);
}

/// What `read` makes of each entry of a list and its path; nothing where there is no list.
template <typename Read>
auto listFrom(const Json& object, const std::string& key, std::size_t most, Read read) {
  std::vector<decltype(read(object, key))> entries;
  const Json* const list = findField(object, key);
  if (!list) return entries;
  requireList(*list, key, most);
  for (const Json& entry : *list) entries.push_back(read(entry, elementOf(key, entries.size())));
  return entries;
}

/// What `read` makes of "name=value" of each field of an object; nothing where there is no object.
template <typename Read>
auto overridesFrom(const Json& object, const std::string& key, Read read) {
  std::vector<decltype(read(key))> overrides;
  const Json* const given = findField(object, key);
  if (!given) return overrides;
  requireObject(*given, key);
  if (given->size() > kMaxModes) throw Error(say<"\"%1\" has more than %2 names">(key, kMaxModes));
  for (const auto& [name, value] : given->items())
    overrides.push_back(
        read(name.substr(0, kLongestName) + "=" + nameFrom(value, pathOf(key, shownText(name)))));
  return overrides;
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

glm::ivec2 sizeFrom(const Json& size) {
  if (!size.is_array() || size.size() != 2) throw Error(say<"\"%1\" wants [width, height]">("size"));
  return {wholeFrom(size[0], "size[0]", kMinSide, kMaxSide),
          wholeFrom(size[1], "size[1]", kMinSide, kMaxSide)};
}

SessionLane furtherLaneFrom(const Json& lane, const std::string& place, Notes& notes) {
  static constexpr std::string_view kKeys[] = {"preset", "presetSettings", "settings"};
  requireKeys(lane, place, kKeys);
  return laneFromJson(lane, place, notes);
}

SessionFile sessionFromJson(const Json& object) {
  static constexpr std::string_view kKeys[] = {
      "format",      "source",  "camera",   "frame",          "size",   "preset", "presetSettings",
      "settings",    "lanes",   "track",    "animation",      "length", "hidden", "isolated",
      "motionModes", "classes", "restarts", "checkpointsMiB", "window"};
  requireKeys(object, "", kKeys);
  const auto required = [&](std::string_view key) -> const Json& { return requireField(object, "", key); };
  requireFormat(object, kSessionFormat);
  SessionFile session;
  Notes& notes = session.notes;
  session.source = nameFrom(required("source"), "source");
  if (session.source.empty()) throw Error(say<"\"%1\" is empty">("source"));
  session.camera = nameFrom(object.value("camera", Json("")), "camera");
  session.choice.animation = nameFrom(object.value("animation", Json("")), "animation");
  session.choice.frames = wholeFrom(object.value("length", Json(0)), "length", 0, kMaxShotFrames);
  session.frame = wholeFrom(required("frame"), "frame", 0, kMaxFrame);
  session.size = sizeFrom(required("size"));
  session.settings = laneFromJson(object, "", notes);
  session.lanes =
      listFrom(object, "lanes", kMaxFurtherLanes, [&](const Json& lane, const std::string& place) {
        return furtherLaneFrom(lane, place, notes);
      });
  if (const Json* const track = findField(object, "track")) session.track = cameraTrackFrom(*track, "track");
  session.filter = {listFrom(object, "hidden", kMaxModes, nameFrom),
                    listFrom(object, "isolated", kMaxModes, nameFrom)};
  session.motionModes = overridesFrom(object, "motionModes", parseMotionOverride);
  session.objectClasses = overridesFrom(object, "classes", parseClassOverride);
  session.restarts = listFrom(object, "restarts", kMaxModes, [](const Json& frame, const std::string& place) {
    return wholeFrom(frame, place, 0, kMaxFrame);
  });
  session.checkpointsMiB =
      wholeFrom(object.value("checkpointsMiB", Json(session.checkpointsMiB)), "checkpointsMiB", 0, kMaxMiB);
  Json window = object.value("window", Json::object());
  requireObject(window, "window");
  renameFields(window, notes);
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

std::string sessionRefusal(const std::string& place, const std::string& reason) {
  return say<"cannot open the session %1: %2">(place, reason);
}

SessionFile sessionFromText(const std::string& text, const std::string& place) {
  try {
    return sessionFromJson(parseLimited(text, {.bytes = kMaxSessionBytes}));
  } catch (const Json::exception& error) {
    throw Error(sessionRefusal(place, shownReason(error)));
  } catch (const Error& error) {
    throw Error(sessionRefusal(place, error.what()));
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
