// What a verdict on a pixel is made from: its lineage, what its surface really did, and the truth. No GL.
#pragma once

#include "core/base/Image.h"
#include "core/gl/Rect.h"
#include "core/taa/twin/Texels.h"
#include "core/taa/twin/Twin.h"
#include "core/verdict/lineage/Lineage.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <optional>
#include <vector>

namespace taa {

/// The surface that a pixel shows, in one frame.
struct SurfaceMoment {
  int frame = 0;
  glm::ivec2 pixel{0};
  glm::dvec2 place{0.5}; ///< px, of the surface, in that pixel
  twin::PixelRecord record{};
  glm::dvec3 resolved{0.0}, reference{0.0}; ///< scene-linear
  /// Of truth at the place between pixels where the surface was then, by its four texels, what is nearest to
  /// today's; nothing: not known.
  std::optional<glm::dvec3> former{};
  std::optional<glm::dvec2> motion{}; ///< px, true one to here from the frame before; nothing: not seen then
  bool isUncovered =
      false;           ///< by the scene's geometry: within a pixel of it something has just come into sight
  bool isJump = false; ///< it came there by more than kJumpShare of the picture's width, as at a cut
};

/// Of the picture's width. A surface that moves further in one frame crosses the picture in eight: nobody can
/// follow it, and nothing comes and goes on it.
inline constexpr double kJumpShare = 0.125;

/// All of one lane. Frames may be asked for in any order; those that lie in the window are kept.
class EvidenceSource : public LineageSource {
 public:
  /// Every intermediate of the pixel but those of the reference.
  virtual twin::PixelRecord record(int frame, const glm::ivec2& pixel) = 0;
  /// Three channels, scene-linear, of the picture's size. Valid as long as the source.
  virtual const twin::Texels& reference(int frame) = 0;
  /// What surfaces really did, and the objects that pixels show: surfaceSteps(); NaN motion everywhere in a
  /// frame that starts history. Valid as long as the source.
  virtual const twin::Texels& steps(int frame) = 0;
  /// The object that the pixel shows, or the nearest to it in the picture: of steps(), for less.
  virtual int object(int frame, const glm::ivec2& pixel) {
    return static_cast<int>(steps(frame).nearestTexel(pixel.x, pixel.y).z);
  }
  /// Says what of all that will be read of a frame, so that it can be drawn together. Not all of it need lie
  /// in the picture.
  virtual void expect(int /*frame*/, const std::vector<gl::Rect>& /*parts*/) {}
};

/// A value of a three-channel picture; pixels beyond the border are those at it.
inline glm::dvec3 pixelColorAt(const Image& image, const glm::ivec2& pixel) {
  const float* value = image.nearest(pixel.x, pixel.y);
  return {value[0], value[1], value[2]};
}
inline glm::dvec3 pixelColorAt(const twin::Texels& texels, const glm::ivec2& pixel) {
  return glm::vec3(texels.nearestTexel(pixel.x, pixel.y));
}

} // namespace taa
