// The same pixel under other choices: what the resolve would have made of the same inputs, by the CPU twin.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

enum class WhatIfGroup : std::uint8_t { Rectify, Box, Filter, Preset };
std::string_view whatIfGroupLabel(WhatIfGroup group);

struct Variant {
  WhatIfGroup group{};
  std::string id, label;  ///< of the choice or the preset
  bool isCurrent = false; ///< the choice of the settings, or settings that equal the preset
  Settings settings;
  std::string note; ///< what of it does not count here; empty: all does
};

/// Every rectification, box and history filter in place of that of `settings`, then every preset. What
/// decides how the scene is drawn stays, since the inputs do.
std::vector<Variant> variantsOf(const Settings& settings);

/// A variant of a pixel.
struct WhatIfRow {
  WhatIfGroup group{};
  std::string id, label, note;
  bool isCurrent = false;
  glm::vec3 resolved{0.0f}, difference{0.0f}; ///< difference: from the settings' own
  glm::vec3 historyRaw{0.0f}, historyRectified{0.0f};
  float alpha = 0.0f;
  int rejectReason = 0;
};

std::vector<WhatIfRow> whatIf(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel);

} // namespace taa
