// Opens glTF 2.0 files. They come from anywhere: whatever is wrong with one becomes a sentence.
#pragma once

#include "core/base/Progress.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneCost.h"

#include <filesystem>
#include <string>

namespace taa {

/// `animation` is as chooseAnimation() takes it. Throws Error "cannot open FILE: PLACE: REASON", also when
/// the scene is beyond the budget, Cancelled when `progress` asks for it, and nothing else.
Scene loadGltf(const std::filesystem::path& file, const Progress& progress = {},
               const std::string& animation = {}, const SceneBudget& budget = {});

} // namespace taa
