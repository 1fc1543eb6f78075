// What the geometry of a scene says of a place of the picture, in the frame on show and in the one before: by
// ray casting in double precision, without any shader.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/scene/Pose.h"
#include "core/scene/Scene.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace taa::test {

/// The surface on a line of sight.
struct SeenPoint {
  int object = 0;           ///< number of the drawn object; 0: the sky
  double depth = 0.0;       ///< m along the view axis
  glm::dvec2 motionPx{0.0}; ///< since the frame before, jitter left out
  double depthBefore = 0.0; ///< m, that its point had in the frame before
};

/// Triangles only, and what textures cut out of them is there: ask for what neither hides.
class SurfaceOracle {
 public:
  /// Of the frame that was drawn into `inputs`.
  SurfaceOracle(const Scene& scene, const FrameInputs& inputs);

  /// At the sample that the pixel was drawn from.
  SeenPoint sampleOf(const glm::ivec2& pixel) const;
  /// At a place of the picture, px, of this frame or of the one before (whose points have no motion here).
  SeenPoint at(const glm::dvec2& positionPx, bool isBefore) const;

 private:
  struct Corner {
    glm::dvec4 clip{0.0};
    double depth = 0.0; ///< m
  };
  struct Triangle {
    std::array<std::array<Corner, 3>, 2> corners; ///< of this frame, of the one before
    std::array<glm::dvec4, 2> bounds; ///< least and largest x and y, normalized device coordinates
    int object = 0;
    bool isDoubleSided = false;
  };
  void add(const Scene& scene, const FrameInputs& inputs, const NodeInstance& at, const Primitive& primitive,
           int object);

  std::vector<Triangle> triangles_;
  glm::dvec2 sizePx_, jitterPx_;
};

} // namespace taa::test
