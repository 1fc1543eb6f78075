// The jitter pattern: a pure function of settings and frame index.
#pragma once

#include "core/settings/Settings.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace taa {

/// Radical inverse of `index` in `base`: exact digits, rounded once. 0 for index 0.
float radicalInverse(int index, int base);

/// Position in the pattern at `frame`, 0 to period − 1.
int jitterIndex(const JitterSettings& settings, int frame);

/// Displacement of image content in px (x right, y down), scaled: catalogue §2.2, Halton(2,3) − ½ (J9).
/// The catalogue's y is up; here y is down, and the sequence's second component is used as y down.
glm::vec2 jitterPx(const JitterSettings& settings, int frame);

/// T(2jx/W, −2jy/H) · clipFromView: the same displacement at every depth, perspective and orthographic
/// (§2.1).
glm::mat4 jittered(const glm::mat4& clipFromView, glm::vec2 jitterPx, glm::vec2 sizePx);

} // namespace taa
