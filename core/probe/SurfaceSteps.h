// Where the surface that the center of a pixel shows was a frame ago, by the scene's exact geometry: what
// flicker is followed along. No GL.
#pragma once

#include "core/base/Image.h"
#include "core/gl/Texture.h"
#include "core/taa/twin/Texels.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <optional>
#include <vector>

namespace taa {

/// What the centers of pixels show, drawn without jitter and with the true motion of all objects. Pictures of
/// one size: all of the frame, or a part of it.
struct SeenSurfaces {
  Image objectId;          ///< 0: the sky
  Image depthView;         ///< m; 0: the sky
  Image motionPx;          ///< current − previous; see kNoPreviousPosition
  Image previousDepthView; ///< m, of the same surface a frame ago; 0: the sky or none
  glm::ivec2 corner{0};    ///< pixel of the frame that they begin with
  /// How much was blended over it, and whether its material changes without motion; 0 to 1. Empty: unknown.
  Image mask{};
};

/// Channels of what surfaceSteps() gives: the motion, px, the object that moves, and the sum of its
/// StepFlags.
inline constexpr int kStepChannels = 4;

enum class StepFlag : int {
  SeenBeside = 1,  ///< only beside its place: the center of the pixel that holds that showed something else
  BlendedOver = 2, ///< something is blended over it
  Changes = 4,     ///< its material changes without motion
};
inline bool hasFlag(float flags, StepFlag flag) {
  return (static_cast<int>(flags) & static_cast<int>(flag)) != 0;
}
/// What the mask says of a pixel of the frame.
float maskFlags(const SeenSurfaces& seen, int x, int y);

/// How the surface of each pixel came there from the frame before: its motion, NaN where it was not seen
/// then: off the picture, without a previous position, or behind something else. It was seen where one of the
/// 3×3 pixels around its place shows the same object, and its depth lies between the smallest and the largest
/// of those that do, give or take a hundredth. (3×3, because the center of a pixel may miss a thin line that
/// crosses it.)
Image surfaceSteps(const SeenSurfaces& now, const SeenSurfaces& before);
/// The same of a part of a frame of `sizePx`, which `now` holds; `before` holds formerPlaces() of it.
Image surfaceSteps(const SeenSurfaces& now, const SeenSurfaces& before, const gl::Rect& part,
                   const glm::ivec2& sizePx);
/// Pixels of the frame before that the steps of a part are looked for in; empty: none.
gl::Rect formerPlaces(const SeenSurfaces& now, const gl::Rect& part, const glm::ivec2& sizePx);

/// The steps of the 3×3 pixels around one, as far as the picture goes; that of the pixel itself is one of
/// them.
std::vector<glm::vec4> stepsAround(const twin::Texels& steps, const glm::ivec2& pixel);

/// The step at a place of the picture, px: of the pixel that holds it, or the nearest of the eight around it,
/// where that shows `object`. Nothing where none does or the surface was not seen before.
std::optional<glm::dvec2> stepAt(const Image& steps, const glm::dvec2& positionPx, float object);
std::optional<glm::dvec2> stepAt(const twin::Texels& steps, const glm::dvec2& positionPx, float object);

} // namespace taa
