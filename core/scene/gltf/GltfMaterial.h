// Materials of a glTF file, with the images they use.
#pragma once

#include "core/base/Progress.h"

namespace taa {

struct GltfContext;

/// Fills Scene::materials in the file's order, one default material more at the end, and Scene::images with
/// those used.
void addGltfMaterials(GltfContext& context, const Progress& progress);

} // namespace taa
