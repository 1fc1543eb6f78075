// Flown cameras as text: a pose on a command line, a track in a file.
#pragma once

#include "core/scene/camera/CameraTrack.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace taa {

/// "x,y,z,yaw,pitch,fov": what parseCameraPose() reads back to the same bits.
std::string poseText(const CameraPose& pose);
/// Reads "x,y,z,yaw,pitch" or "x,y,z,yaw,pitch,fov"; degrees. Throws Error that says what is expected.
CameraPose parseCameraPose(const std::string& text);

/// {"name": …, "firstFrame": …, "poses": [[x, y, z, yaw, pitch, fov], …]}
nlohmann::ordered_json cameraTrackJson(const CameraTrack& track);
/// `place`: its path in the file, empty where it is all of it. Throws Error that says what is wrong where.
CameraTrack cameraTrackFrom(const nlohmann::json& json, const std::string& place = {});
/// Throws Error that names the file.
CameraTrack readCameraTrack(const std::filesystem::path& path);

} // namespace taa
