#include "core/inspect/SceneSettings.h"

#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Parameters.h"

#include <string_view>
#include <vector>

namespace taa {

namespace {

/// Calls `use` with each row that the scene wants set, and the value that it wants.
template <class Use>
void forEachWanted(const std::string& source, Use use) {
  const BuiltinScene* const scene = findBuiltinScene(source);
  if (!scene) return;
  for (const std::string& assignment : scene->settings) {
    Settings wanted;
    applyAssignment(wanted, assignment);
    const Parameter& row = parameter(std::string_view(assignment).substr(0, assignment.find('=')));
    use(row, row.get(wanted));
  }
}

} // namespace

Settings settingsForScene(const Settings& settings, const std::string& from, const std::string& to) {
  Settings changed = settings;
  if (from == to) return changed;
  forEachWanted(from, [&](const Parameter& row, double wanted) {
    if (row.get(changed) == wanted) row.set(changed, row.defaultValue());
  });
  forEachWanted(to, [&](const Parameter& row, double wanted) {
    if (row.get(changed) == row.defaultValue()) row.set(changed, wanted);
  });
  return changed;
}

} // namespace taa
