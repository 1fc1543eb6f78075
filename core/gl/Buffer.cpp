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
  GLuint id = 0;
  glCreateBuffers(1, &id);
  id_ = Handle<ObjectKind::Buffer>(id);
  glNamedBufferStorage(id_, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_STORAGE_BIT);
  labelObject(ObjectKind::Buffer, id_, label);
  checkAllocated(label, what);
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

VertexMesh::VertexMesh(std::span<const std::byte> vertices, std::size_t stride,
                       std::span<const VertexAttribute> attributes, std::span<const std::uint32_t> indices,
                       PrimitiveKind kind, const std::string& label)
    : vertices_(vertices.size(), vertices.data(), label + " vertices"),
      indices_(indices.size_bytes(), indices.data(), label + " indices"),
      indexCount_(static_cast<int>(indices.size())), kind_(kind) {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  vertexArray_ = Handle<ObjectKind::VertexArray>(id);
  labelObject(ObjectKind::VertexArray, vertexArray_, label);
  glVertexArrayVertexBuffer(vertexArray_, 0, vertices_.id(), 0, static_cast<GLsizei>(stride));
  glVertexArrayElementBuffer(vertexArray_, indices_.id());
  for (const VertexAttribute& attribute : attributes) {
    glEnableVertexArrayAttrib(vertexArray_, attribute.location);
    glVertexArrayAttribFormat(vertexArray_, attribute.location, attribute.components, GL_FLOAT, GL_FALSE,
                              static_cast<GLuint>(attribute.offset));
    glVertexArrayAttribBinding(vertexArray_, attribute.location, 0);
  }
}

} // namespace taa::gl
