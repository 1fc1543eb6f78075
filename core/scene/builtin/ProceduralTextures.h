// Pictures painted by code for the built-in scenes. All tile unless it says otherwise.
#pragma once

#include "core/scene/Scene.h"

namespace taa {

/// Color and, to match it, the normal map of the same surface.
struct SurfaceImages {
  SceneImage color;  ///< sRGB
  SceneImage normal; ///< tangent space, +y up in the picture
};

SurfaceImages brickImages();
SurfaceImages plankImages();
SceneImage tileImage(); ///< two-colored floor tiles with thin joints
SceneImage slabImage(); ///< one-colored slabs with thin joints
SceneImage grassImage();
SceneImage gravelImage();
constexpr float kPosterAspect = 4.0f / 3.0f; ///< height over width
SceneImage posterImage();                    ///< a test chart of lines finer than a pixel; does not tile
SceneImage netImage();                       ///< chain link, alpha 0 between the wires

} // namespace taa
