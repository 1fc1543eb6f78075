// Opens bytes as a glTF file and asks the scene what those ask who draw it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace taa::fuzz {

/// NAME is a file's name, with its ending.
void openGltf(const char* name, const std::uint8_t* bytes, std::size_t count);

} // namespace taa::fuzz
