#include "core/scene/gltf/GltfLoader.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/Geometry.h"
#include "core/scene/Pose.h"
#include "core/scene/ShotChoice.h"
#include "core/scene/gltf/GltfAnimation.h"
#include "core/scene/gltf/GltfContext.h"
#include "core/scene/gltf/GltfCost.h"
#include "core/scene/gltf/GltfDocument.h"
#include "core/scene/gltf/GltfImport.h"
#include "core/scene/gltf/GltfMaterial.h"
#include "core/scene/gltf/GltfMesh.h"
#include "core/scene/gltf/GltfNodes.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace taa {

namespace {

void warnOfExtensions(GltfContext& context) {
  for (const std::string& extension : context.model.extensionsUsed)
    if (!isKnownGltfExtension(extension))
      context.warn(say<"The file uses %1, which is not shown.">(shownText(extension)));
}

void setBounds(Scene& scene) {
  constexpr float kFarthest = 1e15f; // farther out, products of coordinates leave the range of a float
  const Bounds bounds = restBounds(scene);
  if (bounds.isEmpty()) {
    scene.warnings.push_back(say<"The file has nothing to draw.">());
    return;
  }
  for (int axis = 0; axis < 3; ++axis) // written so that NaN fails too
    if (!(bounds.min[axis] >= -kFarthest && bounds.max[axis] <= kFarthest))
      throw Error(say<"bounds: the scene reaches to infinity">());
  scene.bounds = bounds;
}

/// Whole runs of the longest animation, four seconds or a little more; without one, a turn of the orbit.
Shot shotOf(const Scene& scene) {
  constexpr double kSeconds = 4.0;
  constexpr int kStillFrames = 480, kMaxFrames = 1200;
  double duration = 0.0;
  for (const Animation& animation : scene.animations)
    duration = std::max(duration, double(animation.duration));
  Shot shot;
  if (scene.cameras.size() == 1) shot.camera = cameraNames(scene).back(); // its author's own view
  shot.frames = kStillFrames;
  if (!(duration > 0.0)) return shot;
  const double frames = std::ceil(kSeconds / duration) * duration * shot.framesPerSecond;
  shot.frames = static_cast<int>(std::clamp(std::round(frames), 1.0, double(kMaxFrames)));
  return shot;
}

/// Says so where nobody has chosen among several.
void chooseAmong(GltfContext& context, const std::string& animation) {
  chooseAnimation(context.scene, animation);
  const std::vector<std::string>& names = context.scene.animationNames;
  if (animation.empty() && names.size() > 1)
    context.warn(
        say<"The file has %1 animations; the first, \"%2\", plays.">(names.size(), shownText(names.front())));
}

Scene build(const std::filesystem::path& file, const Progress& progress, const std::string& animation,
            const SceneBudget& budget) {
  report(progress, say<"Reading the file">(), 0, 1);
  GltfDocument document = readGltfDocument(file);
  checkGltfTypes(document.json);
  checkGltfData(document);
  checkGltfGraph(document.json);
  stripGltf(document.json);
  tinygltf::Model model;
  importGltf(document, model);
  Scene scene;
  scene.name = file.filename().string();
  GltfContext context{model, scene, document.imageFaults};
  for (const std::string& note : document.notes) context.warn(note);
  warnOfExtensions(context);
  addGltfNodes(context);
  checkGltfCost(context, budget); // before anything that it would take long to read
  addGltfMaterials(context, progress);
  report(progress, say<"Building meshes">(), 0, 1);
  keepStrongestLights(context);
  checkRestTransforms(context);
  addGltfMeshes(context);
  addGltfAnimations(context);
  chooseAmong(context, animation);
  setBounds(scene);
  scene.shot = shotOf(scene);
  scene.sky.sunEnabled = scene.lights.empty();
  const SceneCost cost = costOf(scene);
  if (const std::string refusal = costRefusal(cost, budget); !refusal.empty())
    throw BudgetError("images: " + refusal, budgetFor(cost, budget)); // without them it was within the budget
  report(progress, say<"Building meshes">(), 1, 1);
  return scene;
}

} // namespace

Scene loadGltf(const std::filesystem::path& file, const Progress& progress, const std::string& animation,
               const SceneBudget& budget) {
  try {
    return build(file, progress, animation, budget);
  } catch (const Cancelled&) {
    throw;
  } catch (const BudgetError& error) {
    throw BudgetError(say<"cannot open %1: %2">(file.string(), shownReason(error)), error.needed());
  } catch (const ChoiceError& error) {
    throw ChoiceError(say<"cannot open %1: %2">(file.string(), shownReason(error)));
  } catch (const std::bad_alloc&) {
    throw Error(say<"cannot open %1: memory: it needs more than there is">(file.string()));
  } catch (
      const std::exception& exception) { // our own Error, and whatever a library or the file system throws
    throw Error(say<"cannot open %1: %2">(file.string(), shownReason(exception)));
  }
}

} // namespace taa
