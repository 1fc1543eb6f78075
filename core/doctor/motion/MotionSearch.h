// What a small part of the picture moves by, found by trying.
#pragma once

#include "core/base/Image.h"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace taa::doctor {

/// A pixel that is looked for in the frame before.
struct SearchedPixel {
  glm::vec2 place{0.0f}; ///< in the frame before, px from its corner, if nothing moves
  float luma = 0.0f;     ///< of now
};

/// The motion, px, under which pixels differ least from what they were in `previousLuma`, in the mean of
/// |difference|: whole pixels up to `reachPx` around `aroundPx`, then between them to an eighth of one.
/// Nothing where there are too few pixels or one of them would lie outside of the picture wherever it is
/// looked for.
std::optional<glm::vec2> searchMotion(const std::vector<SearchedPixel>& pixels, const Image& previousLuma,
                                      const glm::vec2& aroundPx, int reachPx);

} // namespace taa::doctor
