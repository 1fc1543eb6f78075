// What is known of the frames besides their planes, for sentences about them.
#pragma once

#include "core/capture/format/Conventions.h"
#include "core/doctor/FrameNames.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace taa::doctor {

struct CaptureInfo {
  glm::ivec2 sizePx{0}, outputPx{0}; ///< of what is drawn, of the picture
  std::map<std::uint32_t, std::string> objectNames;
  std::optional<capture::Conventions> conventions; ///< the engine's; none: this program's
  std::map<int, double> preExposure;               ///< as it is stated of each frame; empty: it is not
  FrameNames frameNames = {};
};

} // namespace taa::doctor
