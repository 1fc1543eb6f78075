#include "core/scene/builtin/SceneSource.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/Ground.h"
#include "core/scene/gltf/GltfLoader.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace taa {

namespace {

constexpr std::string_view kBuiltinPrefix = "builtin:";

constexpr std::array kMakers{makeFanScene,     makeFenceScene,   makeDisocclusionScene, makeCutScene,
                             makeThinScene,    makeTextScene,    makeFirefliesScene,    makeLightsScene,
                             makeFoliageScene, makeGalleryScene, makeGlassScene,        makeFogScene,
                             makeCrowdScene}; // in the order of builtinScenes()

Scene makeBuiltin(const std::string& source) {
  requireBuiltinScene(source);
  const BuiltinScene* const row = findBuiltinScene(source);
  Scene scene = kMakers.at(static_cast<std::size_t>(row - builtinScenes().data()))();
  scene.sky.shadows = row->shadows;
  return scene;
}

} // namespace

const std::vector<BuiltinScene>& builtinScenes() {
  static const std::vector<BuiltinScene> scenes{
      {"fan",
       "Fan",
       "A fan spins in its wire guard before bricks and small bright lights: ghosting, thin wires, HDR",
       {},
       SunShadows::Hard},
      {"fence",
       "Fence",
       "The camera passes pickets, wires and a net, far to near: sub-pixel detail and disocclusion",
       {},
       SunShadows::Hard},
      {"disocclusion", "Disocclusion",
       "Boards slide before a detailed wall and uncover it: ghosts, and pixels that have no history"},
      {"cut",
       "Cut",
       "The camera cuts every second, and a ball is teleported without a cut",
       {},
       SunShadows::Hard},
      {"thin", "Thin",
       "Lines one pixel and half a pixel wide at every slope, some nearly level, of known coverage"},
      {"text", "Text", "Fine print, checkers, a zone plate and a ticker: what the history filter blurs"},
      {"fireflies", "Fireflies",
       "Sparks smaller than a pixel, a thousand times as bright as white: tone weights and boxes"},
      {"lights", "Lights", "Lamps switch on and off: the history's geometry is right and its shading wrong"},
      {"foliage",
       "Foliage",
       "Grass and leaves sway in the vertex shader: motion of vertex animation, alpha masks",
       {},
       SunShadows::Hard},
      {"gallery",
       "Gallery",
       "One labelled object for each source of motion: camera, rigid, skin, morph, wind, cache",
       {},
       SunShadows::Soft},
      {"glass",
       "Glass",
       "Panes of glass, particles, a flip-book and a ticker: what no motion vector tells the history",
       {"inputs.blended=before", "inputs.mask=autoReactive", "weight.mask=reactive"}},
      {"fog", "Fog",
       "Two lamps in a hazy hall, their beams marched in few steps: banding, and noise that TAA averages"},
      {"crowd", "Crowd",
       "Six hundred things, a million triangles: small, thin and far ones that spin, walk and run"}};
  return scenes;
}

const BuiltinScene* findBuiltinScene(const std::string& source) {
  const auto found = std::ranges::find_if(builtinScenes(), [&](const BuiltinScene& scene) {
    return isBuiltinScene(source) && source.substr(kBuiltinPrefix.size()) == scene.id;
  });
  return found == builtinScenes().end() ? nullptr : &*found;
}

bool isBuiltinScene(const std::string& source) {
  return source.starts_with(kBuiltinPrefix);
}

void requireBuiltinScene(const std::string& source) {
  if (findBuiltinScene(source)) return;
  std::string known;
  for (const BuiltinScene& scene : builtinScenes())
    known += (known.empty() ? "" : ", ") + std::string(kBuiltinPrefix) + scene.id;
  throw Error(
      say<"there is no built-in scene \"%1\"; there are %2">(source.substr(kBuiltinPrefix.size()), known));
}

Scene openScene(const std::string& source, const Progress& progress, const ShotChoice& choice,
                const SceneBudget& budget) {
  Scene scene;
  if (isBuiltinScene(source)) {
    if (!choice.animation.empty())
      throw ChoiceError(say<"%1 has one animation; only of a file's can one be chosen">(source));
    report(progress, say<"Opening the scene">(), 0, 1);
    scene = makeBuiltin(source);
    report(progress, say<"Opening the scene">(), 1, 1);
  } else {
    scene = loadGltf(source, progress, choice.animation, budget);
    if (isModelAlone(scene)) {
      addGround(scene);
      scene.warnings.push_back(
          say<"The file has neither light nor camera: a sun and a ground are added (object \"%1\").">(
              kGroundName));
    }
  }
  if (choice.frames != 0) chooseLength(scene, choice.frames);
  return scene;
}

} // namespace taa
