// Which samples a pixel is made of (core/verdict/lineage/Lineage.h), of the frame on show and of others.
#pragma once

#include "core/base/Progress.h"
#include "core/verdict/lineage/Lineage.h"

#include <glm/vec2.hpp>

namespace taa {

class ShotPlayer;

class LineageOfShot {
 public:
  explicit LineageOfShot(ShotPlayer& player);

  /// Of a pixel of any frame, exactly; what is on show stays. The inputs of each frame are drawn once more,
  /// and its history is replayed where it is not kept. Throws Error where there is no such pixel or frame;
  /// Cancelled.
  Lineage of(int frame, const glm::ivec2& pixel, int lane = 0, const LineageOptions& options = {},
             const Progress& progress = {});

 private:
  ShotPlayer& player_;
};

} // namespace taa
