// Inputs of a frame, drawn where somebody reads them: a pixel's past is a few pixels of many frames.
#pragma once

#include "core/base/Image.h"
#include "core/gl/Texture.h"
#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/taa/History.h"
#include "core/taa/twin/Twin.h"

#include <map>
#include <vector>

namespace taa {

class FrameSource;

/// One frame at a time. Needs the current context for its whole life.
class PartlyDrawn {
 public:
  PartlyDrawn() = default;
  PartlyDrawn(const PartlyDrawn&) = delete; // what it gave out refers to it
  PartlyDrawn& operator=(const PartlyDrawn&) = delete;

  /// Draws what most pixels of some parts of the picture read; the rest when it is read. What was given out
  /// of another frame must not be read any more. `frames` and `previous`, the history it is resolved on or
  /// nothing, must stay as long as it is read.
  twin::Inputs open(FrameSource& frames, const FrameRequest& request, int frame, const History* previous,
                    const std::vector<gl::Rect>& parts);

 private:
  /// What was drawn at once, of all textures.
  struct DrawnPart {
    gl::Rect place;
    std::map<const gl::Texture*, Image> images{};
  };

  Image read(const gl::Texture& texture, const gl::Rect& part);
  /// Texels of what is drawn.
  const DrawnPart& draw(const gl::Rect& place);

  FrameSource* frames_ = nullptr;
  FrameRequest request_;
  int frame_ = 0;
  FrameInputs inputs_;
  std::vector<DrawnPart> parts_; // none of a capture
};

} // namespace taa
