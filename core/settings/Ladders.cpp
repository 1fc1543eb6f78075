#include "core/settings/Ladders.h"

#include <algorithm>

namespace taa {

std::vector<const Preset*> ladderOf(std::string_view id) {
  std::vector<const Preset*> rungs;
  const auto found = std::ranges::find(builtinPresets(), id, &Preset::id);
  if (found == builtinPresets().end()) return rungs;
  for (const Preset& each : builtinPresets())
    if (each.group == found->group) rungs.push_back(&each);
  const bool hasSteps = std::ranges::any_of(rungs, [](const Preset* each) { return each->step > 0; });
  return hasSteps ? rungs : std::vector<const Preset*>();
}

} // namespace taa
