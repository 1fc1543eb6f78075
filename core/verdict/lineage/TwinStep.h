// The step of a pixel's lineage as the CPU twin has it.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"
#include "core/verdict/lineage/PixelStep.h"

#include <glm/vec2.hpp>

namespace taa {

/// Of pixel `pixel` of the picture that the resolve makes of `inputs`. The rules:
/// α: of each channel after tone weighting, the row blendFactor; where colors are mixed compressed, the share
/// in that space. Rejected history has α = 1, history that is frozen α = 0.
/// Share that rectification replaced: the row clipAmount, how far history was moved on its way to the
/// target, in the space of the box, with strength, locks and protection in it. Of clips it is t; of a
/// per-channel clamp it is ‖h′ − h‖ / ‖center − h‖.
/// Filters: their weights; that a result was clamped to what it was made of (deringing) changes none.
/// Texels beyond the border are those at it, or have no part where the border is black.
/// Drawn smaller than the picture: the samples are those that the kernel weighs, or the nearest alone.
PixelStep pixelStep(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel);

} // namespace taa
