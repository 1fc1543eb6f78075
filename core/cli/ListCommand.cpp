// taa-batch list: the tables, for people and for programs.
#include "core/base/NumberText.h"
#include "core/cli/Command.h"
#include "core/cli/Options.h"
#include "core/cli/Table.h"
#include "core/io/FrameJson.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
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
    return shortestText(static_cast<float>(row.minimum)) + ".." +
           shortestText(static_cast<float>(row.maximum));
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

const std::vector<std::pair<std::string, Listing (*)()>> kListings = {
    {"intermediates", listIntermediates},
    {"parameters", listParameters},
    {"presets", listPresets},
    {"scenes", listScenes},
};

struct ListCommand final : Command {
  std::string what; ///< of kListings
  bool json = false;

  ListCommand() : Command("list") {
    description("Say what there is");
    std::vector<std::string> names;
    for (const auto& [name, listing] : kListings) names.push_back(name);
    add_option("WHAT", what, enumeration(names, " or "))->required()->check(CLI::IsMember(names));
    addJson(*this, json);
  }

  int run(std::ostream& out, const Progress&) const override {
    const Listing list =
        std::ranges::find(kListings, what, &decltype(kListings)::value_type::first)->second();
    if (json)
      print(out, list.json);
    else
      printTable(out, list.rows);
    return kDone;
  }
};

} // namespace

std::shared_ptr<Command> listCommand() {
  return std::make_shared<ListCommand>();
}

} // namespace taa::cli
