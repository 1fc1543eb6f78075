// A small glTF file made by code, with something of everything, for tests that break it.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace taa::test {

struct GltfSample {
  nlohmann::json json;
  std::string buffer; ///< of buffers[0], which has no uri yet

  GltfSample();

  /// Appends bytes and a bufferView for them; returns its index.
  int addView(const void* data, std::size_t bytes);
  /// Appends floats and an accessor of `type` ("VEC3") for them; returns its index.
  int addFloats(const std::vector<float>& values, const std::string& type);

  /// Writes NAME.gltf with the buffer inside; returns the path.
  std::filesystem::path writeEmbedded(const std::string& name) const;
  std::filesystem::path writeBinary(const std::string& name) const;
};

/// The sample with one morph target that moves vertex 1 by (0, 0, 2), at weight ½, animated by `weights` at 0
/// s and 1 s.
GltfSample morphSample(const char* interpolation, const std::vector<float>& weights);

/// The bytes of a .glb around these.
std::string joinGlb(std::string json, std::string binary);

std::string base64(const std::string& bytes);

/// Writes bytes into the temporary folder; returns the path.
std::filesystem::path writeTemporary(const std::string& name, const std::string& bytes);

} // namespace taa::test
