// The size of the picture that a program starts with.
#pragma once

#include "core/gl/Context.h"

#include <glm/vec2.hpp>

namespace taa {

/// Without a GPU 1280 × 720 plays at half the rate of 960 × 540.
inline glm::ivec2 firstSize(const gl::Driver& driver) {
  return driver.isSoftware ? glm::ivec2(960, 540) : glm::ivec2(1280, 720);
}

} // namespace taa
