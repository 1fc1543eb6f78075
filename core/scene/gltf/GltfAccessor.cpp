#include "core/scene/gltf/GltfAccessor.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

namespace taa {

namespace {

/// Where elements lie in a buffer.
struct ByteRange {
  const unsigned char* data;
  std::size_t stride;
};

ByteRange spanOf(const tinygltf::Model& model, int view, std::size_t offset, std::size_t elementBytes) {
  const tinygltf::BufferView& source = model.bufferViews.at(static_cast<std::size_t>(view));
  const tinygltf::Buffer& buffer = model.buffers.at(static_cast<std::size_t>(source.buffer));
  return {buffer.data.data() + source.byteOffset + offset,
          source.byteStride != 0 ? source.byteStride : elementBytes};
}

template <class T>
T load(const unsigned char* from) {
  T value;
  std::memcpy(&value, from, sizeof value); // accessors of hostile files need not be aligned
  return value;
}

float component(const unsigned char* from, int type, bool normalized) {
  const auto scaled = [&](float value, float max) {
    return normalized ? std::max(value / max, -1.0f) : value;
  };
  switch (type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
    return scaled(load<std::int8_t>(from), 127.0f);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return scaled(load<std::uint8_t>(from), 255.0f);
  case TINYGLTF_COMPONENT_TYPE_SHORT:
    return scaled(load<std::int16_t>(from), 32767.0f);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return scaled(load<std::uint16_t>(from), 65535.0f);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    return static_cast<float>(load<std::uint32_t>(from));
  case TINYGLTF_COMPONENT_TYPE_FLOAT:
    return load<float>(from);
  default:
    throw Error(say<"component type %1 cannot be read">(type));
  }
}

std::uint32_t unsignedComponent(const unsigned char* from, int type) {
  switch (type) {
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return load<std::uint8_t>(from);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return load<std::uint16_t>(from);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    return load<std::uint32_t>(from);
  default:
    throw Error(say<"indices must be unsigned integers">());
  }
}

std::size_t bytesOf(int componentType) {
  return static_cast<std::size_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(componentType)));
}

/// Writes elements over `values`: element `target(i)` from the `i`-th of the span.
template <class T, class Target, class Read>
void copyElements(std::vector<T>& values, std::size_t components, std::size_t count, const ByteRange& span,
                  std::size_t componentBytes, Target target, Read read) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t element = target(i);
    for (std::size_t c = 0; c < components; ++c)
      values[element * components + c] = read(span.data + i * span.stride + c * componentBytes);
  }
}

/// All components of an accessor through `read`, its sparse values put over the others.
template <class T, class Read>
std::vector<T> readElements(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                            std::size_t components, Read read) {
  const std::size_t size = bytesOf(accessor.componentType);
  std::vector<T> values(accessor.count * components, T(0));
  if (accessor.bufferView >= 0)
    copyElements(
        values, components, accessor.count,
        spanOf(model, accessor.bufferView, accessor.byteOffset, size * components), size,
        [](std::size_t i) { return i; }, read);
  if (!accessor.sparse.isSparse) return values;
  const auto& indices = accessor.sparse.indices;
  const ByteRange where = spanOf(model, indices.bufferView, static_cast<std::size_t>(indices.byteOffset),
                                 bytesOf(indices.componentType));
  const auto target = [&](std::size_t i) -> std::size_t {
    const std::uint32_t element = unsignedComponent(where.data + i * where.stride, indices.componentType);
    if (element >= accessor.count)
      throw Error(say<"sparse index %1 is out of range; there are %2 elements">(element, accessor.count));
    return element;
  };
  copyElements(values, components, static_cast<std::size_t>(accessor.sparse.count),
               spanOf(model, accessor.sparse.values.bufferView,
                      static_cast<std::size_t>(accessor.sparse.values.byteOffset), size * components),
               size, target, read);
  return values;
}

/// Calls `read` and puts the accessor's place before what it complains about.
template <class Read>
auto atAccessor(int accessor, Read read) {
  try {
    return read();
  } catch (const Error& error) {
    throw Error("accessors[" + std::to_string(accessor) + "]: " + error.what());
  }
}

} // namespace

glm::vec4 AccessorValues::at(std::size_t element) const {
  assert(components <= 4);
  glm::vec4 value(0.0f);
  for (int c = 0; c < components; ++c)
    value[c] = values[element * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)];
  return value;
}

bool AccessorValues::isFinite() const {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

AccessorValues readAccessor(const tinygltf::Model& model, int accessor) {
  return atAccessor(accessor, [&] {
    const tinygltf::Accessor& source = model.accessors.at(static_cast<std::size_t>(accessor));
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source.type));
    if (source.type == TINYGLTF_TYPE_MAT2 || source.type == TINYGLTF_TYPE_MAT3 || components < 1)
      throw Error(say<"its type cannot be used here">());
    return AccessorValues{components, readElements<float>(model, source, static_cast<std::size_t>(components),
                                                          [&](const unsigned char* from) {
                                                            return component(from, source.componentType,
                                                                             source.normalized);
                                                          })};
  });
}

std::vector<std::uint32_t> readIndices(const tinygltf::Model& model, int accessor) {
  return atAccessor(accessor, [&] {
    const tinygltf::Accessor& source = model.accessors.at(static_cast<std::size_t>(accessor));
    if (source.type != TINYGLTF_TYPE_SCALAR) throw Error(say<"indices must be scalars">());
    return readElements<std::uint32_t>(model, source, 1, [&](const unsigned char* from) {
      return unsignedComponent(from, source.componentType);
    });
  });
}

} // namespace taa
