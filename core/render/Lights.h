// The scene's punctual lights as the shaders take them.
#pragma once

#include "core/scene/Pose.h"
#include "shaders/shared/LightBlock.h"

namespace taa {

/// How many lights of each kind the shaders are specialised for: fixed for a scene.
struct LightCounts {
  int directional = 0; ///< the sun among them
  int near = 0;        ///< point and spot lights
};

/// At most kMaxLights in all; those beyond are left out, the last first.
LightCounts lightCounts(const Scene& scene);

/// The lights where `pose` puts them. A light without a direction (scaled to nothing) is there, but dark.
shared::LightBlock lightBlock(const Scene& scene, const Pose& pose);

} // namespace taa
