#include "core/probe/WhatIf.h"

#include "core/base/Say.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/History.h"

#include <array>
#include <utility>

namespace taa {

namespace {

struct ParameterOfGroup {
  WhatIfGroup group;
  std::string_view label, path; ///< path: of the parameter; empty for presets
};

constexpr std::array<ParameterOfGroup, 4> kGroups{{{WhatIfGroup::Rectify, "Rectification", "rectify.method"},
                                                   {WhatIfGroup::Box, "Box", "neighborhood.box"},
                                                   {WhatIfGroup::Filter, "History filter", "history.filter"},
                                                   {WhatIfGroup::Preset, "Preset", ""}}};

void addChoices(const ParameterOfGroup& group, const Settings& settings, std::vector<Variant>& variants) {
  const Parameter& row = parameter(group.path);
  for (std::size_t choice = 0; choice < row.choices.size(); ++choice) {
    const auto value = static_cast<double>(choice);
    Variant variant{group.group,
                    std::string(row.choices[choice].id),
                    std::string(row.choices[choice].label),
                    row.get(settings) == value,
                    settings,
                    {}};
    row.set(variant.settings, value);
    variants.push_back(std::move(variant));
  }
}

/// What the present history does not hold although these settings test it.
std::string missingOf(const Settings& wanted, const Settings& present) {
  std::string missing;
  for (const HistoryLayer& layer : historyLayers())
    if (layer.isNeeded(wanted) && !layer.isNeeded(present))
      missing += (missing.empty() ? "" : ", ") + std::string(layer.name);
  return missing;
}

std::string noteOf(const Settings& preset, const Settings& used, const Settings& present) {
  const bool isChanged = !sameInputs(preset, used);
  const std::string missing = missingOf(used, present);
  if (missing.empty()) return isChanged ? say<"jitter and inputs as now">() : "";
  if (isChanged) return say<"jitter and inputs as now; history keeps no %1">(missing);
  return say<"history keeps no %1">(missing);
}

} // namespace

std::string_view whatIfGroupLabel(WhatIfGroup group) {
  return kGroups[static_cast<std::size_t>(group)].label;
}

std::vector<Variant> variantsOf(const Settings& settings) {
  std::vector<Variant> variants;
  for (const ParameterOfGroup& group : kGroups)
    if (!group.path.empty()) addChoices(group, settings, variants);
  for (const Preset& preset : wholePresets()) {
    if (!isTaaOn(preset.settings)) continue; // that is another frame, which is not jittered
    Settings used = preset.settings;
    used.jitter = settings.jitter;
    used.inputs = settings.inputs;
    variants.push_back({WhatIfGroup::Preset, preset.id, preset.label, preset.settings == settings, used,
                        noteOf(preset.settings, used, settings)});
  }
  return variants;
}

std::vector<WhatIfRow> whatIf(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  const twin::PixelRecord own = twin::resolvePixel(inputs, settings, pixel.x, pixel.y);
  const glm::vec3 resolved(twin::at(own, IntermediateId::resolved));
  std::vector<WhatIfRow> rows;
  for (const Variant& variant : variantsOf(settings)) {
    const twin::PixelRecord record = twin::resolvePixel(inputs, variant.settings, pixel.x, pixel.y);
    const auto color = [&](IntermediateId id) { return glm::vec3(twin::at(record, id)); };
    const glm::vec3 made = color(IntermediateId::resolved);
    rows.push_back({variant.group, variant.id, variant.label, variant.note, variant.isCurrent, made,
                    made - resolved, color(IntermediateId::historyRaw),
                    color(IntermediateId::historyRectified), twin::at(record, IntermediateId::alpha).x,
                    static_cast<int>(twin::at(record, IntermediateId::rejectReason).x)});
  }
  return rows;
}

} // namespace taa
