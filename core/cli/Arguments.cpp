#include "core/cli/Arguments.h"

#include "core/base/Error.h"
#include "core/base/OldNames.h"
#include "core/io/CameraTrackJson.h"
#include "core/measure/Metrics.h"
#include "core/settings/Lanes.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace taa::cli {

namespace {

constexpr int kMinAskedSide = 4, kMaxAskedSide = 32768; // of every picture; the driver may draw none so large
constexpr std::string_view kMotionPrefix = "motion.";   ///< of assignments that are for an object

std::optional<int> parseCount(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

/// Two numbers from 0 with `separator` between them.
std::optional<glm::ivec2> parsePair(const std::string& text, std::string_view separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string::npos) return std::nullopt;
  const std::optional<int> first = parseCount(std::string_view(text).substr(0, at));
  const std::optional<int> second = parseCount(std::string_view(text).substr(at + separator.size()));
  if (!first || !second) return std::nullopt;
  return glm::ivec2(*first, *second);
}

} // namespace

LaneChoice laneOfPreset(const std::string& name, const std::string& preset) {
  // A name that is wrong is the caller's mistake; a file that cannot be read is the world's.
  const auto read = [&] {
    const Preset row = taa::preset(preset);
    return LaneChoice{name, preset, row.settings, row.notes};
  };
  if (preset.ends_with(".json")) return read();
  try {
    return read();
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
}

FrameRange parseFrames(const std::string& text) {
  const std::optional<int> one = parseCount(text);
  const std::optional<glm::ivec2> pair = one ? glm::ivec2(*one) : parsePair(text, "..");
  if (!pair) throw UsageError("--frames " + text + ": expected A..B, for example 0..31, or one frame");
  if (pair->y < pair->x) throw UsageError("--frames " + text + ": the last frame is before the first");
  return {pair->x, pair->y};
}

glm::ivec2 parseSize(const std::string& text) {
  const std::optional<glm::ivec2> size = parsePair(text, "x");
  if (!size || size->x < kMinAskedSide || size->y < kMinAskedSide || size->x > kMaxAskedSide ||
      size->y > kMaxAskedSide)
    throw UsageError("--size " + text + ": expected WIDTHxHEIGHT in pixels, each from " +
                     std::to_string(kMinAskedSide) + " to " + std::to_string(kMaxAskedSide) +
                     ", for example 1280x720");
  return *size;
}

glm::ivec2 parsePixel(const std::string& text) {
  const std::optional<glm::ivec2> pixel = parsePair(text, ",");
  if (!pixel)
    throw UsageError("--pixel " + text + ": expected X,Y, for example 412,207; 0,0 is the top left");
  return *pixel;
}

SweepShard parseShard(const std::string& text) {
  const std::optional<glm::ivec2> shard = parsePair(text, "/");
  if (!shard || shard->x < 1 || shard->x > shard->y)
    throw UsageError("--shard " + text + ": expected I/N, the I-th of N parts, for example 1/4");
  return {static_cast<std::size_t>(shard->x), static_cast<std::size_t>(shard->y)};
}

std::vector<IntermediateId> parseEmit(const std::vector<std::string>& names) {
  std::vector<IntermediateId> ids;
  for (const std::string& name : names) {
    if (name == "all") {
      for (const IntermediateId id : allRows())
        if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
      continue;
    }
    try {
      const IntermediateId id = intermediateNamed(name);
      if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
    } catch (const Error& error) {
      throw UsageError(std::string("--emit: ") + error.what());
    }
  }
  return ids;
}

void checkReferenceSamples(int samples) {
  if (samples < kMinReferenceSamples || samples > kMaxReferenceSamples)
    throw UsageError("--reference-samples " + std::to_string(samples) + ": expected " +
                     std::to_string(kMinReferenceSamples) + " to " + std::to_string(kMaxReferenceSamples));
}

std::vector<MotionOverride> motionModesOf(const ShotArguments& arguments) {
  std::vector<MotionOverride> modes;
  const auto add = [&](const std::string& text, const char* flag) {
    try {
      modes.push_back(parseMotionOverride(text));
    } catch (const Error& error) {
      throw UsageError(std::string(flag) + ": " + error.what());
    }
  };
  for (const std::string& text : arguments.motionModes) add(text, "--motion-mode");
  for (const std::string& text : arguments.assignments)
    if (text.starts_with(kMotionPrefix)) add(text.substr(kMotionPrefix.size()), "--set");
  return modes;
}

std::vector<ClassOverride> objectClassesOf(const ShotArguments& arguments) {
  std::vector<ClassOverride> classes;
  for (const std::string& text : arguments.classes) try {
      classes.push_back(parseClassOverride(text));
    } catch (const Error& error) {
      throw UsageError(std::string("--class: ") + error.what());
    }
  return classes;
}

std::optional<CameraTrack> cameraTrackOf(const ShotArguments& arguments) {
  if (!arguments.cameraPath.empty()) return readCameraTrack(arguments.cameraPath);
  if (arguments.cameraPose.empty()) return {};
  try {
    return CameraTrack{kFreeCamera, 0, {parseCameraPose(arguments.cameraPose)}};
  } catch (const Error& error) {
    throw UsageError(std::string("--camera-pose: ") + error.what());
  }
}

std::vector<LaneChoice> lanesOf(const ShotArguments& arguments) {
  if (arguments.lanes.size() > std::size_t{kMaxLanes})
    throw UsageError("--lane was given " + std::to_string(arguments.lanes.size()) + " times; there are " +
                     std::to_string(kMaxLanes) + " lanes at most");
  std::vector<LaneChoice> lanes;
  for (const std::string& name : arguments.lanes)
    lanes.push_back(laneOfPreset(std::string(1, static_cast<char>('A' + lanes.size())), name));
  if (lanes.empty()) lanes.push_back(laneOfPreset("", arguments.preset));
  if (lanes.size() == 1) lanes[0].name.clear();
  assign(lanes, arguments.assignments);
  return lanes;
}

void assign(std::vector<LaneChoice>& lanes, const std::vector<std::string>& assignments) {
  for (LaneChoice& lane : lanes)
    for (const std::string& assignment : assignments) try {
        if (assignment.starts_with(kMotionPrefix)) continue; // of an object, not of a lane: motionModesOf
        addNotes(lane.notes, applyAssignment(lane.settings, assignment));
      } catch (const Error& error) {
        throw UsageError(std::string("--set: ") + error.what());
      }
}

} // namespace taa::cli
