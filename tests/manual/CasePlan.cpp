#include "tests/manual/CasePlan.h"

#include "core/settings/Presets.h"
#include "core/settings/Settings.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>

namespace taa {

namespace {

/// Frames to inject into, without a fault.
std::vector<PlannedCase> sourcesOf(const CasePlan& plan) {
  std::vector<PlannedCase> out;
  for (const std::string& scene : plan.scenes)
    for (const std::string& camera : plan.cameras) {
      const std::string path = "builtin:" + scene;
      out.push_back({{path, camera, plan.sizePx, plan.frames, {}, false}, path});
    }
  for (const std::string& folder : plan.captures) {
    const std::filesystem::path path(folder);
    const std::filesystem::path name = path.has_filename() ? path.filename() : path.parent_path().filename();
    out.push_back({{name.string(), "", {0, 0}, plan.frames, {}, false}, folder});
  }
  return out;
}

bool isPossible(Fault fault, const PlannedCase& source) {
  return faultInfo(fault).reach == FaultReach::Any || source.path.starts_with("builtin:");
}

/// Another partner for each `turn`.
std::optional<Fault> partnerOf(Fault fault, const PlannedCase& source, std::size_t turn) {
  std::vector<Fault> partners;
  for (const FaultInfo& other : faultTable())
    if (other.part != faultInfo(fault).part && other.part != FaultPart::Resolve &&
        isPossible(other.fault, source) && !excludeEachOther(fault, other.fault))
      partners.push_back(other.fault);
  if (partners.empty()) return {};
  // Steps that share no factor with lengths of tables reach all.
  return partners[(static_cast<std::size_t>(fault) + 13 * turn) % partners.size()];
}

void planFault(const CasePlan& plan, Fault fault, const PlannedCase& source, std::size_t turn,
               std::vector<PlannedCase>& out) {
  const auto add = [&](std::vector<Fault> faults, bool isHalf) {
    PlannedCase planned = source;
    planned.tried.faults = std::move(faults);
    planned.tried.isHalf = isHalf;
    out.push_back(std::move(planned));
  };
  Settings settings;
  if (plan.single) add({fault}, false);
  if (plan.half && injectHalf(fault, settings)) add({fault}, true);
  if (!plan.pairs || faultInfo(fault).part == FaultPart::Resolve) return;
  if (const auto partner = partnerOf(fault, source, turn)) add({fault, *partner}, false);
}

void planPresets(const PlannedCase& source, std::vector<PlannedCase>& out) {
  for (const Preset& preset : builtinPresets()) {
    PlannedCase planned = source;
    planned.tried.preset = preset.id;
    out.push_back(std::move(planned));
  }
}

} // namespace

std::vector<PlannedCase> plannedCases(const CasePlan& plan) {
  std::vector<PlannedCase> out;
  const std::vector<PlannedCase> sources = sourcesOf(plan);
  for (std::size_t turn = 0; turn < sources.size(); ++turn) {
    if (plan.healthy) out.push_back(sources[turn]);
    if (plan.presets && sources[turn].path.starts_with("builtin:")) planPresets(sources[turn], out);
    for (const Fault fault : plan.faults)
      if (isPossible(fault, sources[turn])) planFault(plan, fault, sources[turn], turn, out);
  }
  return out;
}

} // namespace taa
