// The scenes made by code, one source file each.
#pragma once

#include "core/scene/Scene.h"

namespace taa {

Scene makeFanScene();   ///< FanScene.cpp
Scene makeFenceScene(); ///< FenceScene.cpp

} // namespace taa
