// The scenes made by code, one source file each.
#pragma once

#include "core/scene/Scene.h"

namespace taa {

Scene makeFanScene();          ///< FanScene.cpp
Scene makeFenceScene();        ///< FenceScene.cpp
Scene makeDisocclusionScene(); ///< DisocclusionScene.cpp
Scene makeCutScene();          ///< CutScene.cpp
Scene makeThinScene();         ///< ThinScene.cpp
Scene makeTextScene();         ///< TextScene.cpp
Scene makeFirefliesScene();    ///< FirefliesScene.cpp
Scene makeLightsScene();       ///< LightsScene.cpp
Scene makeFoliageScene();      ///< FoliageScene.cpp
Scene makeGalleryScene();      ///< GalleryScene.cpp
Scene makeGlassScene();        ///< GlassScene.cpp
Scene makeFogScene();          ///< FogScene.cpp
Scene makeCrowdScene();        ///< CrowdScene.cpp

} // namespace taa
