// Draws a scene at a frame into FrameInputs: frame n is a pure function of scene, camera, settings, size and
// n.
#pragma once

#include "core/base/Progress.h"
#include "core/render/DrawCounts.h"
#include "core/render/FrameInputs.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/Scene.h"
#include "core/scene/camera/CameraTrack.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa {

/// What to draw besides the frame's number.
struct FrameRequest {
  std::string camera;             ///< a path of cameraNames()
  int width = 1280, height = 720; ///< of the picture; drawn at inputs.renderScale of it
  JitterSettings jitter;
  InputSettings inputs;
  std::vector<MotionOverride> motionModes = {}; ///< of objects by name; others keep their node's
  ObjectFilter filter = {};
  CameraTrackHandle track = nullptr;             ///< looked through instead of `camera`
  std::optional<glm::vec2> jitterPx = {};        ///< instead of what the sequence of `jitter` says
  std::vector<ClassOverride> objectClasses = {}; ///< of objects by name; others have what moves them
  std::vector<int> restarts = {}; ///< frames that use no history besides those where the shot is cut
  bool operator==(const FrameRequest&) const = default;
};

/// ⌈r·W⌉ × ⌈r·H⌉ of a picture of W × H: the size of what is drawn at inputs.renderScale r, px.
glm::ivec2 drawnSize(const glm::ivec2& picturePx, float renderScale);

/// Makes the textures that are drawn for a request, with undefined contents; keeps those that fit.
void fitInputs(const FrameRequest& request, FrameInputs& out);
/// What the textures of a frame's inputs take for a picture, and what the renderer keeps besides while it
/// draws them; bytes. `hasFog`: whether the scene has some.
std::size_t inputBytes(const InputSettings& settings, const glm::ivec2& picturePx, bool hasFog = false);
std::size_t scratchBytes(const InputSettings& settings, const glm::ivec2& picturePx, bool hasFog = false);

/// Owns the scene's GPU resources. Needs the current context for its whole life.
class SceneRenderer {
 public:
  /// Uploads everything. Throws Error (out of memory), Cancelled.
  explicit SceneRenderer(std::shared_ptr<const Scene> scene,
                         const Progress& progress = {}); // also owned by the Inspector
  ~SceneRenderer();
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) noexcept;

  /// Draws frame `frame` into `out`, whose textures are made anew only when size or format differ.
  /// Pose and camera of frame − 1 give the motion; at frame 0 and at cuts the previous frame is the frame
  /// itself.
  /// Throws Error when a shader does not compile.
  void draw(const FrameRequest& request, int frame, FrameInputs& out);

  /// Compiles what draw() will need for any frame, so that it does not wait; some drivers do that when
  /// something is first drawn, so all is drawn, small. Reports for each program; throws Error, Cancelled.
  void warmUp(const FrameRequest& request, const Progress& progress);

  /// Of the last frame drawn.
  const DrawCounts& counts() const;
  /// For tests: see GBufferPass.
  void setCulling(bool culls);

  /// Compiles the shaders again; on Error the old programs stay.
  void reloadShaders();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Number, time, jitter and cut of a frame: all that can be known without drawing.
FrameInfo frameInfo(const Scene& scene, const FrameRequest& request, int frame);

} // namespace taa
