#include "core/gl/Buffer.h"

#include "core/base/Say.h"
#include "core/gl/Context.h"

#include <epoxy/gl.h>

#include <cassert>

namespace taa::gl {

Buffer::Buffer(std::size_t bytes, const void* data, const std::string& label) : bytes_(bytes) {
  assert(bytes > 0);
  const std::string what = say<"cannot allocate %1 of %2 bytes">(label, bytes);
  allocation_ = Allocation(StorageKind::Buffer, label, bytes, what);
  glCreateBuffers(1, &id_);
  glNamedBufferStorage(id_, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_STORAGE_BIT);
  glObjectLabel(GL_BUFFER, id_, -1, label.c_str());
  try {
    checkErrors(what);
  } catch (...) {
    glDeleteBuffers(1, &id_);
    id_ = 0;
    throw;
  }
}

Buffer::~Buffer() {
  if (id_) glDeleteBuffers(1, &id_);
}

void Buffer::update(std::size_t offset, const void* data, std::size_t bytes) {
  assert(offset + bytes <= bytes_);
  glNamedBufferSubData(id_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

std::vector<std::byte> Buffer::download() const {
  std::vector<std::byte> data(bytes_);
  glGetNamedBufferSubData(id_, 0, static_cast<GLsizeiptr>(bytes_), data.data());
  return data;
}

Mesh::Mesh(std::span<const std::byte> vertices, std::size_t stride,
           std::span<const VertexAttribute> attributes, std::span<const std::uint32_t> indices,
           PrimitiveKind kind, const std::string& label)
    : vertices_(vertices.size(), vertices.data(), label + " vertices"),
      indices_(indices.size_bytes(), indices.data(), label + " indices"),
      indexCount_(static_cast<int>(indices.size())), kind_(kind) {
  glCreateVertexArrays(1, &vertexArray_);
  glObjectLabel(GL_VERTEX_ARRAY, vertexArray_, -1, label.c_str());
  glVertexArrayVertexBuffer(vertexArray_, 0, vertices_.id(), 0, static_cast<GLsizei>(stride));
  glVertexArrayElementBuffer(vertexArray_, indices_.id());
  for (const VertexAttribute& attribute : attributes) {
    glEnableVertexArrayAttrib(vertexArray_, attribute.location);
    glVertexArrayAttribFormat(vertexArray_, attribute.location, attribute.components, GL_FLOAT, GL_FALSE,
                              static_cast<GLuint>(attribute.offset));
    glVertexArrayAttribBinding(vertexArray_, attribute.location, 0);
  }
}

Mesh::~Mesh() {
  if (vertexArray_) glDeleteVertexArrays(1, &vertexArray_);
}

void Mesh::swap(Mesh& other) noexcept {
  std::swap(vertexArray_, other.vertexArray_);
  std::swap(vertices_, other.vertices_);
  std::swap(indices_, other.indices_);
  std::swap(indexCount_, other.indexCount_);
  std::swap(kind_, other.kind_);
}

} // namespace taa::gl
