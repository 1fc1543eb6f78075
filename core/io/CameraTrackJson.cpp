#include "core/io/CameraTrackJson.h"

#include "core/base/Files.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"
#include "core/base/json/LimitedJson.h"
#include "core/io/FrameJson.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace taa {

namespace {

using nlohmann::ordered_json;

constexpr std::uintmax_t kMaxTrackBytes = std::uintmax_t(64) << 20;
constexpr int kMaxFirstFrame = 1'000'000;
constexpr std::size_t kMaxNumbers = 6, kMinNumbers = 5;
constexpr std::size_t kMaxPoses = 1'000'000;

std::array<float, kMaxNumbers> numbersOf(const CameraPose& pose) {
  return {pose.position.x, pose.position.y, pose.position.z, pose.yaw, pose.pitch, pose.fovY};
}

/// As many as there are; the rest is as in a pose that nobody set.
CameraPose poseFrom(const std::vector<float>& numbers) {
  CameraPose pose;
  pose.position = {numbers[0], numbers[1], numbers[2]};
  pose.yaw = numbers[3];
  pose.pitch = numbers[4];
  if (numbers.size() == kMaxNumbers) pose.fovY = numbers[5];
  return pose;
}

CameraPose poseFrom(const nlohmann::json& row, const std::string& place) {
  requireList(row, place, kMaxNumbers);
  if (row.size() < kMinNumbers)
    throw Error(say<"\"%1\" has %2 numbers; a pose is [x, y, z, yaw, pitch, fov]">(place, row.size()));
  std::vector<float> numbers;
  for (const nlohmann::json& number : row)
    numbers.push_back(static_cast<float>(numberOf(number, elementOf(place, numbers.size()))));
  return poseFrom(numbers);
}

} // namespace

std::string poseText(const CameraPose& pose) {
  std::string text;
  for (const float number : numbersOf(pose)) text += (text.empty() ? "" : ",") + shortestText(number);
  return text;
}

CameraPose parseCameraPose(const std::string& text) {
  std::vector<float> numbers;
  std::string_view rest = text;
  bool isRight = !rest.empty();
  while (isRight && !rest.empty()) {
    float number = 0.0f;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    isRight = error == std::errc() && (rest.empty() || (rest.front() == ',' && rest.size() > 1));
    if (!rest.empty()) rest.remove_prefix(1);
    numbers.push_back(number);
  }
  if (!isRight || numbers.size() < kMinNumbers || numbers.size() > kMaxNumbers)
    throw Error(say<"\"%1\" is not x,y,z,yaw,pitch or x,y,z,yaw,pitch,fov, for example 0,1.6,4,0,-10">(text));
  CameraPose pose = poseFrom(numbers);
  checkCameraTrack({kFreeCamera, 0, {pose}});
  return pose;
}

ordered_json cameraTrackJson(const CameraTrack& track) {
  ordered_json poses = ordered_json::array();
  for (const CameraPose& pose : track.poses) {
    ordered_json row = ordered_json::array();
    for (const float number : numbersOf(pose)) row.push_back(floatJson(number));
    poses.push_back(std::move(row));
  }
  return {{"name", track.name}, {"firstFrame", track.firstFrame}, {"poses", std::move(poses)}};
}

CameraTrack cameraTrackFrom(const nlohmann::json& json, const std::string& place) {
  static constexpr std::string_view kKeys[] = {"name", "firstFrame", "poses"};
  requireKeys(json, place, kKeys);
  const auto given = [&](std::string_view key) -> const nlohmann::json& {
    return requireField(json, place, key);
  };
  CameraTrack track;
  track.name = plainText(textOf(given("name"), pathOf(place, "name")));
  track.firstFrame =
      static_cast<int>(integerOf(given("firstFrame"), pathOf(place, "firstFrame"), 0, kMaxFirstFrame));
  const std::string list = pathOf(place, "poses");
  requireList(given("poses"), list, kMaxPoses);
  for (const nlohmann::json& row : given("poses"))
    track.poses.push_back(poseFrom(row, elementOf(list, track.poses.size())));
  checkCameraTrack(track);
  return track;
}

CameraTrack readCameraTrack(const std::filesystem::path& path) {
  const std::string text = readFile(path, kMaxTrackBytes);
  try {
    return cameraTrackFrom(parseLimited(text));
  } catch (const Error& error) {
    throw Error(say<"cannot read the camera path %1: %2">(path.string(), error.what()));
  }
}

} // namespace taa
