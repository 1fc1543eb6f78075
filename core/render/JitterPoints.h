// The jitter patterns that are a list of points.
#pragma once

#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <span>

namespace taa {

/// Offsets in px within ±½, one a frame in this order; empty where the pattern is computed from an index.
std::span<const glm::vec2> pointsOf(JitterSequence sequence);

} // namespace taa
