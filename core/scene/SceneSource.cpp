#include "core/scene/SceneSource.h"

#include "core/base/Error.h"
#include "core/scene/BuiltinScenes.h"
#include "core/scene/GltfLoader.h"

#include <array>
#include <string_view>

namespace taa {

namespace {

constexpr std::string_view kBuiltinPrefix = "builtin:";

using MakeScene = Scene (*)();
constexpr std::array<MakeScene, 2> kMakers{makeFanScene, makeFenceScene}; // in the order of builtinScenes()

Scene makeBuiltin(const std::string& source) {
  const std::string_view id = std::string_view(source).substr(kBuiltinPrefix.size());
  std::string known;
  for (std::size_t i = 0; i < kMakers.size(); ++i) {
    const BuiltinScene& scene = builtinScenes()[i];
    if (scene.id == id) return kMakers[i]();
    known += (known.empty() ? "" : ", ") + std::string(kBuiltinPrefix) + scene.id;
  }
  throw Error("there is no built-in scene \"" + std::string(id) + "\"; there are " + known);
}

} // namespace

const std::vector<BuiltinScene>& builtinScenes() {
  static const std::vector<BuiltinScene> scenes{
      {"fan", "Fan",
       "A fan spins in its wire guard before bricks and small bright lights: ghosting, thin wires, HDR"},
      {"fence", "Fence",
       "The camera passes pickets, wires and a net, far to near: sub-pixel detail and disocclusion"}};
  return scenes;
}

Scene openScene(const std::string& source, const Progress& progress) {
  if (!source.starts_with(kBuiltinPrefix)) return loadGltf(source, progress);
  report(progress, "Opening the scene", 0, 1);
  Scene scene = makeBuiltin(source);
  report(progress, "Opening the scene", 1, 1);
  return scene;
}

} // namespace taa
