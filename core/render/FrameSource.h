// Where a shot's frames come from: the built-in renderer, or a capture of somebody's engine.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/render/DrawCounts.h"
#include "core/render/FrameInputs.h"
#include "core/scene/Pose.h"

#include <memory>

namespace taa {

struct CaptureFacts;
struct FrameRequest;

/// Frame n is a pure function of the source, the request and n. Needs the current context for its whole life.
class FrameSource {
 public:
  FrameSource() = default;
  FrameSource(FrameSource&&) noexcept = default;
  FrameSource& operator=(FrameSource&&) noexcept = default;
  virtual ~FrameSource() = default;

  /// Fills `out` with frame `frame`; its textures are made anew only when size or format differ. Throws
  /// Error.
  virtual void draw(const FrameRequest& request, int frame, FrameInputs& out) = 0;
  /// Number, time, jitter and cut of a frame: all that can be known without drawing.
  virtual FrameInfo info(const FrameRequest& request, int frame) const = 0;
  /// What a frame is seen through. Throws Error when there is no camera of the request's name.
  virtual CameraState camera(const FrameRequest& request, int frame) const = 0;
  /// Compiles or reads what draw() will need, so that it does not wait. Throws Error, Cancelled.
  virtual void warmUp(const FrameRequest& request, const Progress& progress) = 0;
  /// Of the last frame drawn; all 0 where nothing is.
  virtual const DrawCounts& counts() const = 0;
  /// Compiles the shaders again; on Error the old programs stay.
  virtual void reloadShaders() = 0;

  // What a capture has and a scene has not
  /// Shared with who shows them in a window; null: the frames are drawn as settings ask.
  virtual std::shared_ptr<const CaptureFacts> capture() const { return nullptr; }
  /// The picture to compare a frame with, at least three channels, as large as the picture; null: it is
  /// drawn, sample by sample. Throws Error where it neither comes with the frames nor can be drawn.
  virtual std::shared_ptr<const Image> reference(int /*frame*/) { return nullptr; }
  /// What the engine's own TAA made of a frame, as reference(); null: there is none. Throws Error.
  virtual std::shared_ptr<const Image> engineOutput(int /*frame*/) { return nullptr; }
};

} // namespace taa
