// Draws a scene at a frame into FrameInputs: frame n is a pure function of scene, camera, settings, size and
// n.
#pragma once

#include "core/base/Image.h"
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

/// What the renderer keeps besides a frame's inputs while it draws them, bytes. Without a scene: of one with
/// neither fog nor shadows.
std::size_t scratchBytes(const InputSettings& settings, const glm::ivec2& picturePx,
                         const Scene* scene = nullptr);

/// How many pixels of the last frame land in each pixel: what forward reprojection would have to fill (manual
/// §5, source 004). `motionPx`: of the last frame, by what each has moved on since, negated; see
/// kNoPreviousPosition. Pixels that leave the picture land nowhere.
Image forwardCount(const Image& motionPx);

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

} // namespace taa
