#include "core/capture/source/CaptureScene.h"

#include "core/capture/decode/DecodedFrame.h"
#include "core/render/CaptureFacts.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace taa::capture {

Scene sceneOf(const Manifest& manifest, const std::string& name) {
  Scene scene;
  scene.name = manifest.name.empty() ? name : manifest.name;
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
  for (std::string& sentence : missingInputs(manifest)) scene.warnings.push_back(std::move(sentence));
  return scene;
}

} // namespace taa::capture
