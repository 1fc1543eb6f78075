// Whether depth was drawn with the jitter of its frame, as color is, or without.
#pragma once

#include "core/capture/import/FrameSamples.h"
#include "core/capture/import/Guess.h"

#include <optional>

namespace taa::capture {

/// By the depth of the frame before, read where a resting surface had its place: that place is off by the
/// frames' jitter under the wrong answer, which steep surfaces show. Nothing where the capture has not depth,
/// matrices and jitter. Adopts what is sure, unless fixed.
std::optional<Finding> askDepthJitter(FrameSamples& samples, TestState& state, bool isFixed);

} // namespace taa::capture
