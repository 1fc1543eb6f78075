// A source by its name, whatever kind it is: a built-in scene, a glTF file or a captured sequence.
#pragma once

#include "core/base/Progress.h"
#include "core/render/FrameSource.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneCost.h"
#include "core/scene/ShotChoice.h"

#include <memory>
#include <string>

namespace taa {

struct OpenedSource {
  std::shared_ptr<const Scene> scene; // also owned by the source of its frames
  std::shared_ptr<FrameSource> frames;
};

/// "builtin:NAME", a .gltf or .glb file, the folder of a capture or its capture.json. Needs the current
/// context. Throws Error with file, place and reason when that is not possible, also of a scene that is
/// beyond the budget; Cancelled.
OpenedSource openSource(const std::string& source, const Progress& progress = {},
                        const ShotChoice& choice = {}, const SceneBudget& budget = {});

} // namespace taa
