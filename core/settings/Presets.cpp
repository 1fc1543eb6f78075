#include "core/settings/Presets.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Files.h"
#include "core/settings/Parameters.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace taa {

namespace {

constexpr int kFormat = 1;

std::vector<Preset> loadBuiltinPresets() {
  std::vector<Preset> presets;
  for (const std::string& path : embeddedPaths("resources/presets/"))
    presets.push_back(presetFromText(embeddedText(path), path));
  std::ranges::stable_partition(presets, [](const Preset& row) { return row.id == "balanced"; });
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
  throw Error("there is no preset \"" + idOrPath + "\"; there are " + known +
              ", or give a file that ends in .json");
}

Preset presetFromText(const std::string& text, const std::string& place) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    for (const auto& [key, value] : json.items())
      if (key != "format" && key != "id" && key != "label" && key != "description" && key != "settings")
        throw Error("there is no preset field \"" + key + "\"");
    if (json.at("format") != kFormat)
      throw Error("its format is " + json.at("format").dump() + ", this program reads " +
                  std::to_string(kFormat));
    Preset row{json.at("id"), json.at("label"), json.value("description", ""), {}};
    fromJson(json.at("settings"), row.settings);
    return row;
  } catch (const nlohmann::json::exception& error) {
    throw Error("cannot read preset " + place + ": " + error.what());
  } catch (const Error& error) {
    throw Error("cannot read preset " + place + ": " + error.what());
  }
}

std::string presetToText(const Preset& row) {
  nlohmann::ordered_json json;
  json["format"] = kFormat;
  json["id"] = row.id;
  json["label"] = row.label;
  json["description"] = row.description;
  json["settings"] = toJson(row.settings);
  return json.dump(2) + "\n";
}

} // namespace taa
