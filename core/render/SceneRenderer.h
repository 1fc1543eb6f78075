// Draws a scene at a frame into FrameInputs: frame n is a pure function of scene, camera, settings, size and
// n.
#pragma once

#include "core/base/Progress.h"
#include "core/render/DrawCounts.h"
#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/render/FrameSource.h"
#include "core/scene/Scene.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <memory>

namespace taa {

/// ⌈r·W⌉ × ⌈r·H⌉ of a picture of W × H: the size of what is drawn at inputs.renderScale r, px.
glm::ivec2 drawnSize(const glm::ivec2& picturePx, float renderScale);

/// Makes the textures that are drawn for a request, with undefined contents; keeps those that fit.
void fitInputs(const FrameRequest& request, FrameInputs& out);
/// As above, for inputs of a size that no setting says.
void fitInputs(const InputSettings& settings, const glm::ivec2& drawnPx, const glm::ivec2& picturePx,
               FrameInputs& out);
/// Makes a texture anew unless it has this size and format; its contents are undefined then.
void fitTexture(gl::Texture& texture, const glm::ivec2& sizePx, gl::Format format, const char* label);
/// What the textures of a frame's inputs take for a picture, and what the renderer keeps besides while it
/// draws them; bytes. Without a scene: of one with neither fog nor shadows.
std::size_t inputBytes(const InputSettings& settings, const glm::ivec2& picturePx,
                       const Scene* scene = nullptr);
std::size_t scratchBytes(const InputSettings& settings, const glm::ivec2& picturePx,
                         const Scene* scene = nullptr);

/// Owns the scene's GPU resources. Needs the current context for its whole life.
class SceneRenderer : public FrameSource {
 public:
  /// Uploads everything. Throws Error (out of memory), Cancelled.
  explicit SceneRenderer(std::shared_ptr<const Scene> scene,
                         const Progress& progress = {}); // also owned by the Inspector
  ~SceneRenderer() override;
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) noexcept;

  /// Pose and camera of frame − 1 give the motion; at frame 0 and at cuts the previous frame is the frame
  /// itself. Throws Error when a shader does not compile.
  void draw(const FrameRequest& request, int frame, FrameInputs& out) override;
  FrameInfo info(const FrameRequest& request, int frame) const override;
  CameraState camera(const FrameRequest& request, int frame) const override;

  /// Some drivers compile when something is first drawn, so all is drawn, small. Reports for each program.
  void warmUp(const FrameRequest& request, const Progress& progress) override;
  const DrawCounts& counts() const override;
  void reloadShaders() override;

  /// For tests: see GBufferPass.
  void setCulling(bool culls);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Number, time, jitter and cut of a frame: all that can be known without drawing.
FrameInfo frameInfo(const Scene& scene, const FrameRequest& request, int frame);

} // namespace taa
