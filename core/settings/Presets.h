// Named settings: the built-in ones from resources/presets, and a user's own from files.
#pragma once

#include "core/settings/Settings.h"

#include <string>
#include <vector>

namespace taa {

struct Preset {
  std::string id; ///< "balanced"
  std::string label;
  std::string group; ///< heading it is listed under: "ours", "engines", "sources"; empty for a user's own
  int order = 0;     ///< place among the built-in ones
  std::string description;
  Settings settings;
};

/// The built-in presets, in their order, "balanced" first.
const std::vector<Preset>& builtinPresets();

/// A built-in preset by id, or a file that ends in ".json". Throws Error naming what there is.
Preset preset(const std::string& idOrPath);

/// A preset file: {"format": 1, "id", "label", "group", "order", "description", "settings": {…}}; group,
/// order and description may be left out. Throws Error naming `place`.
Preset presetFromText(const std::string& text, const std::string& place);
std::string presetToText(const Preset& preset);

} // namespace taa
