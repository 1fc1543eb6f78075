// What a window and reports know of a capture where they would ask a scene.
#pragma once

#include "core/capture/format/Manifest.h"
#include "core/scene/Scene.h"

#include <string>

namespace taa::capture {

/// Name, time and cuts of the capture, a node for each of its objects that has a name, and as warnings what
/// the import guessed and what is missing. There is nothing to draw in it. `name`: of one that states none.
Scene sceneOf(const Manifest& manifest, const std::string& name);

} // namespace taa::capture
