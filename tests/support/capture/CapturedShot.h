// A built-in shot as a capture in this program's own conventions: decoded frames in memory, and files.
#pragma once

#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/format/Manifest.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/Scene.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace taa::test {

/// Draws when it is asked. Needs the current context for its whole life.
class CapturedShot {
 public:
  /// As lanes with `settings` see it through the scene's own camera.
  CapturedShot(const std::string& source, const glm::ivec2& sizePx, const Settings& settings, int frames);

  const FrameRequest& request() const { return request_; }
  SceneRenderer& renderer() { return renderer_; }
  /// Without planes: those of the frames are in memory.
  capture::Manifest manifest();
  /// What the renderer draws.
  std::shared_ptr<const capture::DecodedFrame> frame(int index);
  /// Writes all frames and capture.json. `hasOutput`: as the engine's output the color as it is.
  void write(const std::filesystem::path& folder, bool hasOutput = false);

 private:
  std::shared_ptr<const Scene> scene_; // also owned by the renderer
  SceneRenderer renderer_;
  FrameRequest request_;
  int frames_;
};

/// Writes the frames that `manifest` has as files of 32 bits a value, and capture.json.
void writeCapture(const std::filesystem::path& folder, capture::Manifest manifest,
                  const std::function<capture::DecodedFrame(int)>& frame);

} // namespace taa::test
