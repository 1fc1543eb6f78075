#include "core/scene/gltf/GltfLoader.h"

#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/Geometry.h"
#include "core/scene/gltf/GltfAnimation.h"
#include "core/scene/gltf/GltfContext.h"
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

/// Whole runs of the first animation, four seconds or a little more; without one, a turn of the orbit.
Shot shotOf(const Scene& scene) {
  constexpr double kSeconds = 4.0;
  constexpr int kStillFrames = 480, kMaxFrames = 1200;
  Shot shot;
  shot.frames = kStillFrames;
  if (scene.animations.empty() || !(scene.animations.front().duration > 0.0f)) return shot;
  const double duration = scene.animations.front().duration;
  const double frames = std::ceil(kSeconds / duration) * duration * shot.framesPerSecond;
  shot.frames = static_cast<int>(std::clamp(std::round(frames), 1.0, double(kMaxFrames)));
  return shot;
}

Scene build(const std::filesystem::path& file, const Progress& progress) {
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
  addGltfMaterials(context, progress);
  report(progress, say<"Building meshes">(), 0, 1);
  addGltfNodes(context);
  keepStrongestLights(context);
  checkRestTransforms(context);
  addGltfMeshes(context);
  addGltfAnimations(context);
  setBounds(scene);
  scene.shot = shotOf(scene);
  scene.sky.sunEnabled = scene.lights.empty();
  report(progress, say<"Building meshes">(), 1, 1);
  return scene;
}

} // namespace

Scene loadGltf(const std::filesystem::path& file, const Progress& progress) {
  try {
    return build(file, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(say<"cannot open %1: memory: it needs more than there is">(file.string()));
  } catch (
      const std::exception& exception) { // our own Error, and whatever a library or the file system throws
    throw Error(say<"cannot open %1: %2">(file.string(), shownReason(exception)));
  }
}

} // namespace taa
