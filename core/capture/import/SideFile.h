// What JSON files beside pictures say of their frames: jitter, matrices, planes of the camera. Keys are known
// by their words, however they are written.
#pragma once

#include "core/capture/format/Manifest.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace taa::capture {

/// A list of frames in a side file.
struct SideFrames {
  std::string name;                     ///< "taa" of {"taa": {"frames": [...]}}; empty: the file has one list
  std::map<int, CapturedFrame> frames;  ///< by number; planes are empty
  bool hasJitter = false;               ///< that is not 0 in all frames
  std::optional<ScreenUnit> jitterUnit; ///< as the key says
  bool isNumbered = false;              ///< false: they are in the order of the files
  bool isProjectionJittered = false;    ///< only that was there
};

struct SideFile {
  std::string file, name, engine;
  double nearPlane = 0.0, farPlane = 0.0, framesPerSecond = 0.0; ///< 0: not said
  std::map<std::uint32_t, std::string> objects;
  std::vector<SideFrames> lists;
};

/// Of `file` below `folder`; nothing where it holds no frames. Throws Error where it is no JSON.
std::optional<SideFile> readSideFile(const std::filesystem::path& folder, const std::string& file);

/// What matrices show of their conventions, and whether they show it.
struct SeenMatrices {
  MatrixConventions conventions;
  bool isOrderSeen = false, isForwardSeen = false, isClipZSeen = false;
};

/// `start` with what the matrices themselves and the near plane show; 0: it is not known. `frames` without
/// matrices show nothing.
SeenMatrices matricesOf(const SideFrames& frames, double nearPlane, const MatrixConventions& start);

} // namespace taa::capture
