// Where a shot's frames come from: the built-in renderer, or a capture of somebody's engine.
#pragma once

#include "core/base/Progress.h"
#include "core/render/DrawCounts.h"
#include "core/render/FrameInputs.h"

namespace taa {

struct FrameRequest;

/// Frame n is a pure function of the source, the request and n. Needs the current context for its whole life.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Fills `out` with frame `frame`; its textures are made anew only when size or format differ. Throws
  /// Error.
  virtual void draw(const FrameRequest& request, int frame, FrameInputs& out) = 0;
  /// Number, time, jitter and cut of a frame: all that can be known without drawing.
  virtual FrameInfo info(const FrameRequest& request, int frame) const = 0;
  /// Compiles or reads what draw() will need, so that it does not wait. Throws Error, Cancelled.
  virtual void warmUp(const FrameRequest& request, const Progress& progress) = 0;
  /// Of the last frame drawn; all 0 where nothing is.
  virtual const DrawCounts& counts() const = 0;
  /// Compiles the shaders again; on Error the old programs stay.
  virtual void reloadShaders() = 0;
};

} // namespace taa
