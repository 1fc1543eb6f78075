// Everything a picture depends on, and what the window looked at, as one JSON file.
#pragma once

#include "core/scene/MotionMode.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/ShotChoice.h"
#include "core/scene/camera/CameraTrack.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// Settings, and the preset they were made from.
struct SessionLane {
  std::string preset = "balanced"; ///< id of a built-in one, or what a user's own is called
  Settings presetSettings, settings;
};

/// A shot, a frame of it and the settings: the same picture, bit for bit, wherever it is opened.
struct SessionFile {
  std::string source; ///< "builtin:NAME" or a path
  std::string camera; ///< empty: the scene's own
  ShotChoice choice;  ///< of its animations and its length
  int frame = 0;
  glm::ivec2 size{1280, 720}; ///< of the picture
  SessionLane settings;
  std::vector<SessionLane> lanes;   ///< further ones beside it
  std::optional<CameraTrack> track; ///< looked through instead of `camera`
  ObjectFilter filter;
  std::vector<MotionOverride> motionModes;
  std::vector<ClassOverride> objectClasses;
  std::vector<int> restarts; ///< frames at which history starts anew
  int checkpointsMiB = 1024;
  std::string window = "{}";        ///< a JSON object: the window's business
  std::vector<std::string> notes{}; ///< to say of a file that was read: what has another name by now
};

/// What their names end in.
inline constexpr std::string_view kSessionEnding = ".taa.json";
bool isSessionName(std::string_view path);

/// As the errors of a session begin: what is wrong with the one of this place.
std::string sessionRefusal(const std::string& place, const std::string& reason);

/// Throws Error naming `place` and what is wrong with it: a key that is not known, a value out of range, JSON
/// that is none.
SessionFile sessionFromText(const std::string& text, const std::string& place);
std::string sessionToText(const SessionFile& session);

/// A scene's path is written relative to the file where it lies beside or below it, and read so. Throw Error.
SessionFile readSession(const std::filesystem::path& path);
void writeSession(const std::filesystem::path& path, const SessionFile& session);

} // namespace taa
