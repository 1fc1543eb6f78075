#include "core/settings/Presets.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"
#include "core/base/json/LimitedJson.h"
#include "core/settings/Parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

namespace taa {

namespace {

constexpr int kPresetFormat = 1, kMaxOrder = 1000;
constexpr std::string_view kPresetFields[] = {"format", "id",          "label", "group",   "order",
                                              "step",   "description", "base",  "settings"};

/// Settings of the preset of this id, which others change.
using SettingsOf = std::function<Settings(const std::string& id)>;

Preset presetFromJson(const nlohmann::json& json, const SettingsOf& settingsOf) {
  requireKeys(json, "", kPresetFields);
  requireFormat(json, kPresetFormat);
  const auto text = [&](const char* key) {
    const nlohmann::json* const found = findField(json, key);
    return found ? textOf(*found, key) : std::string();
  };
  const auto whole = [&](const char* key) {
    const nlohmann::json* const found = findField(json, key);
    return found ? static_cast<int>(integerOf(*found, key, 0, kMaxOrder)) : 0;
  };
  Preset row{textOf(requireField(json, "", "id"), "id"),
             textOf(requireField(json, "", "label"), "label"),
             text("group"),
             whole("order"),
             text("description"),
             json.contains("base") ? settingsOf(text("base")) : Settings{},
             whole("step")};
  row.notes = fromJson(requireField(json, "", "settings"), row.settings);
  return row;
}

/// Calls `read`, whose errors are about `place`.
template <typename Read>
Preset readPreset(const std::string& place, Read read) {
  try {
    return read();
  } catch (const Error& error) {
    throw Error(say<"cannot read preset %1: %2">(place, error.what()));
  }
}

std::size_t groupIndex(const std::string& group) {
  return static_cast<std::size_t>(std::ranges::find(kPresetGroups, group, &PresetGroup::id) -
                                  kPresetGroups.begin());
}

/// One may go on from another, which may stand after it.
std::vector<Preset> loadBuiltinPresets() {
  std::map<std::string, nlohmann::json> files;
  for (const std::string& path : embeddedPaths("resources/presets/")) {
    nlohmann::json json = nlohmann::json::parse(embeddedText(path));
    files.emplace(json.at("id"), std::move(json));
  }
  const SettingsOf settingsOf = [&](const std::string& id) {
    return presetFromJson(files.at(id), settingsOf).settings;
  };
  std::vector<Preset> presets;
  for (const auto& file : files)
    presets.push_back(readPreset(file.first, [&] { return presetFromJson(file.second, settingsOf); }));
  std::ranges::sort(presets, {},
                    [](const Preset& row) { return std::pair(groupIndex(row.group), row.order); });
  return presets;
}

} // namespace

const std::vector<Preset>& builtinPresets() {
  static const std::vector<Preset> kPresets = loadBuiltinPresets();
  return kPresets;
}

const std::vector<Preset>& wholePresets() {
  static const std::vector<Preset> kWhole = [] {
    std::vector<Preset> whole;
    std::ranges::copy_if(builtinPresets(), std::back_inserter(whole),
                         [](const Preset& row) { return row.step == 0; });
    return whole;
  }();
  return kWhole;
}

const PresetGroup* startedGroup(const Preset& preset) {
  const auto first = std::ranges::find(builtinPresets(), preset.group, &Preset::group);
  const std::size_t group = groupIndex(preset.group);
  return first != builtinPresets().end() && first->id == preset.id && group > 0 ? &kPresetGroups.at(group)
                                                                                : nullptr;
}

std::vector<const Preset*> ladderOf(std::string_view id) {
  std::vector<const Preset*> rungs;
  const auto found = std::ranges::find(builtinPresets(), id, &Preset::id);
  if (found == builtinPresets().end()) return rungs;
  for (const Preset& each : builtinPresets())
    if (each.group == found->group) rungs.push_back(&each);
  const bool hasSteps = std::ranges::any_of(rungs, [](const Preset* each) { return each->step > 0; });
  return hasSteps ? rungs : std::vector<const Preset*>();
}

Preset preset(const std::string& idOrPath) {
  std::string known; // those of a source's ladder by its name alone: a hundred ids are no answer
  for (const Preset& row : builtinPresets()) {
    if (row.id == idOrPath) return row;
    if (row.step > 0 && row.id.starts_with("source")) continue;
    known += (known.empty() ? "" : ", ") + row.id;
  }
  if (idOrPath.ends_with(".json")) return presetFromText(readFile(idOrPath, 1 << 20), idOrPath);
  throw Error(say<"there is no preset \"%1\"; there are %2, their steps (see list presets), or give a file "
                  "that ends in "
                  ".json">(shownText(idOrPath), known));
}

Preset presetFromText(const std::string& text, const std::string& place) {
  return readPreset(place, [&] {
    return presetFromJson(parseLimited(text), [](const std::string& id) {
      const auto base = std::ranges::find(builtinPresets(), id, &Preset::id);
      if (base == builtinPresets().end())
        throw Error(say<"there is no preset \"%1\" to go on from">(shownText(id)));
      return base->settings;
    });
  });
}

std::string presetToText(const Preset& row) {
  nlohmann::ordered_json json;
  json["format"] = kPresetFormat;
  json["id"] = row.id;
  json["label"] = row.label;
  if (!row.group.empty()) {
    json["group"] = row.group;
    json["order"] = row.order;
  }
  if (row.step > 0) json["step"] = row.step;
  json["description"] = row.description;
  json["settings"] = toJson(row.settings);
  return json.dump(2) + "\n";
}

} // namespace taa
