// Decodes the PNG and JPEG pictures of a glTF file.
#pragma once

#include "core/scene/Scene.h"

#include <span>

namespace taa {

/// Throws Error with the reason when the bytes are neither PNG nor JPEG, too large a picture, or damaged.
SceneImage decodeImage(std::span<const unsigned char> bytes);

} // namespace taa
