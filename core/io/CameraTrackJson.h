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
/// Throws Error that says what is wrong with it.
CameraTrack cameraTrackFrom(const nlohmann::json& json);
CameraTrack readCameraTrack(const std::filesystem::path& path);

} // namespace taa
