// Where scenes come from: a name or a path in, a Scene out.
#pragma once

#include "core/base/Progress.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneCost.h"
#include "core/scene/ShotChoice.h"

#include <string>
#include <vector>

namespace taa {

struct BuiltinScene {
  std::string id; ///< "fan", opened as "builtin:fan"
  std::string label;
  std::string description;             ///< one sentence: what it shows
  std::vector<std::string> settings{}; ///< "path=value" that shows it, where the default would not
  SunShadows shadows = SunShadows::None;
};

const std::vector<BuiltinScene>& builtinScenes();

/// The one that `source`, "builtin:NAME", names; null: it names none.
const BuiltinScene* findBuiltinScene(const std::string& source);

/// Whether `source` names a built-in scene, "builtin:NAME", one that there is or not.
bool isBuiltinScene(const std::string& source);

/// Throws Error naming those that there are, where `source` names none of them.
void requireBuiltinScene(const std::string& source);

/// Opens "builtin:NAME" or the path of a .gltf or .glb file, which the budget is for.
/// Throws Error with file, place and reason when that is not possible; nothing else escapes.
Scene openScene(const std::string& source, const Progress& progress = {}, const ShotChoice& choice = {},
                const SceneBudget& budget = {});

} // namespace taa
