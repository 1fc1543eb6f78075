#include "core/capture/source/OpenSource.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/source/Capture.h"
#include "core/capture/source/CaptureScene.h"
#include "core/capture/source/CaptureSource.h"
#include "core/render/faults/FaultySource.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace taa {

namespace {

OpenedSource openCaptured(const std::string& source, const Progress& progress) {
  report(progress, say<"Opening the capture">(), 0, 1);
  const std::shared_ptr<const capture::Capture> opened = capture::openCapture(source, progress);
  report(progress, say<"Opening the capture">(), 1, 1);
  Scene scene = capture::sceneOf(opened->manifest(), capture::nameOf(opened->folder()));
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
