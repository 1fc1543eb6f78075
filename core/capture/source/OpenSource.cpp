#include "core/capture/source/OpenSource.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/source/Capture.h"
#include "core/capture/source/CaptureSource.h"
#include "core/render/CaptureFacts.h"
#include "core/render/faults/FaultySource.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace taa {

namespace {

/// What a window and reports know of a capture where they would ask a scene: name, time and cuts, a node for
/// each of its objects that has a name, and as warnings what the import guessed and what is missing. There is
/// nothing to draw in it.
Scene sceneOf(const capture::Capture& opened) {
  const capture::Manifest& manifest = opened.manifest();
  Scene scene;
  scene.name = manifest.name.empty() ? capture::nameOf(opened.folder()) : manifest.name;
  scene.materials.emplace_back();
  scene.shot.frames = static_cast<int>(manifest.frames.size());
  scene.shot.framesPerSecond = manifest.framesPerSecond;
  scene.shot.camera = kCaptureCamera;
  for (std::size_t frame = 1; frame < manifest.frames.size(); ++frame)
    if (manifest.frames[frame].cut) scene.shot.cuts.push_back(static_cast<int>(frame));
  for (const auto& [id, object] : manifest.objects) {
    Node node;
    node.name = object;
    node.capturedId = id;
    scene.nodes.push_back(std::move(node));
  }
  scene.warnings = manifest.notes;
  for (std::string& sentence : capture::missingInputs(manifest))
    scene.warnings.push_back(std::move(sentence));
  return scene;
}

OpenedSource openCaptured(const std::string& source, const Progress& progress) {
  report(progress, say<"Opening the capture">(), 0, 1);
  const std::shared_ptr<const capture::Capture> opened = capture::openCapture(source, progress);
  report(progress, say<"Opening the capture">(), 1, 1);
  Scene scene = sceneOf(*opened);
  // Sizes of pictures are known when they are read; those of raw planes the manifest has stated already.
  for (const std::string& note : opened->frame(0)->notes)
    if (std::ranges::find(scene.warnings, note) == scene.warnings.end()) scene.warnings.push_back(note);
  return {std::make_shared<const Scene>(std::move(scene)),
          std::make_shared<FaultySource>(std::make_unique<capture::CaptureSource>(opened))};
}

} // namespace

OpenedSource openSource(const std::string& source, const Progress& progress, const ShotChoice& choice,
                        const SceneBudget& budget) {
  if (!isBuiltinScene(source) && capture::isCapture(source)) {
    if (choice != ShotChoice{})
      throw ChoiceError(say<"%1 is a captured sequence, whose animation and length are fixed">(source));
    return openCaptured(source, progress);
  }
  const auto scene = std::make_shared<const Scene>(openScene(source, progress, choice, budget));
  return {scene, std::make_shared<FaultySource>(std::make_unique<SceneRenderer>(scene, progress))};
}

} // namespace taa
