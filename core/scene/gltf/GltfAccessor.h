// Reads accessors: strides, sparse values, normalized and quantized components.
#pragma once

#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace taa {

/// An accessor's elements one after another as floats; normalized integers are 0…1 or −1…1.
struct AccessorValues {
  int components = 0;
  std::vector<float> values;

  std::size_t count() const { return values.size() / static_cast<std::size_t>(components); }
  /// An element with missing components 0.
  glm::vec4 at(std::size_t element) const;
  /// Whether no value is NaN or infinite.
  bool isFinite() const;
};

/// Expects an accessor that checkGltfData let pass. Throws Error when its type is not one of 1 to 4, or 16,
/// components.
AccessorValues readAccessor(const tinygltf::Model& model, int accessor);

/// Unsigned integers: vertex indices. Throws Error when the accessor holds something else.
std::vector<std::uint32_t> readIndices(const tinygltf::Model& model, int accessor);

} // namespace taa
