// The cones of fog of a frame and of those before it, as the shaders want them. No GL.
#pragma once

#include "core/render/View.h"
#include "shaders/shared/FogBlock.h"

namespace taa {

struct FrameRequest;

/// Whether settings leave anything to draw of a scene's fog.
bool drawsFog(const Scene& scene, const InputSettings& settings);

/// Everything about the fog of a frame: cones whose nodes are not drawn are left out. The march goes from
/// where the first cone may begin to where the last one ends, the same for all rays.
shared::FogBlock fogBlock(const Scene& scene, const FrameRequest& request, const View& view);

} // namespace taa
