#include "core/capture/source/OpenSource.h"

#include "core/base/Say.h"
#include "core/capture/source/Capture.h"
#include "core/capture/source/CaptureScene.h"
#include "core/capture/source/CaptureSource.h"
#include "core/render/SceneRenderer.h"
#include "core/scene/SceneSource.h"

#include <filesystem>

namespace taa {

namespace {

OpenedSource openCaptured(const std::string& source, const Progress& progress) {
  report(progress, say<"Opening the capture">(), 0, 1);
  const std::shared_ptr<const capture::Capture> opened = capture::openCapture(source, progress);
  report(progress, say<"Opening the capture">(), 1, 1);
  const std::string folder =
      std::filesystem::absolute(opened->folder()).lexically_normal().filename().string();
  return {std::make_shared<const Scene>(capture::sceneOf(opened->manifest(), folder)),
          std::make_shared<capture::CaptureSource>(opened)};
}

} // namespace

OpenedSource openSource(const std::string& source, const Progress& progress) {
  if (!isBuiltinScene(source) && capture::isCapture(source)) return openCaptured(source, progress);
  const auto scene = std::make_shared<const Scene>(openScene(source, progress));
  return {scene, std::make_shared<SceneRenderer>(scene, progress)};
}

} // namespace taa
