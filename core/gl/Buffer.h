// GL buffers and meshes, owned by value.
#pragma once

#include "core/gl/Memory.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace taa::gl {

/// A buffer of fixed size; what it is used as (vertices, uniforms, storage) is said where it is bound.
class Buffer {
 public:
  Buffer() = default;
  /// Filled with `data`, or with update() later when that is null. Throws Error when the driver has not the
  /// memory.
  Buffer(std::size_t bytes, const void* data, const std::string& label);
  ~Buffer();
  Buffer(Buffer&& other) noexcept
      : id_(std::exchange(other.id_, 0)), bytes_(std::exchange(other.bytes_, 0)),
        allocation_(std::move(other.allocation_)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(bytes_, other.bytes_);
    std::swap(allocation_, other.allocation_);
    return *this;
  }
  void update(std::size_t offset, const void* data, std::size_t bytes);
  std::vector<std::byte> download() const;
  unsigned id() const { return id_; }
  std::size_t bytes() const { return bytes_; }

 private:
  unsigned id_ = 0;
  std::size_t bytes_ = 0;
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
class Mesh {
 public:
  Mesh() = default;
  Mesh(std::span<const std::byte> vertices, std::size_t stride, std::span<const VertexAttribute> attributes,
       std::span<const std::uint32_t> indices, PrimitiveKind kind, const std::string& label);
  ~Mesh();
  Mesh(Mesh&& other) noexcept { swap(other); }
  Mesh& operator=(Mesh&& other) noexcept {
    Mesh(std::move(other)).swap(*this);
    return *this;
  }
  unsigned vertexArray() const { return vertexArray_; }
  int indexCount() const { return indexCount_; }
  PrimitiveKind kind() const { return kind_; }
  std::size_t bytes() const { return vertices_.bytes() + indices_.bytes(); }

 private:
  void swap(Mesh& other) noexcept;
  unsigned vertexArray_ = 0;
  Buffer vertices_, indices_;
  int indexCount_ = 0;
  PrimitiveKind kind_ = PrimitiveKind::Triangles;
};

} // namespace taa::gl
