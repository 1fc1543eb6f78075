// Inputs of a frame, drawn where somebody reads them: a pixel's past is a few pixels of many frames.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/taa/History.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec2.hpp>

#include <optional>

namespace taa {

class FrameSource;

/// One frame at a time. Needs the current context for its whole life.
class PartlyDrawn {
 public:
  PartlyDrawn() = default;
  PartlyDrawn(const PartlyDrawn&) = delete; // what it gave out refers to it
  PartlyDrawn& operator=(const PartlyDrawn&) = delete;

  /// Draws the frame around `pixel` of the picture; the rest when it is read. What was given out of another
  /// frame must not be read any more. `frames` and `previous`, the history it is resolved on or nothing, must
  /// stay as long as it is read.
  twin::Inputs open(FrameSource& frames, const FrameRequest& request, int frame, const History* previous,
                    const glm::ivec2& pixel);

 private:
  void require(const gl::Rect& part);
  void draw(const gl::Rect& part);

  FrameSource* frames_ = nullptr;
  FrameRequest request_;
  int frame_ = 0;
  FrameInputs inputs_;
  gl::Rect drawn_;
};

} // namespace taa
