// What the centers of pixels show, drawn from the source of a shot's frames.
#pragma once

#include "core/probe/SurfaceSteps.h"
#include "core/render/FrameRequest.h"
#include "core/render/FrameSource.h"

#include <optional>
#include <utility>

namespace taa {

/// What the centers of a frame's pixels show, as drawSteps() draws it. Throws Error.
SeenSurfaces drawSurfaces(FrameSource& frames, const FrameRequest& ofLane, int frame);

/// A frame and what was seen in it.
using DrawnSurfaces = std::optional<std::pair<int, SeenSurfaces>>;

/// surfaceSteps() to a frame from the one before, of what `ofLane` draws: as for the reference, but through
/// the centers of the pixels. A capture shows the samples it was taken with instead. `last`: what was drawn
/// last for steps, which is used again. Throws Error.
Image drawSteps(FrameSource& frames, const FrameRequest& ofLane, int frame, DrawnSurfaces& last);

} // namespace taa
