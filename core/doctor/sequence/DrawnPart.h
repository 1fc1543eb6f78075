// How much of a picture was drawn: beyond it stands what the frame before has, to the last bit.
#pragma once

#include "core/base/Image.h"

#include <glm/vec2.hpp>

#include <optional>

namespace taa::doctor {

/// px; motion that is longer makes another picture. Luma between the pixels beside one: less is no detail.
inline constexpr float kMovesPx = 0.5f, kDetailLuma = 0.03f;

/// px from the upper left corner, where right and below of it all that has detail and moves is as in the
/// frame before. Nothing: the whole picture, as far as it moves.
std::optional<glm::ivec2> drawnPart(const Image& luma, const Image& motionPx, const Image& before);

} // namespace taa::doctor
