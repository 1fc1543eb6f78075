// taa-batch list: the tables, for people and for programs.
#include "core/cli/Commands.h"

#include "core/cli/Table.h"
#include "core/io/FrameJson.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"

#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

/// The same list for people and for programs.
struct Listing {
  std::vector<std::vector<std::string>> rows;
  ordered_json json = ordered_json::array();
};

Listing listIntermediates() {
  Listing list;
  for (const Intermediate& row : kIntermediates) {
    list.rows.push_back({std::string(row.name), std::string(stageInfo(row.stage).id), std::string(row.unit),
                         std::string(row.description)});
    list.json.push_back(intermediateJson(row));
  }
  return list;
}

std::string allowedText(const Parameter& row) {
  if (row.kind == ParameterKind::Toggle) return "on|off";
  if (row.kind != ParameterKind::Choice)
    return floatText(static_cast<float>(row.minimum)) + ".." + floatText(static_cast<float>(row.maximum));
  std::string text;
  for (const Choice& choice : row.choices) text += (text.empty() ? "" : "|") + std::string(choice.id);
  return text;
}

Listing listParameters() {
  Listing list;
  for (const Parameter& row : parameters()) {
    list.rows.push_back({std::string(row.path) + "=" + valueText(row, row.defaultValue()), allowedText(row),
                         std::string(row.unit), std::string(row.tooltip)});
    list.json.push_back(parameterJson(row));
  }
  return list;
}

Listing listPresets() {
  Listing list;
  list.rows.push_back({std::string(kPresetGroups.front().label)});
  for (const Preset& row : builtinPresets()) {
    if (const PresetGroup* group = startedGroup(row)) {
      list.rows.emplace_back();
      list.rows.push_back({std::string(group->label)});
    }
    list.rows.push_back({row.id, row.label, row.description});
    list.json.push_back({{"id", row.id},
                         {"label", row.label},
                         {"group", row.group},
                         {"step", row.step},
                         {"description", row.description},
                         {"settings", toJson(row.settings)}});
  }
  return list;
}

Listing listScenes() {
  Listing list;
  for (const BuiltinScene& row : builtinScenes()) {
    list.rows.push_back({"builtin:" + row.id, row.label, row.description});
    list.json.push_back({{"source", "builtin:" + row.id},
                         {"label", row.label},
                         {"description", row.description},
                         {"settings", row.settings}});
  }
  return list;
}

Listing listing(const std::string& what) {
  if (what == "intermediates") return listIntermediates();
  if (what == "parameters") return listParameters();
  if (what == "presets") return listPresets();
  if (what == "scenes") return listScenes();
  throw UsageError("cannot list \"" + what + "\"; there are intermediates, parameters, presets and scenes");
}

} // namespace

void runList(const ListArguments& arguments, std::ostream& out) {
  const Listing list = listing(arguments.what);
  if (arguments.json)
    out << list.json.dump(2) << '\n';
  else
    printTable(out, list.rows);
}

} // namespace taa::cli
