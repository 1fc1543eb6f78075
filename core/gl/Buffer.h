// GL buffers and meshes, owned by value.
#pragma once

#include "core/gl/Handle.h"
#include "core/gl/Memory.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace taa::gl {

/// A buffer of fixed size; what it is used as (vertices, uniforms, storage) is said where it is bound.
class Buffer {
 public:
  Buffer() = default;
  /// Filled with `data`, or with update() later when that is null. Throws Error when the driver has not the
  /// memory.
  Buffer(std::size_t bytes, const void* data, const std::string& label);
  void update(std::size_t offset, const void* data, std::size_t bytes);
  std::vector<std::byte> download() const;
  unsigned id() const { return id_; }
  std::size_t bytes() const { return bytes_; }

 private:
  Handle<ObjectKind::Buffer> id_;
  ResetOnMove<std::size_t> bytes_;
  Allocation allocation_;
};

/// One attribute, made of floats, of an interleaved vertex.
struct VertexAttribute {
  unsigned location = 0;
  int components = 3;
  std::size_t offset = 0; ///< bytes from the start of a vertex
};

enum class PrimitiveKind : std::uint8_t { Triangles, Lines, Points };

/// Vertices and 32-bit indices on the GPU, with their layout.
class VertexMesh {
 public:
  VertexMesh() = default;
  VertexMesh(std::span<const std::byte> vertices, std::size_t stride,
             std::span<const VertexAttribute> attributes, std::span<const std::uint32_t> indices,
             PrimitiveKind kind, const std::string& label);
  unsigned vertexArray() const { return vertexArray_; }
  const Buffer& indices() const { return indices_; }
  int indexCount() const { return indexCount_; }
  PrimitiveKind kind() const { return kind_; }
  std::size_t bytes() const { return vertices_.bytes() + indices_.bytes(); }

 private:
  Handle<ObjectKind::VertexArray> vertexArray_;
  Buffer vertices_, indices_;
  ResetOnMove<int> indexCount_;
  PrimitiveKind kind_ = PrimitiveKind::Triangles;
};

} // namespace taa::gl
