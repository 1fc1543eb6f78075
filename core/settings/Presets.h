// Named settings: the built-in ones from resources/presets, and a user's own from files.
#pragma once

#include "core/settings/Settings.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

struct Preset {
  std::string id; ///< "balanced"
  std::string label;
  std::string group; ///< id of the PresetGroup it is listed under; empty for a user's own
  int order = 0;     ///< place among the built-in ones
  std::string description;
  Settings settings;
  /// Of the ladder that the listings of a source make, from 1: what one of them adds to those before. 0: a
  /// whole pipeline.
  int step = 0;
  std::vector<std::string> notes{}; ///< to say of a file that was read: what has another name by now
};

/// What presets are listed under, in menus and lists alike.
struct PresetGroup {
  std::string_view id, label;
};

/// In the order of the lists. The first one is at hand without a submenu.
inline constexpr std::array<PresetGroup, 7> kPresetGroups{
    {{"ours", "Recommended, and what to compare with"},
     {"engines", "Engines"},
     {"source000", "Blog on TAA in Unity"},
     {"source001", "Castorina and Sassone 2023, chapter 11"},
     {"source002", "Blog on engine practice"},
     {"source003", "Notes on URP"},
     {"source004", "DezemingFamily's booklet"}}};

/// The built-in presets, by groups, each in its order; "balanced" first.
const std::vector<Preset>& builtinPresets();

/// Those of them that are no step of a ladder.
const std::vector<Preset>& wholePresets();

/// The group that the list of the built-in presets comes to with this one of them, if it is listed apart:
/// nothing for those of the first group, and for others than the first of theirs.
const PresetGroup* startedGroup(const Preset& preset);

/// The ladder that a built-in preset is a rung of: what the listings of its source add, one after another, in
/// its order, with the whole pipelines among its steps; empty: it is of none.
std::vector<const Preset*> ladderOf(std::string_view id);

/// A built-in preset by id, or a file that ends in ".json". Throws Error naming what there is.
Preset preset(const std::string& idOrPath);

/// A preset file: {"format": 1, "id", "label", "group", "order", "step", "description", "base", "settings":
/// {…}}; only format, id, label and settings must be there. `base`: the built-in preset that the settings
/// change; without it they change "balanced". Throws Error naming `place`.
Preset presetFromText(const std::string& text, const std::string& place);
std::string presetToText(const Preset& preset);

} // namespace taa
