// Sizes and channels of the planes of a frame: checked, and made those of the frame.
#pragma once

#include "core/base/Image.h"
#include "core/capture/planes/Planes.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace taa::capture {

/// Takes planes out of those that were read, in the shape that DecodedFrame has them in.
class PlaneShapes {
 public:
  /// `planes` are used up as they are taken.
  PlaneShapes(FramePlanes& planes, const glm::ivec2& sizePx, int frame);

  /// Empty where there is none; nearest values where its size is not the frame's. Throws Error.
  Image take(PlaneKind kind);
  /// As it is, whatever its size.
  Image takeUnscaled(PlaneKind kind);
  std::vector<std::uint32_t> takeIds();
  /// With classes of 0 where the fourth channel holds something else.
  Image takeNormals();
  /// Sentences about what did not fit.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  PlaneData* find(PlaneKind kind);
  void note(PlaneKind kind, const PlaneData& plane);

  FramePlanes& planes_;
  glm::ivec2 sizePx_;
  int frame_;
  std::vector<std::string> notes_;
};

} // namespace taa::capture
