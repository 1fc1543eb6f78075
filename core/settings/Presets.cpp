#include "core/settings/Presets.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/settings/Parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace taa {

namespace {

constexpr int kFormat = 1;
constexpr std::string_view kFields[] = {"format", "id", "label", "group", "order", "description", "settings"};

std::vector<Preset> loadBuiltinPresets() {
  std::vector<Preset> presets;
  for (const std::string& path : embeddedPaths("resources/presets/"))
    presets.push_back(presetFromText(embeddedText(path), path));
  std::ranges::sort(presets, {}, &Preset::order);
  return presets;
}

} // namespace

const std::vector<Preset>& builtinPresets() {
  static const std::vector<Preset> kPresets = loadBuiltinPresets();
  return kPresets;
}

Preset preset(const std::string& idOrPath) {
  std::string known;
  for (const Preset& row : builtinPresets()) {
    if (row.id == idOrPath) return row;
    known += (known.empty() ? "" : ", ") + row.id;
  }
  if (idOrPath.ends_with(".json")) return presetFromText(readFile(idOrPath, 1 << 20), idOrPath);
  throw Error(
      say<"there is no preset \"%1\"; there are %2, or give a file that ends in .json">(idOrPath, known));
}

Preset presetFromText(const std::string& text, const std::string& place) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    for (const auto& [key, value] : json.items())
      if (std::ranges::find(kFields, key) == std::end(kFields))
        throw Error(say<"there is no preset field \"%1\"">(key));
    if (json.at("format") != kFormat)
      throw Error(say<"its format is %1, this program reads %2">(json.at("format").dump(), kFormat));
    Preset row{json.at("id"),
               json.at("label"),
               json.value("group", ""),
               json.value("order", 0),
               json.value("description", ""),
               {}};
    fromJson(json.at("settings"), row.settings);
    return row;
  } catch (const nlohmann::json::exception& error) {
    throw Error(say<"cannot read preset %1: %2">(place, error.what()));
  } catch (const Error& error) {
    throw Error(say<"cannot read preset %1: %2">(place, error.what()));
  }
}

std::string presetToText(const Preset& row) {
  nlohmann::ordered_json json;
  json["format"] = kFormat;
  json["id"] = row.id;
  json["label"] = row.label;
  if (!row.group.empty()) {
    json["group"] = row.group;
    json["order"] = row.order;
  }
  json["description"] = row.description;
  json["settings"] = toJson(row.settings);
  return json.dump(2) + "\n";
}

} // namespace taa
