// What the sun sees of a scene, or the first directional light of one without a sun. No GL.
#pragma once

#include "core/render/View.h"
#include "shaders/shared/ShadowBlock.h"

namespace taa {

inline constexpr int kShadowMapSize = 2048; ///< texels of a side

/// What Shadows::AsScene is in a scene that wants these.
Shadows shadowsOf(SunShadows wanted);

/// Those that the scene's sun casts: never Shadows::AsScene, and none without a sun.
Shadows shadowsOf(const Scene& scene, const InputSettings& settings);

/// Whether settings let anything of the scene cast shadows.
bool castsShadows(const Scene& scene, const InputSettings& settings);

/// Around what shadows are drawn of, and fall on.
const Bounds& shadowedBounds(const Scene& scene);

/// The sun's picture of the frame of `view`: orthographic, around shadowedBounds(). Expects castsShadows().
View sunView(const Scene& scene, const View& view);

/// What the shader of surfaces wants to know besides. `sun`: sunView() of the frame.
shared::ShadowBlock shadowBlock(const Scene& scene, const FrameRequest& request, int frame, const View& sun);

} // namespace taa
