// A .gltf file: JSON with its buffers inside.
#include "tests/fuzz/OpenGltf.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  taa::fuzz::openGltf("scene.gltf", bytes, count);
  return 0;
}
